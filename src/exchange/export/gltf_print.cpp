// A track's solid as glTF 2.0 with its buffer as base64.
#include <bit>
#include <span>

#include "exchange/export/track_shapes.h"
#include "exchange/export/track_solid.h"
#include "exchange/own/json_text.h"

namespace coaster::exchange {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

// Constants of the specification.
constexpr int kFloat = 5126, kUnsigned = 5125, kVertices = 34962, kIndices = 34963, kLineStrip = 3, kTriangles = 4;

struct BinaryBuilder {
  Json views = Json::array(), accessors = Json::array();
  std::string bytes;

  // Adds an accessor with its own buffer view; sizes are multiples of 4 bytes, so everything is aligned. Returns the
  // accessor's index.
  template <class T>
  std::size_t add(std::span<const T> items, int component, int target, Json accessor) {
    static_assert(sizeof(T) % 4 == 0);
    views.push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", items.size_bytes()}, {"target", target}});
    bytes.append(reinterpret_cast<const char*>(items.data()), items.size_bytes());
    accessor["bufferView"] = views.size() - 1;
    accessor["componentType"] = component;
    accessor["count"] = items.size();
    accessors.push_back(std::move(accessor));
    return accessors.size() - 1;
  }
  std::size_t positions(std::span<const glm::vec3> points) {
    glm::vec3 low = points[0], high = points[0];
    for (const glm::vec3 p : points) low = glm::min(low, p), high = glm::max(high, p);
    return add(points, kFloat, kVertices,
               {{"type", "VEC3"}, {"min", {low.x, low.y, low.z}}, {"max", {high.x, high.y, high.z}}});
  }
};

// Of points and triangles: three numbers each, so that no group of digits has to be filled.
std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() / 3 * 4);
  std::uint32_t group = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    group = group << 8 | static_cast<unsigned char>(bytes[i]);
    for (std::size_t k = 0; k < 4 && i % 3 == 2; ++k) text += kDigits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

Json material(std::string_view name, glm::vec3 colour) {
  return {
      {"name", name},
      {"pbrMetallicRoughness",
       {{"baseColorFactor", {colour.x, colour.y, colour.z, 1.0}}, {"metallicFactor", 0.6}, {"roughnessFactor", 0.5}}}};
}

// Adds the materials that it uses.
Json track_mesh(BinaryBuilder& builder, const TrackSolid& solid, Json& materials) {
  Json primitives = Json::array();
  for (const SolidPart& part : solid.parts) {
    if (part.indices.empty()) continue;
    Json attributes{{"POSITION", builder.positions(part.positions)}};
    attributes["NORMAL"] = builder.add(std::span(part.normals), kFloat, kVertices, {{"type", "VEC3"}});
    const std::size_t indices = builder.add(std::span(part.indices), kUnsigned, kIndices, {{"type", "SCALAR"}});
    primitives.push_back({{"attributes", std::move(attributes)},
                          {"indices", indices},
                          {"material", materials.size()},
                          {"mode", kTriangles}});
    materials.push_back(material(part.name, part.colour));
  }
  return {{"name", "track"}, {"primitives", std::move(primitives)}};
}

}  // namespace

std::string print_gltf(const world::Document& document) {
  const TrackSolid solid = track_solid(document);
  Json file{{"asset", {{"version", "2.0"}, {"generator", "coaster"}}}, {"scene", 0}};
  Json scene{{"name", document.name}};
  if (!solid.centre_line.empty()) {
    BinaryBuilder builder;
    Json materials = Json::array();
    const Json track = track_mesh(builder, solid, materials);
    const std::size_t line = builder.positions(solid.centre_line);
    scene["nodes"] = Json::array({0, 1});
    file["nodes"] = Json::array({{{"name", "track"}, {"mesh", 0}}, {{"name", "centre line"}, {"mesh", 1}}});
    const Json attributes{{"POSITION", line}};
    const Json strip{{"attributes", attributes}, {"material", materials.size()}, {"mode", kLineStrip}};
    const Json line_mesh{{"name", "centre line"}, {"primitives", Json::array({strip})}};
    file["meshes"] = Json::array({track, line_mesh});
    materials.push_back(material("centre line", kLineColour));
    file["materials"] = std::move(materials);
    const Json buffer{{"byteLength", builder.bytes.size()},
                      {"uri", "data:application/octet-stream;base64," + base64(builder.bytes)}};
    file["buffers"] = Json::array({buffer});
    file["bufferViews"] = std::move(builder.views);
    file["accessors"] = std::move(builder.accessors);
  }
  file["scenes"] = Json::array({scene});
  return json_file(file, 1);
}

}  // namespace coaster::exchange
