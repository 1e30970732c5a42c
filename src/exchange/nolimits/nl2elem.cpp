// Reads the XML of a NoLimits 2 element, makes a track of its vertices and rolls, and prints a track as one.
#include "exchange/nolimits/nl2elem.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "base/check.h"
#include "base/portable_math.h"
#include "base/text.h"
#include "exchange/nolimits/delimited_text.h"
#include "exchange/nolimits/nl2_spline.h"
#include "sim/fit/fit_track.h"
#include "sim/shape/roll.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace {

struct ElementFile {
  std::vector<SplineVertex> vertices;  // for a closed track the last repeats the first
  std::vector<int> lines;              // line numbers of the vertices
  std::vector<ElementRoll> rolls;      // in any order
  bool closed = false;
  std::string weights;  // the name of the member that holds the vertices' weights; empty if all are 1
};

// What is read, and the first error.
struct ElementReader {
  std::string name, error;
  ElementFile file;
  LoadedTrack loaded;
  bool fail(int line, const std::string& expected, const std::string& found) {
    error = fmt::format("{}:{}: error: expected {}, found {}", name, line, expected, found);
    return false;
  }
  bool fail_at(std::size_t vertex, const std::string& expected, const std::string& found) {
    return fail(file.lines[vertex], expected, found);
  }
  void warn(int line, const std::string& what) {
    loaded.warnings.push_back(fmt::format("{}:{}: warning: {}", name, line, what));
  }
  void warn_at(std::size_t vertex, const std::string& what) { warn(file.lines[vertex], what); }
};

using glm::dvec3;
using tinyxml2::XMLElement;
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

// Makes the curves between knots, corners rounded.
bool make_curves(ElementReader& r, std::vector<Bezier>& curves) {
  const ElementFile& file = r.file;
  double& off = r.loaded.import->max_error;
  std::vector<SplinePiece> pieces = spline_pieces(file.vertices);
  std::erase_if(pieces, [](const SplinePiece& piece) {  // between vertices at one place
    return start_direction(piece.curve) == dvec3(0) || end_direction(piece.curve) == dvec3(0);
  });
  if (pieces.empty()) return r.fail_at(0, "vertices at different places", "all at one");
  for (const SplinePiece& piece : pieces) off = std::max(off, piece.off);
  if (const auto fold = find_fold(pieces, file.closed))
    return r.fail_at(fold->vertex, fmt::format("turns of at most {} degrees within {} cm", kSharpest, 200 * kCornerOff),
                     fmt::format("one of {:.6g} degrees near vertex {}", base::degrees(fold->angle), fold->vertex + 1));
  std::vector<Corner> corners;
  pieces = round_corners(pieces, file.closed, corners);
  for (const Corner& corner : corners) {
    if (corner.angle > base::radians(kSharpest) + 1e-6)
      return r.fail_at(
          corner.vertex, fmt::format("corners of at most {} degrees", kSharpest),
          fmt::format("one of {:.6g} degrees at vertex {}", base::degrees(corner.angle), corner.vertex + 1));
    off = std::max(off, corner.off);
    if (&corner < &corners[0] + kMaxTold)
      r.warn_at(corner.vertex, fmt::format("the corner of {} degrees at vertex {} was rounded, up to {:.1f} mm off",
                                           rounded_degrees(corner.angle), corner.vertex + 1, 1000 * corner.off));
  }
  if (corners.size() > kMaxTold)
    r.warn_at(corners[kMaxTold].vertex, fmt::format("{} more corners were rounded", corners.size() - kMaxTold));
  if (file.closed && pieces.size() < 2) halve(pieces, 0);  // a closed track has two knots
  while (halve(pieces, world::kMaxHandle)) {
  }
  for (const SplinePiece& piece : pieces) curves.push_back(piece.curve);
  return true;
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

void append_knots(const std::vector<Bezier>& segments, const std::vector<KnotPosition>& stops, bool closed,
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
void set_turns(const std::vector<KnotPosition>& stops, world::Document& document) {
  const sim::DerivedTrack derived = sim::shapes_of(document);
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
  const sim::DerivedTrack derived = sim::shapes_of(document);
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

bool make_track(ElementReader& r) {
  const ElementFile& file = r.file;
  world::Document& document = r.loaded.document;
  std::vector<Bezier> curves;
  ImportReport& report = r.loaded.import.emplace();
  if (!make_curves(r, curves)) return false;
  const std::vector<KnotPosition> stops = stops_of(curves, file.closed, file.rolls);
  if (stops.size() > world::kMaxKnots)
    return r.fail_at(0, fmt::format("vertices and rolls for at most {} knots", world::kMaxKnots),
                     std::to_string(stops.size()));
  std::vector<Bezier> segments;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
    segments.push_back(
        part(curves[stops[i].piece], stops[i].t, stops[i + 1].piece == stops[i].piece ? stops[i + 1].t : 1));
  if (const std::size_t count = short_handles(segments); count > 0)
    r.warn_at(
        0, fmt::format("{} handles shorter than {} m were lengthened to it", count, base::to_text(world::kMinHandle)));
  append_knots(segments, stops, file.closed, document);
  if (!file.rolls.empty()) set_turns(stops, document);
  else sim::set_automatic_spins(document);
  world::add_cart(document, document.track.segments[0], 0);
  const RollAlong along = measure(document, segments, file, report);
  if (report.frame_error > kRollTold)
    r.warn_at(0, fmt::format("the track is up to {} degrees off the file's rolls",
                             rounded_degrees(base::radians(report.frame_error))));
  if (along.degrees > kAlongTold)
    r.warn_at(0,
              fmt::format("the up of the roll at coord {:.4g} is {:.0f} degrees off perpendicular to the track there",
                          along.coord, along.degrees));
  r.loaded.reshaped = file.rolls.size() > 1;
  if (!file.weights.empty()) r.loaded.note = "The weights of vertices were read from " + file.weights + ".";
  document.name = name_of_file(r.name);
  return true;
}

constexpr double kElementSquare = 0.05;  // tolerance for unit and perpendicular frames
constexpr std::string_view kBlanks = " \t\r\n";
constexpr double kSameVertex = 1e-6;  // m between the last and the first vertex of a closed track

// Tags mean the same in any case: one that was left out for its case would change the track.
bool is_tag(const XMLElement& element, std::string_view tag) { return base::lower(element.Name()) == tag; }

// Returns the element's text, around comments too; tags in it are named, so that they are no number.
std::string text_of(const XMLElement& element) {
  std::string text;
  for (const tinyxml2::XMLNode* node = element.FirstChild(); node; node = node->NextSibling())
    if (node->ToText()) text += node->Value();
    else if (node->ToElement()) text += fmt::format("<{}>", node->Value());
  return std::string(trimmed(text, kBlanks));
}

// Finds the tag in `parent`; null if there is none. Fails on a second one.
bool find_one(ElementReader& r, const XMLElement& parent, std::string_view tag, const XMLElement*& found) {
  found = nullptr;
  for (const XMLElement* e = parent.FirstChildElement(); e; e = e->NextSiblingElement()) {
    if (!is_tag(*e, tag)) continue;
    if (found) return r.fail(e->GetLineNum(), fmt::format("one <{}>", tag), "a second one");
    found = e;
  }
  return true;
}

bool read_number(ElementReader& r, const XMLElement& parent, std::string_view tag, double limit, double& value) {
  const XMLElement* element = nullptr;
  if (!find_one(r, parent, tag, element)) return false;
  const std::string what = fmt::format("<{}>", tag);
  if (!element) return r.fail(parent.GetLineNum(), fmt::format("{} in <{}>", what, parent.Name()), "none");
  const std::string text = text_of(*element);
  const auto number = base::parse_double(text);
  if (!number || !std::isfinite(*number))
    return r.fail(element->GetLineNum(), "a finite number in " + what, base::quoted_number(text));
  if (!(std::abs(*number) <= limit))
    return r.fail(element->GetLineNum(), fmt::format("{} in {}", within_text(limit), what), base::quoted_start(text));
  value = *number;
  return true;
}

// Reads "ux", "uy" and "uz" for the prefix "u".
bool read_vector(ElementReader& r, const XMLElement& parent, std::string_view prefix, double limit, dvec3& v) {
  for (int axis = 0; axis < 3; ++axis)
    if (!read_number(r, parent, fmt::format("{}{}", prefix, "xyz"[axis]), limit, v[axis])) return false;
  return true;
}

bool read_strict(ElementReader& r, const XMLElement& parent, bool& strict) {
  strict = false;
  const XMLElement* element = nullptr;
  if (!find_one(r, parent, "strict", element)) return false;
  if (!element) return true;
  const std::string text = base::lower(text_of(*element));
  strict = text == "true" || text == "1";
  return strict || text.empty() || text == "false" || text == "0" ||
         r.fail(element->GetLineNum(), "true or false in <strict>", base::quoted_start(text));
}

// Vertices of NoLimits 2 can have a weight, but no public source names its member in an element: `w` and `weight` are
// read, as a tag or an attribute. Any other name that speaks of a weight is rejected unless it is 1.
bool read_weight(ElementReader& r, const XMLElement& vertex, double& weight) {
  ElementFile& file = r.file;
  constexpr double kMostRatio = 100;
  bool found = false;
  const auto take = [&](int line, const char* name, std::string what, std::string_view value) {
    const std::string lower = base::lower(name);
    if (lower != "w" && lower.find("weight") == std::string::npos) return true;
    const auto number = base::parse_double(value);
    if (lower != "w" && lower != "weight")
      return number == 1.0 || r.fail(line, "weights in <w> or <weight>", what + " of " + base::quoted_start(value));
    if (std::exchange(found, true)) return r.fail(line, "one weight", "a second one");
    const double first = file.vertices.empty() ? 1 : file.vertices[0].weight,
                 ratio = file.vertices.empty() ? 1e6 : kMostRatio;
    if (!number || !(*number >= first / ratio && *number <= first * ratio))
      return r.fail(line, fmt::format("a weight from {:.6g} to {:.6g} in {}", first / ratio, first * ratio, what),
                    base::quoted_number(value));
    weight = *number;
    if (weight != 1 && file.weights.empty()) file.weights = std::move(what);
    return true;
  };
  for (const tinyxml2::XMLAttribute* a = vertex.FirstAttribute(); a; a = a->Next())
    if (!take(a->GetLineNum(), a->Name(), fmt::format("the attribute {}", a->Name()), trimmed(a->Value(), kBlanks)))
      return false;
  for (const XMLElement* e = vertex.FirstChildElement(); e; e = e->NextSiblingElement())
    if (!take(e->GetLineNum(), e->Name(), fmt::format("<{}>", e->Name()), text_of(*e))) return false;
  return true;
}

bool read_vertex(ElementReader& r, const XMLElement& element) {
  ElementFile& file = r.file;
  if (file.vertices.size() >= world::kMaxKnots)
    return r.fail(element.GetLineNum(), fmt::format("at most {} vertices", world::kMaxKnots), "more");
  SplineVertex v;
  if (!read_vector(r, element, "", world::kMaxCoordinate, v.position) || !read_strict(r, element, v.strict) ||
      !read_weight(r, element, v.weight))
    return false;
  file.vertices.push_back(v);
  file.lines.push_back(element.GetLineNum());
  return true;
}

bool read_roll(ElementReader& r, const XMLElement& element) {
  ElementFile& file = r.file;
  if (file.rolls.size() >= world::kMaxKnots)
    return r.fail(element.GetLineNum(), fmt::format("at most {} rolls", world::kMaxKnots), "more");
  ElementRoll roll;
  dvec3 right(0);
  if (!read_vector(r, element, "u", 2, roll.up) || !read_vector(r, element, "r", 2, right) ||
      !read_number(r, element, "coord", 1, roll.coord) || !read_strict(r, element, roll.strict))
    return false;
  if (roll.coord < 0) return r.fail(element.GetLineNum(), "a <coord> from 0 to 1", base::to_text(roll.coord));
  for (const dvec3& v : {roll.up, right})
    if (std::abs(glm::length(v) - 1) > kElementSquare)
      return r.fail(element.GetLineNum(), "unit vectors in <roll>", "one of length " + base::to_text(glm::length(v)));
  if (std::abs(glm::dot(roll.up, right)) > kElementSquare)
    return r.fail(element.GetLineNum(), "perpendicular vectors in <roll>",
                  "a cosine of " + base::to_text(glm::dot(roll.up, right)));
  roll.up = glm::normalize(roll.up);
  file.rolls.push_back(roll);
  return true;
}

bool read_element(ElementReader& r, const XMLElement& element) {
  ElementFile& file = r.file;
  for (const XMLElement* e = element.FirstChildElement(); e; e = e->NextSiblingElement()) {
    if (is_tag(*e, "vertex") && !read_vertex(r, *e)) return false;
    if (is_tag(*e, "roll") && !read_roll(r, *e)) return false;
  }
  const int line = element.GetLineNum();
  if (file.vertices.size() < 2) return r.fail(line, "at least 2 vertices", std::to_string(file.vertices.size()));
  file.closed = file.vertices.size() > 3 &&
                glm::distance(file.vertices.front().position, file.vertices.back().position) <= kSameVertex;
  return true;
}

// The library takes time by the square of a tag's attributes. Returns the line of the first tag that is too long, 0 if
// there is none.
int line_of_long_tag(std::string_view text) {
  constexpr std::size_t kMostBytes = 4096;
  for (std::size_t from = text.find('<'); from != std::string_view::npos; from = text.find('<', from + 1)) {
    const std::string_view tag = text.substr(from, kMostBytes);
    if (tag.starts_with("<!") || tag.starts_with("<?")) continue;
    char quote = 0;
    std::size_t at = 0;
    for (; at < tag.size() && (quote != 0 || tag[at] != '>'); ++at)
      if (quote != 0) quote = tag[at] == quote ? char{0} : quote;
      else if (tag[at] == '"' || tag[at] == '\'') quote = tag[at];
    if (at == kMostBytes)
      return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(from), '\n'));
  }
  return 0;
}

std::string fault_of(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT: return "a tag that is not closed, or is closed by another name";
    case tinyxml2::XML_ERROR_PARSING: return "a tag that is not closed";
    case tinyxml2::XML_ERROR_PARSING_ELEMENT: return "an unfinished tag";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE: return "an attribute that is not NAME=\"VALUE\"";
    case tinyxml2::XML_ERROR_PARSING_TEXT: return "text that no tag encloses";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
    case tinyxml2::XML_ERROR_PARSING_UNKNOWN: return "an unfinished comment, declaration or CDATA section";
    default: return "a fault";
  }
}

bool read_file(ElementReader& r, std::string_view text) {
  if (const int line = line_of_long_tag(text); line > 0)
    return r.fail(line, "tags of at most 4096 bytes", "a longer one");
  tinyxml2::XMLDocument xml;
  if (xml.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
    return r.fail(std::max(xml.ErrorLineNum(), 1), "well-formed XML", fault_of(xml.ErrorID()));
  const XMLElement* const root = xml.RootElement();
  if (!root || !is_tag(*root, "root"))
    return r.fail(root ? root->GetLineNum() : 1, "<root>", root ? base::quoted_start(root->Name()) : "none");
  std::vector<const XMLElement*> elements;
  for (const XMLElement* e = root->FirstChildElement(); e; e = e->NextSiblingElement())
    if (is_tag(*e, "element")) elements.push_back(e);
  if (elements.empty()) return r.fail(root->GetLineNum(), "<element> in <root>", "none");
  if (elements.size() > 1) r.warn(elements[1]->GetLineNum(), "only the first <element> is read");
  return read_element(r, *elements[0]);
}

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

base::Result<LoadedTrack> parse_nl2elem(std::string_view text, std::string_view name) {
  ElementReader r{.name = std::string(name)};
  const bool read = text.empty() ? r.fail(1, "XML", "an empty file") : read_file(r, text) && make_track(r);
  if (!read) return base::Status{base::Code::bad_file, r.error};
  return std::move(r.loaded);
}

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
  const sim::DerivedTrack derived = sim::shapes_of(document);
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
