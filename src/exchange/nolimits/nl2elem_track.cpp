#include "exchange/nolimits/nl2elem_track.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "exchange/nolimits/nl2_corners.h"
#include "sim/fit/fit_track.h"
#include "sim/shape/roll.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

constexpr std::size_t kMaxTold = 20;  // corners with a warning each
constexpr double kRollTold = 0.5;     // degrees from a roll: more is reported
constexpr double kAlongTold = 45;     // degrees of a roll's up from perpendicular to the track: the same

std::string rounded_degrees(double radians) { return fmt::format("{:.3g}", base::degrees(radians)); }

double longest_leg(const Bezier& b) { return std::max(glm::distance(b[0], b[1]), glm::distance(b[2], b[3])); }

// Halves the pieces with a handle over `bound` m; returns false if there is none.
bool halve(std::vector<SplinePiece>& pieces, double bound) {
  std::vector<SplinePiece> halves;
  for (const SplinePiece& piece : pieces)
    if (longest_leg(piece.curve) > bound)
      for (const double from : {0.0, 0.5}) halves.push_back({part(piece.curve, from, from + 0.5), piece.vertex});
    else halves.push_back(piece);
  const bool changed = halves.size() > pieces.size();
  pieces = std::move(halves);
  return changed;
}

// Returns the curves between knots, corners rounded. Sets the error, or adds the warnings.
std::vector<Bezier> curves_of(const ElementFile& file, ElementTrack& out) {
  std::vector<SplinePiece> pieces = spline_pieces(file.vertices);
  std::erase_if(pieces, [](const SplinePiece& piece) {  // between vertices at one place
    return start_direction(piece.curve) == dvec3(0) || end_direction(piece.curve) == dvec3(0);
  });
  if (pieces.empty()) {
    out.error = {0, "vertices at different places", "all at one"};
    return {};
  }
  for (const SplinePiece& piece : pieces) out.report.max_error = std::max(out.report.max_error, piece.off);
  if (const auto fold = find_fold(pieces, file.closed)) {
    out.error = {fold->vertex, fmt::format("turns of at most {} degrees within {} cm", kSharpest, 200 * kCornerOff),
                 fmt::format("one of {:.6g} degrees near vertex {}", base::degrees(fold->angle), fold->vertex + 1)};
    return {};
  }
  std::vector<Corner> corners;
  pieces = round_corners(pieces, file.closed, corners);
  for (const Corner& corner : corners) {
    if (corner.angle > base::radians(kSharpest) + 1e-6) {
      out.error = {corner.vertex, fmt::format("corners of at most {} degrees", kSharpest),
                   fmt::format("one of {:.6g} degrees at vertex {}", base::degrees(corner.angle), corner.vertex + 1)};
      return {};
    }
    out.report.max_error = std::max(out.report.max_error, corner.off);
    if (out.warnings.size() < kMaxTold)
      out.warnings.emplace_back(corner.vertex,
                                fmt::format("the corner of {} degrees at vertex {} was rounded, up to {:.1f} mm off",
                                            rounded_degrees(corner.angle), corner.vertex + 1, 1000 * corner.off));
  }
  if (corners.size() > kMaxTold)
    out.warnings.emplace_back(corners[kMaxTold].vertex,
                              fmt::format("{} more corners were rounded", corners.size() - kMaxTold));
  if (file.closed && pieces.size() < 2) halve(pieces, 0);  // a closed track has two knots
  while (halve(pieces, world::kMaxHandle)) {
  }
  std::vector<Bezier> curves;
  for (const SplinePiece& piece : pieces) curves.push_back(piece.curve);
  return curves;
}

world::Knot knot_of(dvec3 position, dvec3 direction, double in, double out) {
  world::Knot knot;
  knot.position = glm::vec3(position);
  knot.tangent = glm::vec3(glm::normalize(direction));
  const auto handle = [](double m) { return std::clamp(static_cast<float>(m), world::kMinHandle, world::kMaxHandle); };
  knot.in_length = handle(in), knot.out_length = handle(out);
  knot.joint = knot.in_length == knot.out_length ? world::JointKind::smooth : world::JointKind::aligned;
  world::orthonormalise(knot);
  return knot;
}

std::size_t short_handles(const std::vector<Bezier>& segments) {
  std::size_t count = 0;
  for (const Bezier& b : segments)
    for (const double leg : {glm::distance(b[0], b[1]), glm::distance(b[2], b[3])})
      if (static_cast<float>(leg) < world::kMinHandle) ++count;
  return count;
}

void append_knots(const std::vector<Bezier>& segments, const std::vector<Stop>& stops, bool closed,
                  world::Document& document) {
  for (std::size_t i = 0; i < segments.size() + (closed ? 0 : 1); ++i) {
    const Bezier& after = segments[std::min(i, segments.size() - 1)];
    const Bezier& before = i > 0 ? segments[i - 1] : closed ? segments.back() : after;
    const bool first = i == 0 && !closed, last = i == segments.size();
    const dvec3 comes = first ? start_direction(after) : end_direction(before),
                goes = last ? comes : start_direction(after);
    const double out = glm::distance(after[0], after[1]), in = glm::distance(before[2], before[3]);
    world::Knot knot = knot_of(last ? after[3] : after[0], comes + goes, first ? out : in, last ? in : out);
    if (stops[i].up) knot.up = glm::vec3(curve::perpendicular(dvec3(knot.tangent), *stops[i].up));
    else world::set_roll(knot, 0);
    if (std::abs(stops[i].spin) >= sim::kLeastSpin)
      knot.spin = static_cast<float>(std::clamp<double>(stops[i].spin, -world::kMaxSpin, world::kMaxSpin));
    world::orthonormalise(knot);
    world::append_knot(document, knot);
  }
  if (closed) world::set_closed(document, true);
}

// Adds the whole turns that the smallest twist between the knots' `up` omits.
void set_turns(const std::vector<Stop>& stops, world::Document& document) {
  const sim::Derived derived = sim::shapes_of(document);
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const double wanted = stops[i + 1].angle - stops[i].angle;
    const double turns = std::round((wanted - derived.shape(derived.order[i]).roll.twist) / (2 * base::kPi));
    document.entities.get<world::Segment>(derived.order[i]).turns =
        std::clamp(static_cast<std::int32_t>(turns), -world::kMaxTurns, world::kMaxTurns);
  }
}

// The roll whose up is furthest from perpendicular to the track, which says little about the track's roll.
struct RollAlong {
  double coord = 0, degrees = 0;
};

RollAlong measure(const world::Document& document, const std::vector<Bezier>& segments, const ElementFile& file,
                  ImportReport& report) {
  report.knots = static_cast<int>(document.track.knots.size());
  const sim::Derived derived = sim::shapes_of(document);
  sim::MeanSquare distances, angles;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (int k = 0; k <= 16; ++k) {
      const dvec3 here = curve::point(derived.shape(derived.order[i]).key.cubic, k / 16.0);
      const double distance = glm::distance(point(segments[i], k / 16.0), here);
      report.max_error = std::max(report.max_error, distance);
      distances.add(distance);
    }
  RollAlong along;
  for (const ElementRoll& roll : file.rolls) {
    const double fraction = std::min(roll.coord, derived.closed ? 1 - 1e-12 : 1.0);
    const curve::Frame frame = place_on(derived, fraction * derived.length).frame;
    const dvec3 wanted = curve::perpendicular(frame.forward, roll.up);
    const double angle = base::degrees(std::abs(curve::signed_angle(frame.up, wanted, frame.forward)));
    report.frame_error = std::max(report.frame_error, angle);
    angles.add(angle);
    const double sine = glm::dot(frame.forward, roll.up), cosine = glm::length(glm::cross(frame.forward, roll.up));
    if (const double off = base::degrees(base::arc_tangent(std::abs(sine), cosine)); off > along.degrees)
      along = {roll.coord, off};
  }
  report.rms_error = distances.root(), report.rms_frame_error = angles.root();
  return along;
}

}  // namespace

ElementTrack track_of(const ElementFile& file) {
  ElementTrack out;
  const std::vector<Bezier> curves = curves_of(file, out);
  if (out.error) return out;
  const std::vector<Stop> stops = stops_of(curves, file.closed, file.rolls);
  if (stops.size() > world::kMaxKnots) {
    out.error = {0, fmt::format("vertices and rolls for at most {} knots", world::kMaxKnots),
                 std::to_string(stops.size())};
    return out;
  }
  std::vector<Bezier> segments;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
    segments.push_back(
        part(curves[stops[i].piece], stops[i].t, stops[i + 1].piece == stops[i].piece ? stops[i + 1].t : 1));
  if (const std::size_t count = short_handles(segments); count > 0)
    out.warnings.emplace_back(
        0, fmt::format("{} handles shorter than {} m were lengthened to it", count, base::to_text(world::kMinHandle)));
  append_knots(segments, stops, file.closed, out.document);
  if (!file.rolls.empty()) set_turns(stops, out.document);
  else sim::set_automatic_spins(out.document);
  world::add_cart(out.document, out.document.track.segments[0], 0);
  const RollAlong along = measure(out.document, segments, file, out.report);
  if (out.report.frame_error > kRollTold)
    out.warnings.emplace_back(0, fmt::format("the track is up to {} degrees off the file's rolls",
                                             rounded_degrees(base::radians(out.report.frame_error))));
  if (along.degrees > kAlongTold)
    out.warnings.emplace_back(
        0, fmt::format("the up of the roll at coord {:.4g} is {:.0f} degrees off perpendicular to the track there",
                       along.coord, along.degrees));
  return out;
}

}  // namespace coaster::exchange
