#include "exchange/nolimits/nl2elem_track.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;
using Controls = std::array<dvec3, 4>;

constexpr double kNoDirection = 1e-4;  // m: shorter differences of control vertices tell no direction
constexpr double kSnap =
    0.03;  // m: a roll this near to a knot belongs to it, since shorter segments would have handles too short
constexpr int kFrameSteps = 32;  // of a piece, as derived frames have

dvec3 at(const Controls& c, double t) {
  const double u = 1 - t;
  return u * u * u * c[0] + 3 * u * u * t * c[1] + 3 * u * t * t * c[2] + t * t * t * c[3];
}
dvec3 slope(const Controls& c, double t) {
  const double u = 1 - t;
  return 3 * u * u * (c[1] - c[0]) + 6 * u * t * (c[2] - c[1]) + 3 * t * t * (c[3] - c[2]);
}

// A piece of a span between two knots, and the roll of its first knot.
struct Piece {
  Controls span;
  double from = 0, to = 1;
  double start = 0, length = 0;  // m along the track
  std::optional<dvec3> up;
};

struct Cut {
  double t = 0;
  std::optional<dvec3> up;
};

// Returns the pieces between knots; `end_up`: the roll of an open track's last knot.
std::vector<Piece> pieces_of(const UniformSpline& spline, const ElementFile& file, std::optional<dvec3>& end_up) {
  std::vector<curve::ArcLengthMap> arcs;
  std::vector<double> starts{0};
  for (std::size_t i = 0; i < spline.spans(); ++i) {
    arcs.emplace_back(in_float(spline.span(i)));
    starts.push_back(starts.back() + arcs.back().length());
  }
  std::vector<std::vector<Cut>> cuts(spline.spans() + 1);
  for (auto& of_span : cuts) of_span.push_back({});
  std::vector<ElementRoll> rolls = file.rolls;
  std::stable_sort(rolls.begin(), rolls.end(),
                   [](const ElementRoll& a, const ElementRoll& b) { return a.coord < b.coord; });
  for (const ElementRoll& roll : rolls) {
    const double s = roll.coord * starts.back();
    const auto above = std::upper_bound(starts.begin() + 1, starts.end() - 1, s);
    const auto span = static_cast<std::size_t>(above - starts.begin()) - 1;
    const double within = std::clamp(s - starts[span], 0.0, arcs[span].length());
    std::vector<Cut>& of_span = cuts[span];
    if (arcs[span].length() - within < kSnap) cuts[span + 1].front().up = roll.up;
    else if (within - arcs[span].distance(of_span.back().t) < kSnap) of_span.back().up = roll.up;
    else of_span.push_back({arcs[span].parameter(within), roll.up});
  }
  end_up = cuts.back().front().up;
  if (file.closed && end_up && !cuts.front().front().up) cuts.front().front().up = end_up;
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < spline.spans(); ++i)
    for (std::size_t k = 0; k < cuts[i].size(); ++k) {
      const double from = cuts[i][k].t, to = k + 1 < cuts[i].size() ? cuts[i][k + 1].t : 1.0;
      const double before = arcs[i].distance(from), after = to == 1 ? arcs[i].length() : arcs[i].distance(to);
      pieces.push_back({spline.span(i), from, to, starts[i] + before, after - before, cuts[i][k].up});
    }
  return pieces;
}

curve::Frame transported(curve::Frame frame, const Piece& piece) {
  dvec3 last = at(piece.span, piece.from);
  for (int k = 1; k <= kFrameSteps; ++k) {
    const double t = piece.from + (piece.to - piece.from) * k / kFrameSteps;
    const dvec3 here = at(piece.span, t), d = slope(piece.span, t);
    const dvec3 tangent = glm::dot(d, d) > 0 ? glm::normalize(d) : frame.forward;
    frame = curve::transport(frame, last, here, tangent);
    last = here;
  }
  return frame;
}

// Returns the up of each knot: between rolls the angle to the rotation-minimising frame is linear; before the first and
// after the last roll of an open track it is constant.
std::vector<dvec3> ups_of(const std::vector<Piece>& pieces, const std::optional<dvec3>& end_up, bool closed) {
  std::vector<curve::Frame> frames;
  const dvec3 first = glm::normalize(slope(pieces[0].span, 0));
  frames.push_back({first, curve::perpendicular(first, {0, 1, 0})});
  for (const Piece& piece : pieces) frames.push_back(transported(frames.back(), piece));
  struct Angle {
    double s, value;
  };
  std::vector<Angle> angles;
  const auto add = [&](double s, double value) {
    if (!angles.empty()) value += 2 * base::kPi * std::round((angles.back().value - value) / (2 * base::kPi));
    angles.push_back({s, value});
  };
  const auto angle_of = [&](std::size_t i, dvec3 up) {
    return curve::signed_angle(frames[i].up, curve::perpendicular(frames[i].forward, up), frames[i].forward);
  };
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces[i].up) add(pieces[i].start, angle_of(i, *pieces[i].up));
  const double length = pieces.back().start + pieces.back().length;
  if (!closed && end_up) add(length, angle_of(pieces.size(), *end_up));
  if (closed && !angles.empty()) {
    // After a lap the carried frame has rotated; the first roll is the same.
    const Angle again = angles.front(), last = angles.back();
    const double lap = curve::signed_angle(frames.back().up, frames.front().up, frames.front().forward);
    add(length + again.s, again.value + lap);
    const double before = angles.back().value - last.value;  // and the last roll a lap before the first
    angles.insert(angles.begin(), {last.s - length, again.value - before});
  }
  std::vector<dvec3> ups;
  std::size_t next = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double s = i < pieces.size() ? pieces[i].start : length;
    while (next < angles.size() && angles[next].s <= s) ++next;
    double angle = 0;
    if (next == 0) angle = angles.front().value;
    else if (next == angles.size()) angle = angles.back().value;
    else
      angle = angles[next - 1].value + (angles[next].value - angles[next - 1].value) * (s - angles[next - 1].s) /
                                           (angles[next].s - angles[next - 1].s);
    ups.push_back(curve::rotate(frames[i].up, frames[i].forward, angle));
  }
  return ups;
}

world::Knot knot_of(const std::vector<Piece>& pieces, std::size_t i, bool closed) {
  const Piece& after = pieces[std::min(i, pieces.size() - 1)];
  const Piece& before = i > 0 ? pieces[i - 1] : closed ? pieces.back() : after;
  const double t = i < pieces.size() ? after.from : after.to;
  const dvec3 d = slope(after.span, t);
  world::Knot knot;
  knot.position = glm::vec3(at(after.span, t));
  knot.tangent = glm::vec3(glm::normalize(d));
  const auto handle = [&](const Piece& piece) {
    return std::clamp(static_cast<float>(glm::length(d) * (piece.to - piece.from) / 3), world::kMinHandle,
                      world::kMaxHandle);
  };
  knot.in_length = handle(before), knot.out_length = handle(after);
  knot.joint = knot.in_length == knot.out_length ? world::JointKind::smooth : world::JointKind::aligned;
  return knot;
}

ImportReport report_of(const world::Document& document, const std::vector<Piece>& pieces, const ElementFile& file) {
  ImportReport report;
  report.knots = static_cast<int>(document.track.knots.size());
  const sim::Derived derived = sim::shapes_of(document);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (int k = 0; k <= 16; ++k) {
      const Piece& piece = pieces[i];
      const dvec3 wanted = at(piece.span, piece.from + (piece.to - piece.from) * k / 16);
      report.max_error = std::max(
          report.max_error, glm::distance(wanted, curve::point(derived.shape(derived.order[i]).key.cubic, k / 16.0)));
    }
  for (const ElementRoll& roll : file.rolls) {
    const double fraction = std::min(roll.coord, derived.closed ? 1 - 1e-12 : 1.0);
    const curve::Frame frame = place_on(derived, fraction * derived.length).frame;
    const dvec3 wanted = curve::perpendicular(frame.forward, roll.up);
    report.frame_error =
        std::max(report.frame_error, base::degrees(std::abs(curve::signed_angle(frame.up, wanted, frame.forward))));
  }
  return report;
}

}  // namespace

ElementTrack track_of(const ElementFile& file) {
  ElementTrack out;
  const UniformSpline spline(file.vertices, file.closed);
  for (std::size_t i = 0; i < file.vertices.size(); ++i) {
    const Controls c = spline.span(std::min(i, spline.spans() - 1));
    const bool last = i == spline.spans();
    const dvec3 leg = last ? c[3] - c[2] : c[1] - c[0], place = last ? c[3] : c[0];
    const double farthest = std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)});
    if (!(glm::length(leg) > kNoDirection) || !(farthest <= world::kMaxCoordinate)) {
      out.pathless = i;
      return out;
    }
  }
  std::optional<dvec3> end_up;
  const std::vector<Piece> pieces = pieces_of(spline, file, end_up);
  const bool rolled = !file.rolls.empty();
  const std::vector<dvec3> ups = rolled ? ups_of(pieces, end_up, file.closed) : std::vector<dvec3>();
  for (std::size_t i = 0; i < pieces.size() + (file.closed ? 0 : 1); ++i) {
    world::Knot knot = knot_of(pieces, i, file.closed);
    world::orthonormalise(knot);
    if (rolled) knot.up = glm::vec3(curve::perpendicular(dvec3(knot.tangent), ups[i]));
    else world::set_roll(knot, 0);
    world::orthonormalise(knot);
    world::append_knot(out.document, knot);
  }
  if (file.closed) world::set_closed(out.document, true);
  world::add_cart(out.document, out.document.track.segments[0], 0);
  out.report = report_of(out.document, pieces, file);
  return out;
}

}  // namespace coaster::exchange
