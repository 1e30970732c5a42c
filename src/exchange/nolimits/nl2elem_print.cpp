// Prints a document as a NoLimits 2 element.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "base/text.h"
#include "exchange/nolimits/nl2_spline.h"
#include "exchange/nolimits/nl2elem.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

// True if the spline is close to the track at the same fraction of the length, has the same direction there, and the
// roll is linear between the vertices.
bool is_close(const UniformSpline& spline, const sim::Derived& derived) {
  const auto place = [&](double spans) {
    return place_on(derived, derived.length * spans / static_cast<double>(spline.spans()));
  };
  for (std::size_t i = 0; i < spline.spans(); ++i) {
    const curve::Cubic cubic = in_float(spline.span(i));
    const dvec3 from = place(static_cast<double>(i)).frame.up, to = place(static_cast<double>(i + 1)).frame.up;
    for (const double t : {0.0, 0.25, 0.5, 0.75}) {
      const PlaceOnTrack wanted = place(static_cast<double>(i) + t);
      if (glm::distance(curve::point(cubic, t), wanted.position) > kNl2ElemError) return false;
      if (glm::length(curve::unit_tangent(cubic, t) - wanted.frame.forward) > kNl2ElemTurn) return false;
      const dvec3 up = curve::perpendicular(wanted.frame.forward, (1 - t) * from + t * to);
      if (glm::length(up - wanted.frame.up) > kNl2ElemTurn) return false;
    }
  }
  return true;
}

std::vector<SplineVertex> vertices_of(const sim::Derived& derived, std::size_t spans) {
  std::vector<SplineVertex> vertices;
  for (std::size_t i = 0; i < spans + (derived.closed ? 0 : 1); ++i)
    vertices.push_back(
        {place_on(derived, derived.length * static_cast<double>(i) / static_cast<double>(spans)).position, true});
  return vertices;
}

void print_line(std::string& out, int depth, std::string_view tag, const std::string& value) {
  out.append(static_cast<std::size_t>(depth), '\t');
  out += fmt::format("<{}>{}</{}>\r\n", tag, value, tag);
}

void print_vector(std::string& out, std::string_view prefix, dvec3 v) {
  for (int axis = 0; axis < 3; ++axis)
    print_line(out, 3, fmt::format("{}{}", prefix, "xyz"[axis]), base::to_text(v[axis]));
}

void print_vertex(std::string& out, dvec3 p) {
  out += "\t\t<vertex>\r\n";
  print_vector(out, "", p);
  print_line(out, 3, "strict", "true");
  out += "\t\t</vertex>\r\n";
}

void print_roll(std::string& out, const curve::Frame& frame, double coord) {
  out += "\t\t<roll>\r\n";
  print_vector(out, "u", frame.up);
  print_vector(out, "r", -frame.left());
  print_line(out, 3, "coord", base::to_text(std::min(coord, 1.0)));
  print_line(out, 3, "strict", "true");
  out += "\t\t</roll>\r\n";
}

}  // namespace

base::Status check_nl2elem(const world::Document& document) {
  if (document.track.segments.empty())
    return {base::Code::refused, "error: expected a track with segments, found none"};
  if (const double length = world::exact_length(document); !(length <= kMaxNl2ElemLength && length > 0.01))
    return {base::Code::refused, fmt::format("error: expected a track of 0.01 to {} m, found {} m",
                                             base::to_text(kMaxNl2ElemLength), base::to_text(length))};
  return {};
}

std::string print_nl2elem(const world::Document& document) {
  COASTER_CHECK(check_nl2elem(document).ok(), "callers check the track first");
  const sim::Derived derived = sim::shapes_of(document);
  double spacing = 1;
  const auto spans_at = [&](double m) {
    return std::max<std::size_t>(4, static_cast<std::size_t>(std::ceil(derived.length / m)));
  };
  std::vector<SplineVertex> vertices = vertices_of(derived, spans_at(spacing));
  while (spacing > 0.125 && !is_close(UniformSpline(vertices, derived.closed), derived))
    vertices = vertices_of(derived, spans_at(spacing /= 2));

  const UniformSpline spline(vertices, derived.closed);
  std::vector<double> starts{0};
  for (std::size_t i = 0; i < spline.spans(); ++i)
    starts.push_back(starts.back() + curve::ArcLengthMap(in_float(spline.span(i))).length());
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\" ?>\r\n<root>\r\n\t<element>\r\n";
  print_line(out, 2, "description", "coaster");
  for (const SplineVertex& v : vertices) print_vertex(out, v.position);
  if (derived.closed) print_vertex(out, vertices.front().position);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double s = derived.length * static_cast<double>(i) / static_cast<double>(spline.spans());
    print_roll(out, place_on(derived, s).frame, starts[i] / starts.back());
  }
  return out + "\t</element>\r\n</root>\r\n";
}

}  // namespace coaster::exchange
