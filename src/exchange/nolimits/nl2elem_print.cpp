// Prints a document as a NoLimits 2 element.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "base/portable_math.h"
#include "base/text.h"
#include "exchange/nolimits/nl2_corners.h"
#include "exchange/nolimits/nl2_rolls.h"
#include "exchange/nolimits/nl2elem.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

void print_line(std::string& out, int depth, std::string_view tag, const std::string& value) {
  out.append(static_cast<std::size_t>(depth), '\t');
  out += fmt::format("<{}>{}</{}>\r\n", tag, value, tag);
}

void print_vector(std::string& out, std::string_view prefix, dvec3 v) {
  for (int axis = 0; axis < 3; ++axis)
    print_line(out, 3, fmt::format("{}{}", prefix, "xyz"[axis]), base::to_text(v[axis]));
}

void print_vertex(std::string& out, dvec3 p, bool strict) {
  out += "\t\t<vertex>\r\n";
  print_vector(out, "", p);
  print_line(out, 3, "strict", strict ? "true" : "false");
  out += "\t\t</vertex>\r\n";
}

void print_roll(std::string& out, const curve::Frame& frame, double coord) {
  out += "\t\t<roll>\r\n";
  print_vector(out, "u", frame.up);
  print_vector(out, "r", -frame.left());
  print_line(out, 3, "coord", base::to_text(std::min(coord, 1.0)));
  print_line(out, 3, "strict", "false");
  out += "\t\t</roll>\r\n";
}

}  // namespace

base::Status check_nl2elem(const world::Document& document) {
  if (document.track.segments.empty())
    return {base::Code::refused, "error: expected a track with segments, found none"};
  if (const double length = world::exact_length(document); !(length <= kMaxNl2ElemLength && length > 0.01))
    return {base::Code::refused, fmt::format("error: expected a track of 0.01 to {} m, found {} m",
                                             base::to_text(kMaxNl2ElemLength), base::to_text(length))};
  std::vector<SplinePiece> pieces;
  for (const world::Entity e : document.track.segments) {
    const curve::Cubic cubic = world::cubic_of(document, e);
    pieces.push_back({{dvec3(cubic.p0), dvec3(cubic.p1), dvec3(cubic.p2), dvec3(cubic.p3)}, pieces.size()});
    for (const glm::vec3& handle : {cubic.p1, cubic.p2})
      if (!(std::max({std::abs(handle.x), std::abs(handle.y), std::abs(handle.z)}) <= world::kMaxCoordinate))
        return {base::Code::refused, fmt::format("error: expected handles within {} m of the origin, found one beyond",
                                                 base::to_text(world::kMaxCoordinate))};
  }
  if (const auto fold = find_fold(pieces, document.track.closed))
    return {base::Code::refused,
            fmt::format("error: expected turns of at most {} degrees within {} cm, found one of {:.6g} degrees behind "
                        "knot {}; a file with it could not be read",
                        kSharpest, 200 * kCornerOff, base::degrees(fold->angle),
                        world::label_of(document, document.track.knots[fold->vertex]))};
  return {};
}

std::string print_nl2elem(const world::Document& document) {
  COASTER_CHECK(check_nl2elem(document).ok(), "callers check the track first");
  const sim::Derived derived = sim::shapes_of(document);
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\" ?>\r\n<root>\r\n\t<element>\r\n";
  print_line(out, 2, "description", "coaster");
  for (const world::Entity e : derived.order) {
    const auto& segment = document.entities.get<world::Segment>(e);
    const world::Knot &from = world::knot(document, segment.from), &to = world::knot(document, segment.to);
    const dvec3 start(from.position), end(to.position);
    if (e == derived.order.front()) print_vertex(out, start, true);
    print_vertex(out, start + dvec3(from.tangent) * double{from.out_length}, false);
    print_vertex(out, end - dvec3(to.tangent) * double{to.in_length}, false);
    print_vertex(out, end, true);
  }
  for (const double s : roll_places(derived)) print_roll(out, place_on(derived, s).frame, s / derived.length);
  return out + "\t</element>\r\n</root>\r\n";
}

}  // namespace coaster::exchange
