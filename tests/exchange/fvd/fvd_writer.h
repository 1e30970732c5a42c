// Writes projects of openFVD, by the layout in docs/forces.md.
#pragma once

#include <bit>
#include <string>
#include <vector>

#include "exchange/fvd/fvd.h"

namespace coaster::test {

class FvdWriter {
 public:
  std::string bytes = "FVD";

  explicit FvdWriter(const std::string& version = "v0.77") {
    bytes += version;
    text(":/background.png");
  }
  void whole(std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  }
  void number(double value) { whole(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  void flag(bool value) { bytes += static_cast<char>(value); }
  void text(const std::string& value) { whole(static_cast<std::uint32_t>(value.size())), bytes += value; }

  void function(const exchange::FvdFunction& pieces) {
    bytes += "FUNC";
    whole(static_cast<std::uint32_t>(pieces.size()));
    for (const exchange::FvdPiece& p : pieces) {
      whole(static_cast<std::uint32_t>(p.shape));
      for (const double v : {p.from, p.to, p.start, p.form, p.change, p.centre, p.tension}) number(v);
      flag(p.follows);
    }
  }
  void section(const exchange::FvdSection& s) {
    static constexpr const char* kTags[] = {"STR", "CUR", "FRC", "GEO", "BEZ"};
    bytes += kTags[static_cast<int>(s.kind)];
    if (s.kind == exchange::FvdKind::bezier) {
      text(s.name), whole(1), bytes.append(42, '\0'), whole(1), bytes.append(12, '\0');
      return;
    }
    flag(s.free_speed), text(s.name), number(s.speed);
    if (s.kind == exchange::FvdKind::straight) {
      number(s.roll.back().to), function(s.roll);
    } else if (s.kind == exchange::FvdKind::curved) {
      for (const double v : {s.angle, s.radius, s.direction, s.lead_in, s.lead_out}) number(v);
      flag(s.upright), function(s.roll);
    } else {
      whole(1000), flag(s.upright), flag(s.by_distance);
      function(s.roll), function(s.vertical), function(s.lateral);
    }
  }
  void track(const exchange::FvdTrack& t) {
    bytes += "TRC";
    text(t.name), bytes.append(48, '\7');
    for (const double v : {t.position.z, t.position.y, t.position.x, t.roll, t.pitch, t.yaw, t.speed, 1.0, 0.0, t.heart,
                           t.friction, t.resistance})
      number(v);
    flag(true), whole(0), whole(0), flag(false), number(0), number(0);
    whole(static_cast<std::uint32_t>(t.sections.size()));
    for (const exchange::FvdSection& s : t.sections) section(s);
    whole(1), text("all"), whole(0), whole(9), whole(3), whole(2), flag(true);
    bytes += "EOT";
  }
  std::string done() const { return bytes + "EOP"; }
};

inline std::string fvd_of(const exchange::FvdTrack& track) {
  FvdWriter writer;
  writer.track(track);
  return writer.done();
}

}  // namespace coaster::test
