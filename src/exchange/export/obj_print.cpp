// A track's solid as Wavefront OBJ.
#include <fmt/format.h>

#include "base/text.h"
#include "exchange/export/track_shapes.h"
#include "exchange/export/track_solid.h"

namespace coaster::exchange {
namespace {

void add_vector(std::string& out, const char* key, glm::vec3 v) {
  out += key;
  for (int axis = 0; axis < 3; ++axis) out += ' ' + base::to_text(v[axis]);
  out += '\n';
}

// Replaces line breaks: an OBJ name is one line.
std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\') c = ' ';
  return text;
}

}  // namespace

std::string print_obj(const world::Document& document) {
  const TrackSolid solid = track_solid(document);
  std::string out = fmt::format("# Track in metres, Y up\no {}\n", one_line(document.name));
  std::size_t before = 1;  // indices count from 1, over all groups
  for (const SolidPart& part : solid.parts) {
    if (part.indices.empty()) continue;
    out += fmt::format("g {0}\nusemtl {0}\n", part.name);
    for (const glm::vec3 p : part.positions) add_vector(out, "v", p);
    for (const glm::vec3 n : part.normals) add_vector(out, "vn", n);
    for (std::size_t i = 0; i < part.indices.size(); ++i) {
      const std::string number = std::to_string(before + part.indices[i]);
      out += fmt::format("{}{}//{}{}", i % 3 == 0 ? "f " : " ", number, number, i % 3 == 2 ? "\n" : "");
    }
    before += part.positions.size();
  }
  if (solid.centre_line.empty()) return out;
  out += "g centre_line\nusemtl centre_line\n";
  for (const glm::vec3 p : solid.centre_line) add_vector(out, "v", p);
  out += "l";
  for (std::size_t i = 0; i < solid.centre_line.size(); ++i) out += fmt::format(" {}", before + i);
  return out + "\n";
}

std::string obj_materials() {
  std::string out;
  const auto add = [&](std::string_view name, glm::vec3 colour) {
    out += fmt::format("newmtl {}\n", name);
    add_vector(out, "Kd", colour);
  };
  for (const SolidPart& part : TrackSolid{}.parts) add(part.name, part.colour);
  add("centre_line", kLineColour);
  return out;
}

}  // namespace coaster::exchange
