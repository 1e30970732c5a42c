// Prints the whole track as triangles and a line: Wavefront OBJ and glTF 2.0.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"
#include "exchange/export/shape_export.h"
#include "exchange/own/json.h"
#include "exchange/own/share_link.h"
#include "sim/ground/ground.h"
#include "sim/shape/rails.h"
#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"
#include "world/document.h"

namespace coaster::exchange {
namespace {

// One part of the track: triangles, counter-clockwise seen from outside; may be empty.
struct SolidPart {
  std::string_view name;
  glm::vec3 colour{0};               // linear red, green, blue
  std::vector<glm::vec3> positions;  // m
  std::vector<glm::vec3> normals;    // unit, one per position
  std::vector<std::uint32_t> indices;
};

constexpr std::string_view kTimber = "timber";
constexpr glm::vec3 kLineColour{1, 0.8f, 0};  // of the centre line

// Returns linear light of a colour on the screen.
glm::vec3 linear(world::Colour colour) {
  glm::vec3 light;
  for (int i = 0; i < 3; ++i) {
    const float c = static_cast<float>(colour.rgb >> (16 - 8 * i) & 255) / 255.0f;
    light[i] = c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
  }
  return light;
}

struct TrackSolid {
  std::array<SolidPart, 7> parts{
      SolidPart{"rails", {0.75f, 0.1f, 0.08f}},    SolidPart{"spine", {0.2f, 0.25f, 0.35f}},
      SolidPart{"ties", {0.45f, 0.47f, 0.5f}},     SolidPart{"equipment", {0.3f, 0.33f, 0.36f}},
      SolidPart{"supports", {0.8f, 0.81f, 0.83f}}, SolidPart{"concrete", {0.46f, 0.48f, 0.46f}},
      SolidPart{kTimber, {0.17f, 0.09f, 0.04f}}};
  std::vector<glm::vec3> centre_line;  // a closed track's line ends at its start; empty without segments

  // Parts that the track's paint covers have its colours.
  explicit TrackSolid(const world::Document& document) {
    const world::Paint paint = world::over(document.paint, base::row_of(document.kind).paint);
    const auto set = [&](std::size_t part, world::Colour colour) {
      if (colour.own()) parts[part].colour = linear(colour);
    };
    set(0, paint.rails), set(1, paint.spine), set(2, paint.spine), set(4, paint.supports);
  }
};

constexpr double kLineTolerance =
    0.001;  // m, between the centre line and the rails (with at most 1000 chords per segment)

constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

std::size_t part_of(const sim::MeshVertex& vertex) {
  switch (static_cast<sim::Material>(static_cast<int>(vertex.part))) {
    case sim::Material::rail: return 0;
    case sim::Material::spine: return 1;
    case sim::Material::tie: return 2;
    case sim::Material::support:
    case sim::Material::handrail: return 4;
    case sim::Material::concrete: return 5;
    case sim::Material::timber:
    case sim::Material::plank: return 6;
    default: return 3;
  }
}

void add_mesh(const sim::Mesh& mesh, TrackSolid& solid) {
  std::vector<std::uint32_t> moved(mesh.vertices.size(), kNowhere);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    SolidPart& part = solid.parts[part_of(mesh.vertices[i])];
    moved[i] = static_cast<std::uint32_t>(part.positions.size());
    part.positions.push_back(mesh.vertices[i].position);
    part.normals.push_back(mesh.vertices[i].normal);
  }
  for (const std::uint32_t i : mesh.indices) solid.parts[part_of(mesh.vertices[i])].indices.push_back(moved[i]);
}

// A chord over h of the parameter deviates by at most h^2/8 of the largest second derivative, which is at one of the
// ends. Rails off the curve also wind around it: chords of 0.1 m there.
int chords(const sim::SegmentShape& shape) {
  const curve::Cubic& cubic = shape.key.cubic;
  const double bend =
      std::max(glm::length(curve::second_derivative(cubic, 0)), glm::length(curve::second_derivative(cubic, 1)));
  const double winding = shape.key.rails == 0 ? 0.0 : shape.arc.length() / 0.1,
               wanted = std::max(std::sqrt(bend / (8 * kLineTolerance)), winding);
  return static_cast<int>(std::clamp(std::ceil(wanted), 1.0, 1000.0));
}

// Calls visit(mesh) for each segment's track with its equipment, and for its supports, until one returns false.
void for_each_mesh(const world::Document& document, const sim::DerivedTrack& derived, const auto& visit) {
  sim::Ground ground;
  ground.update(document, derived, sim::track_room(sim::form_of(document.kind)));
  sim::Supports supports;
  supports.update(derived, {}, &ground);
  const sim::SolidsDetail detail = sim::detail_of(derived);
  sim::Mesh mesh;
  for (const world::Entity segment : document.track.segments) {
    const sim::SegmentShape& shape = derived.shape(segment);
    // Neighbours meet bit for bit: caps between them would be inside the tubes.
    const bool open = !document.track.closed;
    sim::sweep_track(
        shape, mesh,
        {open && segment == document.track.segments.front(), open && segment == document.track.segments.back()},
        detail);
    if (shape.fitted) sim::add_fittings(shape, *shape.fitted, mesh, detail, &ground);
    if (!visit(mesh)) return;
    const sim::SegmentSupports* const held = supports.of(segment);
    if (held == nullptr) continue;
    sim::build_support_mesh(*held, sim::form_of(shape), mesh);
    if (!visit(mesh)) return;
  }
}

// Builds the solids of every segment, in order: the swept track, its equipment, its supports. Rails and spine are
// capped only at the ends of an open track.
TrackSolid track_solid(const world::Document& document) {
  TrackSolid solid(document);
  sim::DerivedTrack derived;
  sim::derive(document, {}, {}, derived);
  for_each_mesh(document, derived, [&](const sim::Mesh& mesh) { return add_mesh(mesh, solid), true; });
  for (const world::Entity segment : document.track.segments) {
    const sim::SegmentShape& shape = derived.shape(segment);
    if (solid.centre_line.empty()) solid.centre_line.push_back(glm::vec3(sim::rails_point(shape, 0)));
    const int count = chords(shape);
    for (int i = 1; i <= count; ++i)
      solid.centre_line.push_back(glm::vec3(sim::rails_point(shape, static_cast<double>(i) / count)));
  }
  return solid;
}

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

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

// Constants of the specification.
constexpr int kFloat = 5126, kUnsigned = 5125, kVertices = 34962, kIndices = 34963, kLineStrip = 3, kTriangles = 4;

struct GltfBufferBuilder {
  Json views = Json::array(), accessors = Json::array();
  std::string bytes;  // of points and triangles: three numbers each, so that base64 needs no padding

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

Json material(std::string_view name, glm::vec3 colour) {
  return {
      {"name", name},
      {"pbrMetallicRoughness",
       {{"baseColorFactor", {colour.x, colour.y, colour.z, 1.0}}, {"metallicFactor", 0.6}, {"roughnessFactor", 0.5}}}};
}

// Adds the materials that it uses.
Json track_mesh(GltfBufferBuilder& builder, const TrackSolid& solid, Json& materials) {
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

base::Status check_solid(const world::Document& document) {
  constexpr std::size_t kFewSegments = 1000;
  constexpr double kShort = 5'000;  // m: fewer and shorter ones are far below the limit
  sim::DerivedTrack derived;
  sim::derive(document, {}, {}, derived);
  if (derived.order.size() <= kFewSegments && derived.length <= kShort) return {};
  std::size_t vertices = 0;
  for_each_mesh(document, derived, [&](const sim::Mesh& mesh) {
    vertices += mesh.vertices.size();
    return vertices <= kMostSolidVertices;
  });
  if (vertices <= kMostSolidVertices) return {};
  return {base::Code::refused,
          fmt::format("error: the solid has more than the limit of {} vertices; save some sections "
                      "of the track instead",
                      kMostSolidVertices)};
}

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

std::string obj_materials(const world::Document& document) {
  std::string out;
  const auto add = [&](std::string_view name, glm::vec3 colour) {
    out += fmt::format("newmtl {}\n", name);
    add_vector(out, "Kd", colour);
  };
  const bool timber = sim::form_of(document.kind).supports == sim::SupportForm::bent;
  for (const SolidPart& part : TrackSolid(document).parts)
    if (timber || part.name != kTimber) add(part.name, part.colour);
  add("centre_line", kLineColour);
  return out;
}

std::string print_gltf(const world::Document& document) {
  const TrackSolid solid = track_solid(document);
  Json file{{"asset", {{"version", "2.0"}, {"generator", "coaster"}}}, {"scene", 0}};
  Json scene{{"name", document.name}};
  if (!solid.centre_line.empty()) {
    GltfBufferBuilder builder;
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
                      {"uri", "data:application/octet-stream;base64," + base64(builder.bytes, "+/")}};
    file["buffers"] = Json::array({buffer});
    file["bufferViews"] = std::move(builder.views);
    file["accessors"] = std::move(builder.accessors);
  }
  file["scenes"] = Json::array({scene});
  return json_file(file, 1);
}

}  // namespace coaster::exchange
