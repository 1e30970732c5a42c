#include "exchange/fvd/fvd.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "base/utf8.h"
#include "curve/frames.h"
#include "exchange/fvd/fvd_path.h"
#include "sim/plan/elements.h"
#include "sim/plan/force_plan.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace {

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
  program.over = section.by_distance ? world::ForceOver::distance : world::ForceOver::time;
  program.length = std::round(path.at.back() * 1e6) / 1e6;
  const double gap = world::key_gap_of(program.over);
  const auto keys = [&](ForceChannel channel, const FvdFunction& function, double tolerance, const auto& f) {
    program.keys(channel) =
        keys_along(f, corners_of(function), program.length, tolerance, gap, base::row_of(channel).limit);
  };
  const auto values = [](const FvdFunction& function) {
    return [&function](double x) { return value_of(piece_at(function, x), x); };
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
  const world::ForceOver over = section.by_distance ? world::ForceOver::distance : world::ForceOver::time;
  const bool fits = path.at.back() >= world::shortest_of(over) && path.at.back() <= world::longest_of(over);
  const bool forces = section.kind == FvdKind::forced && section.free_speed && fits;
  // With a heartline the train there moves on the rails, here on the hearts: the same forces shape other track.
  if (forces && import.track.heart == 0) return add_forced(import, section, path);
  import.on_rails |= forces;
  return add_shaped(import, section, path);
}

}  // namespace

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
