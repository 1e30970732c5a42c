// Parses and checks the XML of a NoLimits 2 element: vertices and rolls. nl2elem_track.cpp makes the track.
#include "exchange/nolimits/nl2elem.h"

#include <cmath>

#include <fmt/format.h>

#include <tinyxml2.h>

#include "base/text.h"
#include "base/words.h"
#include "exchange/nolimits/nl2elem_track.h"
#include "exchange/nolimits/within_text.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;
using tinyxml2::XMLElement;

constexpr double kElementSquare = 0.05;  // tolerance for unit and perpendicular frames
constexpr double kSameVertex = 1e-6;     // m between the last and the first vertex of a closed track

struct XmlReader {
  std::string name, error;
  bool fail(int line, const std::string& expected, const std::string& found) {
    error = fmt::format("{}:{}: error: expected {}, found {}", name, line, expected, found);
    return false;
  }
};

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

// Tags mean the same in any case: one that was left out for its case would change the track.
bool is_tag(const XMLElement& element, std::string_view tag) { return base::lower(element.Name()) == tag; }

// Returns the element's text, around comments too; tags in it are named, so that they are no number.
std::string text_of(const XMLElement& element) {
  std::string text;
  for (const tinyxml2::XMLNode* node = element.FirstChild(); node; node = node->NextSibling())
    if (node->ToText()) text += node->Value();
    else if (node->ToElement()) text += fmt::format("<{}>", node->Value());
  return std::string(without_blanks(text));
}

// Finds the tag in `parent`; null if there is none. Fails on a second one.
bool find_one(XmlReader& r, const XMLElement& parent, std::string_view tag, const XMLElement*& found) {
  found = nullptr;
  for (const XMLElement* e = parent.FirstChildElement(); e; e = e->NextSiblingElement()) {
    if (!is_tag(*e, tag)) continue;
    if (found) return r.fail(e->GetLineNum(), fmt::format("one <{}>", tag), "a second one");
    found = e;
  }
  return true;
}

bool read_number(XmlReader& r, const XMLElement& parent, std::string_view tag, double limit, double& value) {
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
bool read_vector(XmlReader& r, const XMLElement& parent, std::string_view prefix, double limit, dvec3& v) {
  for (int axis = 0; axis < 3; ++axis)
    if (!read_number(r, parent, fmt::format("{}{}", prefix, "xyz"[axis]), limit, v[axis])) return false;
  return true;
}

bool read_strict(XmlReader& r, const XMLElement& parent, bool& strict) {
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
bool read_weight(XmlReader& r, const XMLElement& vertex, ElementFile& file, double& weight) {
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
    if (!take(a->GetLineNum(), a->Name(), fmt::format("the attribute {}", a->Name()), without_blanks(a->Value())))
      return false;
  for (const XMLElement* e = vertex.FirstChildElement(); e; e = e->NextSiblingElement())
    if (!take(e->GetLineNum(), e->Name(), fmt::format("<{}>", e->Name()), text_of(*e))) return false;
  return true;
}

bool read_vertex(XmlReader& r, const XMLElement& element, ElementFile& file) {
  if (file.vertices.size() >= world::kMaxKnots)
    return r.fail(element.GetLineNum(), fmt::format("at most {} vertices", world::kMaxKnots), "more");
  SplineVertex v;
  if (!read_vector(r, element, "", world::kMaxCoordinate, v.position) || !read_strict(r, element, v.strict) ||
      !read_weight(r, element, file, v.weight))
    return false;
  file.vertices.push_back(v);
  file.lines.push_back(element.GetLineNum());
  return true;
}

bool read_roll(XmlReader& r, const XMLElement& element, ElementFile& file) {
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

bool read_element(XmlReader& r, const XMLElement& element, ElementFile& file) {
  for (const XMLElement* e = element.FirstChildElement(); e; e = e->NextSiblingElement()) {
    if (is_tag(*e, "vertex") && !read_vertex(r, *e, file)) return false;
    if (is_tag(*e, "roll") && !read_roll(r, *e, file)) return false;
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

bool read_file(XmlReader& r, std::string_view text, ElementFile& file, std::vector<std::string>& warnings) {
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
  if (elements.size() > 1)
    warnings.push_back(
        fmt::format("{}:{}: warning: only the first <element> is read", r.name, elements[1]->GetLineNum()));
  return read_element(r, *elements[0], file);
}

}  // namespace

base::Result<LoadedTrack> parse_nl2elem(std::string_view text, std::string_view name) {
  XmlReader r{std::string(name), {}};
  ElementFile file;
  LoadedTrack loaded;
  if (text.empty()) r.fail(1, "XML", "an empty file");
  else if (read_file(r, text, file, loaded.warnings)) {
    ElementTrack track = track_of(file);
    if (track.error) {
      r.fail(file.lines[track.error->vertex], track.error->expected, track.error->found);
    } else {
      loaded.document = std::move(track.document);
      loaded.import = track.report;
      loaded.reshaped = file.rolls.size() > 1;
      if (!file.weights.empty()) loaded.note = "The weights of vertices were read from " + file.weights + ".";
      loaded.document.name = name_of_file(r.name);
      for (const auto& [vertex, warning] : track.warnings)
        loaded.warnings.push_back(fmt::format("{}:{}: warning: {}", r.name, file.lines[vertex], warning));
      return loaded;
    }
  }
  return base::Status{base::Code::bad_file, r.error};
}

}  // namespace coaster::exchange
