// Plan and elevation of a track as SVG, one above the other at the same scale.
#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"
#include "exchange/export/shape_export.h"

namespace coaster::exchange {
namespace {

constexpr double kLeastExtent = 1.0;  // m, smallest extent of a drawing
constexpr double kPaperWidth = 800;   // px, width of the sheet

struct Extent {
  glm::dvec2 low{0}, high{0};  // the corners: left and top, right and bottom
  glm::dvec2 size() const { return glm::max(high - low, kLeastExtent); }
};

using Project = glm::vec2 (*)(glm::vec3);
glm::vec2 plan(glm::vec3 p) { return {p.x, p.z}; }
glm::vec2 elevation(glm::vec3 p) { return {p.x, 0.0f - p.y}; }  // never -0

// Sizes in proportion to the drawing, in metres of the track.
struct DrawingSizes {
  double margin, text, line;
};

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (static_cast<unsigned char>(c) < 0x20) out += ' ';  // not allowed in XML
    else out += c;
  }
  return out;
}

std::string attribute(const char* name, double value) {
  return fmt::format(" {}=\"{}\"", name, base::to_text(static_cast<float>(value)));
}

// Returns the box of the control points, which contains the curve.
Extent extent_of(const std::vector<curve::Cubic>& cubics, Project project) {
  if (cubics.empty()) return {};
  const glm::dvec2 first(project(cubics[0].p0));
  Extent e{first, first};
  for (const curve::Cubic& c : cubics)
    for (const glm::vec3 p : {c.p0, c.p1, c.p2, c.p3}) {
      const glm::dvec2 at(project(p));
      e = {glm::min(e.low, at), glm::max(e.high, at)};
    }
  return e;
}

std::string path(const std::vector<curve::Cubic>& cubics, Project project, bool closed) {
  const auto pair = [&](glm::vec3 p) {
    const glm::vec2 at = project(p);
    return fmt::format("{} {}", base::to_text(at.x), base::to_text(at.y));
  };
  std::string d;
  for (const curve::Cubic& c : cubics) {
    if (d.empty()) d = "M" + pair(c.p0);
    d += fmt::format(" C{} {} {}", pair(c.p1), pair(c.p2), pair(c.p3));
  }
  return closed ? d + " Z" : d;
}

// Returns the largest 1, 2 or 5 times a power of ten that is at most a third of the drawing.
double bar_length(double width) {
  double length = 0.1;
  for (double decade = 0.1; decade <= width; decade *= 10)
    for (const double digit : {1.0, 2.0, 5.0})
      if (digit * decade <= width / 3) length = digit * decade;
  return length;
}

struct Drawing {
  const char *id, *label;
  Project project;
  Extent extent;
};

// Prints the label above, the drawing, and the bar with its length below. `top` is its start on the sheet.
std::string print_drawing(const Drawing& drawing, const std::vector<curve::Cubic>& cubics, bool closed,
                          const DrawingSizes& style, double top) {
  const Extent& e = drawing.extent;
  const double x = style.margin, y = top + 2 * style.text, below = y + e.size().y + style.text,
               bar = bar_length(e.size().x);
  const std::string font = attribute("font-size", style.text) + " font-family=\"sans-serif\"";
  std::string out =
      fmt::format("<text{}{}{}>{}</text>\n", attribute("x", x), attribute("y", top + style.text), font, drawing.label);
  out += fmt::format("<g id=\"{}\" transform=\"translate({} {})\" fill=\"none\" stroke=\"#1f4e79\"{}>\n", drawing.id,
                     base::to_text(x - e.low.x), base::to_text(y - e.low.y), attribute("stroke-width", style.line));
  if (!cubics.empty()) out += fmt::format("<path d=\"{}\"/>\n", path(cubics, drawing.project, closed));
  out += "</g>\n";
  out += fmt::format("<path id=\"{}-bar\" d=\"M{} {} h{}\" stroke=\"black\"{}/>\n", drawing.id, base::to_text(x),
                     base::to_text(below), base::to_text(bar), attribute("stroke-width", 2 * style.line));
  out += fmt::format("<text{}{}{}>{} m</text>\n", attribute("x", x + bar + 0.5 * style.text),
                     attribute("y", below + 0.35 * style.text), font, base::to_text(static_cast<float>(bar)));
  return out;
}

}  // namespace

std::string print_svg(const world::Document& document) {
  std::vector<curve::Cubic> cubics;
  for (const world::Entity segment : document.track.segments) cubics.push_back(world::cubic_of(document, segment));
  const Drawing above{"plan", "Plan (x to the right, z down)", plan, extent_of(cubics, plan)};
  const Drawing beside{"elevation", "Elevation (x to the right, y up)", elevation, extent_of(cubics, elevation)};
  const double size = std::max({above.extent.size().x, above.extent.size().y, beside.extent.size().y});
  const DrawingSizes style{size * 0.05, size * 0.025, size * 0.003};
  const double extra = 5 * style.text;  // label and bar
  const double width = std::max(above.extent.size().x, 20 * style.text) + 2 * style.margin;
  const double second = style.margin + above.extent.size().y + extra,
               height = second + beside.extent.size().y + extra + style.margin;
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"{}{} viewBox=\"0 0 {} "
      "{}\">\n<title>{}</title>\n<desc>1 unit is 1 metre</desc>\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"white\"/>\n",
      attribute("width", kPaperWidth), attribute("height", kPaperWidth * height / width),
      base::to_text(static_cast<float>(width)), base::to_text(static_cast<float>(height)), escaped(document.name));
  out += print_drawing(above, cubics, document.track.closed, style, style.margin);
  out += print_drawing(beside, cubics, document.track.closed, style, second);
  return out + "</svg>\n";
}

}  // namespace coaster::exchange
