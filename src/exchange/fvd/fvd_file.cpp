// Reads a project of openFVD. Numbers are big-endian; a vector is written as z, y, x.
#include "exchange/fvd/fvd_file.h"

#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "base/utf8.h"
#include "world/components.h"

namespace coaster::exchange {
namespace {

constexpr std::size_t kColours = 48;      // three colours of 16 bytes
constexpr std::size_t kBezierPoint = 42;  // three vectors, two flags, roll
constexpr std::size_t kVector = 12;
constexpr double kMost = 1e6;  // of any number

// Keeps the first error; everything read after it is 0.
class FvdReader {
 public:
  FvdReader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  const base::Status& fault() const { return fault_; }
  bool good() const { return fault_.ok(); }
  std::size_t place() const { return at_; }
  void fail(std::size_t at, const std::string& message) {
    if (good()) fault_ = {base::Code::bad_file, fmt::format("{}: error: at byte {}: {}", name_, at, message)};
  }

  std::string_view take(std::size_t count, std::string_view what) {
    if (!good()) return {};
    if (bytes_.size() - at_ < count) {
      fail(at_, fmt::format("expected {}, found the end of the file", what));
      return {};
    }
    at_ += count;
    return bytes_.substr(at_ - count, count);
  }
  std::uint32_t whole(std::string_view what) {
    std::uint32_t value = 0;
    for (const char byte : take(4, what)) value = value << 8 | static_cast<unsigned char>(byte);
    return value;
  }
  double number(std::string_view what, double low = -kMost, double high = kMost) {
    const float value = std::bit_cast<float>(whole(what));
    if (value >= low && value <= high) return value;
    fail(at_ - 4, fmt::format("expected {} from {} to {}, found {}", what, low, high,
                              std::isfinite(value) ? base::to_text(value) : "no finite number"));
    return 0;
  }
  bool flag(std::string_view what) {
    const std::string_view byte = take(1, what);
    return !byte.empty() && byte.front() != 0;
  }
  glm::dvec3 vector(std::string_view what) {
    glm::dvec3 v(0);
    for (const int axis : {2, 1, 0}) v[axis] = number(what, -world::kMaxCoordinate, world::kMaxCoordinate);
    return v;
  }
  std::size_t count(std::string_view what, std::size_t most) {
    const std::uint32_t value = whole(what);
    if (good() && value > most) fail(at_ - 4, fmt::format("expected at most {} {}, found {}", most, what, value));
    return good() ? value : 0;
  }
  std::string text(std::string_view what) {
    return base::printable_utf8(std::string(take(count(what, bytes_.size()), what)));
  }

 private:
  std::string_view bytes_, name_;
  std::size_t at_ = 0;
  base::Status fault_;
};

FvdPiece read_piece(FvdReader& reader) {
  FvdPiece piece;
  const std::size_t at = reader.place(), shape = reader.whole("the shape of a piece");
  if (shape > static_cast<std::size_t>(FvdShape::free_form))
    reader.fail(at, fmt::format("expected a shape from 0 to 8, found {}", shape));
  else piece.shape = static_cast<FvdShape>(shape);
  piece.from = reader.number("the start of a piece"), piece.to = reader.number("the end of a piece");
  piece.start = reader.number("the value of a piece");
  // Only shapes with a form set it.
  const float form = std::bit_cast<float>(reader.whole("the form of a piece"));
  piece.form = std::abs(form) <= kMost ? form : 0;
  piece.change = reader.number("the change of a piece");
  piece.centre = reader.number("the centre of a piece", -50, 50);
  piece.tension = reader.number("the tension of a piece", -50, 50);
  piece.follows = reader.flag("a lock");
  if (reader.good() && !(piece.to >= piece.from))
    reader.fail(at, fmt::format("a piece ends at {}, before its start at {}", piece.to, piece.from));
  return piece;
}

FvdFunction read_function(FvdReader& reader) {
  const std::size_t at = reader.place();
  if (reader.take(4, "FUNC") != "FUNC") reader.fail(at, "expected FUNC");
  FvdFunction function(reader.count("pieces", kMostFvdPieces));
  if (reader.good() && function.empty()) reader.fail(at, "expected a function of at least one piece");
  for (FvdPiece& piece : function) piece = read_piece(reader);
  for (std::size_t i = 1; i < function.size() && reader.good(); ++i)
    if (function[i].from < function[i - 1].from) reader.fail(at, "the pieces of a function do not ascend");
  return function;
}

FvdSection read_section(FvdReader& reader, bool older) {
  FvdSection section;
  const std::size_t at = reader.place();
  const std::string_view tag = reader.take(3, "a section");
  constexpr std::string_view kTags[] = {"STR", "CUR", "FRC", "GEO", "BEZ"};
  std::size_t kind = 0;
  while (kind < std::size(kTags) && kTags[kind] != tag) ++kind;
  if (kind == std::size(kTags)) {
    reader.fail(at, fmt::format("expected a section STR, CUR, FRC, GEO or BEZ, found {}",
                                base::quoted_start(base::printable_utf8(std::string(tag)))));
    return section;
  }
  section.kind = static_cast<FvdKind>(kind);
  const bool forced = section.kind == FvdKind::forced || section.kind == FvdKind::geometric;
  if (section.kind != FvdKind::bezier) section.free_speed = reader.flag("whether speed is kept");
  section.name = reader.text("the name of a section");
  if (section.kind == FvdKind::bezier) {
    reader.take(reader.count("points", 1'000'000) * kBezierPoint, "the points of a section");
    reader.take(reader.count("supports", 1'000'000) * kVector, "the supports of a section");
    return section;
  }
  if (forced && older) section.free_speed = true;
  else section.speed = reader.number("a speed", -1000, 1000);
  switch (section.kind) {
    case FvdKind::straight: reader.number("a length"); break;  // the roll's function has it
    case FvdKind::curved:
      section.angle = reader.number("an angle"), section.radius = reader.number("a radius");
      section.direction = reader.number("a direction");
      section.lead_in = reader.number("a lead-in"), section.lead_out = reader.number("a lead-out");
      section.upright = reader.flag("how roll counts");
      break;
    default:
      reader.whole("a time");
      section.upright = reader.flag("how roll counts"), section.by_distance = reader.flag("what functions count in");
  }
  section.roll = read_function(reader);
  if (forced) section.vertical = read_function(reader), section.lateral = read_function(reader);
  return section;
}

FvdTrack read_track(FvdReader& reader, bool older) {
  FvdTrack track;
  track.name = reader.text("the name of a track");
  reader.take(kColours, "the colours");
  track.position = reader.vector("the start");
  track.roll = reader.number("the roll"), track.pitch = reader.number("the pitch"),
  track.yaw = reader.number("the yaw");
  track.speed = reader.number("the start speed", -1000, 1000);
  reader.number("the vertical g"), reader.number("the lateral g");
  track.heart = reader.number("the heartline", -world::kMaxHeartline, world::kMaxHeartline);
  track.friction = reader.number("the friction", 0, world::kMaxRolling);
  track.resistance = reader.number("the resistance", 0, world::kMaxDrag);
  reader.take(1 + 4 + 4 + 1 + 4 + 4, "the look of a track");
  track.sections.resize(reader.count("sections", kMostFvdSections));
  for (FvdSection& section : track.sections)
    if (reader.good()) section = read_section(reader, older);
  for (std::size_t left = reader.count("smoothings", 10'000); left > 0 && reader.good(); --left)
    reader.text("the name of a smoothing"), reader.take(4 * 4 + 1, "a smoothing");
  const std::size_t at = reader.place();
  if (reader.take(3, "the track's end") != "EOT") reader.fail(at, "expected EOT at the track's end");
  return track;
}

}  // namespace

base::Result<FvdTrack> read_fvd(std::string_view bytes, std::string_view name) {
  FvdReader reader(bytes, name);
  if (reader.take(3, "FVD") != "FVD") reader.fail(0, "expected a project of openFVD, which begins with FVD");
  const std::string_view version = reader.take(5, "the version");
  if (version != "v0.77" && version != "v0.30")
    reader.fail(3, fmt::format("expected version v0.77 or v0.30, found {}",
                               base::quoted_start(base::printable_utf8(std::string(version)))));
  reader.text("the ground's picture");
  std::vector<FvdTrack> tracks;
  for (;;) {
    const std::size_t at = reader.place();
    const std::string_view tag = reader.take(3, "a track or the project's end");
    if (!reader.good() || tag == "EOP") break;
    if (tag != "TRC") reader.fail(at, "expected TRC or EOP");
    FvdTrack track = read_track(reader, version == "v0.30");
    if (tracks.empty()) tracks.push_back(std::move(track));
    else ++tracks.front().others;
  }
  if (tracks.empty()) reader.fail(reader.place(), "the project has no track");
  if (!reader.good()) return reader.fault();
  return std::move(tracks.front());
}

}  // namespace coaster::exchange
