// Reads a project of openFVD, in which numbers are big-endian and a vector is written as z, y, x, and makes a document
// of it.
#include "exchange/fvd/fvd.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "curve/frames.h"
#include "sim/plan/element_plan.h"
#include "sim/plan/force_plan.h"
#include "world/components.h"
#include "world/topology.h"

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

using glm::dvec3;
using world::ForceChannel;
constexpr double kShortestSection = 0.05;                   // m: shorter ones are left out
constexpr double kKeyTolerance = 0.01, kRollTolerance = 1;  // g, deg/s
constexpr double kFaster = 0.5;                             // m/s

// The sections placed so far and their kinds.
struct FvdImport {
  const FvdTrack& track;
  LoadedTrack loaded;
  double speed = 0;  // m/s at the open end
  int forced = 0, shaped = 0, short_ones = 0;
  bool on_rails = false;  // forced sections kept their shape instead of their forces
};

// Returns the first knot. openFVD starts towards -Z; pitch turns up, yaw and roll to the left.
world::Knot first_knot(const FvdTrack& track) {
  const base::SinCos pitch = base::sin_cos(base::radians(track.pitch)), yaw = base::sin_cos(base::radians(track.yaw));
  world::Knot knot;
  knot.position = glm::vec3(track.position);
  const dvec3 heading(-yaw.sin, 0, -yaw.cos);
  const dvec3 forward = pitch.cos * heading + dvec3(0, pitch.sin, 0),
              up = pitch.cos * dvec3(0, 1, 0) - pitch.sin * heading;
  knot.tangent = glm::vec3(forward);
  knot.up = glm::vec3(curve::rotate(up, forward, -base::radians(track.roll)));
  knot.joint = world::JointKind::aligned;
  world::orthonormalise(knot);
  return knot;
}

void append(world::Document& document, const std::vector<world::Knot>& knots, world::Section section) {
  world::Knot& last = document.entities.get<world::Knot>(document.track.knots.back());
  last.joint = world::JointKind::aligned, last.out_length = knots.front().out_length;
  if (document.track.segments.empty()) last.spin = knots.front().spin;
  for (std::size_t k = 1; k < knots.size(); ++k) world::append_knot(document, knots[k]);
  world::make_section(document, document.track.segments.size() - (knots.size() - 1), knots.size() - 1,
                      std::move(section));
}

std::vector<double> corners_of(const FvdFunction& function) {
  std::vector<double> corners;
  for (const FvdPiece& piece : function) corners.push_back(piece.from);
  return corners;
}

world::ForceProgram program_of(const FvdSection& section, const FvdPath& path) {
  world::ForceProgram program;
  program.over = section.by_distance ? world::ForceDomain::distance : world::ForceDomain::time;
  program.length = std::round(path.at.back() * 1e6) / 1e6;
  const double gap = world::key_gap_of(program.over);
  const auto keys = [&](ForceChannel channel, const FvdFunction& function, double tolerance, const auto& f) {
    program.keys(channel) =
        keys_along(f, corners_of(function), program.length, tolerance, gap, base::row_of(channel).limit);
  };
  const auto values = [](const FvdFunction& function) {
    return [&function](double x) { return value_at(function, x); };
  };
  keys(ForceChannel::vertical, section.vertical, kKeyTolerance, values(section.vertical));
  keys(ForceChannel::lateral, section.lateral, kKeyTolerance, values(section.lateral));
  const auto twist = [&](double x) {
    const auto above = std::ranges::upper_bound(path.at, std::clamp(x, path.at.front(), path.at.back()));
    const std::size_t i = std::clamp<std::ptrdiff_t>(above - path.at.begin(), 1, std::ssize(path.at) - 1);
    const double share = (x - path.at[i - 1]) / std::max(path.at[i] - path.at[i - 1], 1e-9);
    return path.twist[i - 1] + std::clamp(share, 0.0, 1.0) * (path.twist[i] - path.twist[i - 1]);
  };
  keys(ForceChannel::roll, section.roll, section.by_distance ? kRollTolerance / path.speed : kRollTolerance, twist);
  return program;
}

// Adds a force section, or returns why there is none.
std::string add_forced(FvdImport& import, const FvdSection& section, const FvdPath& path) {
  world::Document& document = import.loaded.document;
  world::ForceProgram program = program_of(section, path);
  program.speed = import.speed;
  const sim::ForcePlan plan = sim::plan_force(sim::force_task(document, *sim::open_end(document), program));
  if (!plan.refusal.empty()) return plan.refusal;
  append(document, plan.fit.spans.knots, {section.name, world::SectionKind::force, {}, {}, plan.task.program});
  import.speed = plan.end_speed, ++import.forced;
  return sim::stop_text(plan);
}

std::string add_shaped(FvdImport& import, const FvdSection& section, FvdPath& path) {
  world::Document& document = import.loaded.document;
  sim::merge_short_pieces(path.curve);
  const std::size_t before = document.track.segments.size();
  append(document, sim::fit_element(path.curve).knots, {section.name});
  if (!section.free_speed) {
    world::Equipment equipment;
    equipment.kind = import.speed > section.speed + kFaster ? world::EquipmentKind::brake : world::EquipmentKind::lift;
    equipment.speed = static_cast<float>(std::min(section.speed, world::kMaxSpeed));
    for (std::size_t i = before; i < document.track.segments.size(); ++i)
      document.entities.put(document.track.segments[i], equipment);
  }
  import.speed = path.speed, ++import.shaped;
  return path.stopped;
}

std::string add(FvdImport& import, FvdSection section) {
  const std::optional<sim::TrackEnd> end = sim::open_end(import.loaded.document);
  FvdPath path = fvd_path(import.track, section, {end->position, end->forward, end->up, import.speed});
  if (path.curve.points.size() < 2) return path.stopped;
  if (path.curve.length() < kShortestSection) {
    ++import.short_ones;
    return path.stopped;
  }
  section.name = std::string(base::utf8_start(section.name, world::kMaxNameBytes));
  const world::ForceDomain over = section.by_distance ? world::ForceDomain::distance : world::ForceDomain::time;
  const bool fits = path.at.back() >= world::shortest_of(over) && path.at.back() <= world::longest_of(over);
  const bool forces = section.kind == FvdKind::forced && section.free_speed && fits;
  // With a heartline the train there moves on the rails, here on the hearts: the same forces shape other track.
  if (forces && import.track.heart == 0) return add_forced(import, section, path);
  import.on_rails |= forces;
  return add_shaped(import, section, path);
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

base::Result<LoadedTrack> parse_fvd(std::string_view bytes, std::string_view name) {
  const base::Result<FvdTrack> track = read_fvd(bytes, name);
  if (!track) return track.status();
  FvdImport import{*track, {}, std::abs(track->speed)};
  world::Document& document = import.loaded.document;
  const std::string title(base::utf8_start(track->name, world::kMaxNameBytes));
  document.name = title.empty() ? name_of_file(name) : title;
  document.curve = world::TrackCurve::heartline, document.heartline = track->heart;
  document.start_speed = std::min(import.speed, world::kMaxSpeed);
  document.resistance = {static_cast<float>(track->friction), static_cast<float>(track->resistance)};
  import.loaded.knows_speed = true;
  import.loaded.reshaped = track->heart != 0;
  world::append_knot(document, first_knot(*track));
  const auto warn = [&](const std::string& text) {
    import.loaded.warnings.push_back(fmt::format("{}: warning: {}", name, text));
  };
  const std::size_t count = track->sections.size();
  std::string end = fmt::format("track 1 ({}) has no section{}", track->name,
                                count > 0 ? fmt::format(" of {} m or more", kShortestSection) : "");
  for (std::size_t i = 0; i < count; ++i) {
    const world::Document before = document;
    std::string stopped = add(import, track->sections[i]);
    if (const auto broken = world::broken_invariant(document)) document = before, stopped = *broken;
    if (stopped.empty()) continue;
    end = fmt::format("section {} of {} ({}): {}", i + 1, count, track->sections[i].name, stopped);
    warn(end + "; the track ends there");
    break;
  }
  if (document.track.segments.empty())
    return base::Status{base::Code::bad_file, fmt::format("{}: error: {}", name, end)};
  if (import.short_ones > 0)
    warn(fmt::format("sections shorter than {} m were left out: {}", kShortestSection, import.short_ones));
  if (track->others > 0) warn(fmt::format("only the first of the {} tracks is read", track->others + 1));
  import.loaded.note = fmt::format("Opened {} force section{} and {} hand-shaped one{}.", import.forced,
                                   import.forced == 1 ? "" : "s", import.shaped, import.shaped == 1 ? "" : "s");
  if (import.on_rails)
    import.loaded.note +=
        " Forced sections keep their shape: with a heartline openFVD moves the train on the rails. "
        "Read forces makes force sections of them.";
  return std::move(import.loaded);
}

}  // namespace coaster::exchange
