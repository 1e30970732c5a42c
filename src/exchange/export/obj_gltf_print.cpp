// Prints the whole track as triangles and a line, and its park: Wavefront OBJ and glTF 2.0.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"
#include "exchange/export/shape_export.h"
#include "exchange/export/solid_parts_detail.h"
#include "exchange/own/json.h"
#include "exchange/own/share_link.h"
#include "sim/ground/ground.h"
#include "sim/shape/rails.h"
#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"
#include "world/document.h"
#include "world/sections.h"

namespace coaster::exchange {
namespace {

constexpr const char* kTimber = "timber";
constexpr glm::vec3 kLineColour{1, 0.8f, 0};  // of the centre line

// The segments' shapes, and the ground that they are built on.
struct Site {
  sim::DerivedTrack derived;
  sim::Ground ground;
  explicit Site(const world::Document& document) {
    sim::derive(document, {}, {}, derived);
    ground.update(document, derived, sim::track_room(sim::form_of(document.kind)));
  }
};

constexpr std::size_t kPartCount = 7;
using PartIndices = std::array<std::size_t, kPartCount>;  // into TrackSolid::parts, in the order of part_of()

struct TrackSolid {
  // First one part for each material, with the colours of the track's paint; then those that sections paint.
  std::vector<SolidPart> parts{{"rails", {0.75f, 0.1f, 0.08f}},    {"spine", {0.2f, 0.25f, 0.35f}},
                               {"ties", {0.45f, 0.47f, 0.5f}},     {"equipment", {0.3f, 0.33f, 0.36f}},
                               {"supports", {0.8f, 0.81f, 0.83f}}, {"concrete", {0.46f, 0.48f, 0.46f}},
                               {kTimber, {0.17f, 0.09f, 0.04f}}};
  std::map<world::Entity, PartIndices> painted;  // by section, of those with paint of their own
  std::vector<glm::vec3> centre_line;            // a closed track's line ends at its start; empty without segments

  explicit TrackSolid(const world::Document& document) {
    paint(kTrackParts, world::over(document.paint, base::row_of(document.kind).paint));
    for (const world::SectionRun& run : world::sections_of(document)) {
      if (!run.section.valid()) continue;
      const world::Paint own = world::section(document, run.section).paint;
      if (own == world::Paint{} || painted.contains(run.section)) continue;
      PartIndices indices = kTrackParts;
      for (const auto& [part, colour] : kPaints) {
        if (!(own.*colour).own()) continue;
        indices[part] = parts.size();
        parts.push_back(parts[part]);
        parts.back().name += '_' + world::to_text(world::name_of(document, run.section));
      }
      paint(indices, own);
      painted.emplace(run.section, indices);
    }
  }

 private:
  static constexpr PartIndices kTrackParts{0, 1, 2, 3, 4, 5, 6};
  static constexpr std::pair<std::size_t, world::Colour world::Paint::*> kPaints[] = {
      {0, &world::Paint::rails}, {1, &world::Paint::spine}, {2, &world::Paint::spine}, {4, &world::Paint::supports}};
  void paint(const PartIndices& indices, const world::Paint& paint) {
    for (const auto& [part, colour] : kPaints)
      if ((paint.*colour).own()) parts[indices[part]].colour = linear(paint.*colour);
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

void add_mesh(const sim::Mesh& mesh, world::Entity section, TrackSolid& solid) {
  const auto own = solid.painted.find(section);
  const auto place = [&](const sim::MeshVertex& vertex) -> SolidPart& {
    const std::size_t part = part_of(vertex);
    return solid.parts[own == solid.painted.end() ? part : own->second[part]];
  };
  std::vector<std::uint32_t> moved(mesh.vertices.size(), kNowhere);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    SolidPart& part = place(mesh.vertices[i]);
    moved[i] = static_cast<std::uint32_t>(part.positions.size());
    part.positions.push_back(mesh.vertices[i].position);
    part.normals.push_back(mesh.vertices[i].normal);
  }
  for (const std::uint32_t i : mesh.indices) place(mesh.vertices[i]).indices.push_back(moved[i]);
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

// Calls visit(mesh, segment) for each segment's track with its equipment, and for its supports, until one returns
// false.
void for_each_mesh(const world::Document& document, const Site& site, const auto& visit) {
  sim::Supports supports;
  supports.update(site.derived, {}, &site.ground);
  const sim::SolidsDetail detail = sim::detail_of(site.derived);
  sim::Mesh mesh;
  for (const world::Entity segment : document.track.segments) {
    const sim::SegmentShape& shape = site.derived.shape(segment);
    // Neighbours meet bit for bit: caps between them would be inside the tubes.
    const bool open = !document.track.closed;
    sim::sweep_track(
        shape, mesh,
        {open && segment == document.track.segments.front(), open && segment == document.track.segments.back()},
        detail);
    if (shape.fitted) sim::add_fittings(shape, *shape.fitted, mesh, detail, &site.ground);
    if (!visit(mesh, segment)) return;
    const sim::SegmentSupports* const held = supports.of(segment);
    if (held == nullptr) continue;
    sim::build_support_mesh(*held, sim::form_of(shape), mesh);
    if (!visit(mesh, segment)) return;
  }
}

// Builds the solids of every segment, in order: the swept track, its equipment, its supports. Rails and spine are
// capped only at the ends of an open track.
TrackSolid track_solid(const world::Document& document, const Site& site) {
  TrackSolid solid(document);
  for_each_mesh(document, site, [&](const sim::Mesh& mesh, world::Entity segment) {
    return add_mesh(mesh, world::segment(document, segment).section, solid), true;
  });
  for (const world::Entity segment : document.track.segments) {
    const sim::SegmentShape& shape = site.derived.shape(segment);
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

Json material(const SolidPart& part) {
  const glm::vec3 colour = part.colour;
  Json made{{"name", part.name},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {colour.x, colour.y, colour.z, part.opacity}},
              {"metallicFactor", part.metallic},
              {"roughnessFactor", part.roughness}}}};
  if (part.opacity < 1) made["alphaMode"] = "BLEND";
  return made;
}

struct GltfScene {
  GltfBufferBuilder builder;
  Json roots = Json::array(), nodes = Json::array(), meshes = Json::array(), materials = Json::array();

  // Adds a mesh and returns its index.
  std::size_t mesh(std::string_view name, Json primitives) {
    meshes.push_back({{"name", name}, {"primitives", std::move(primitives)}});
    return meshes.size() - 1;
  }
  void root(Json node) {
    roots.push_back(nodes.size());
    nodes.push_back(std::move(node));
  }
  // Returns primitives of those parts that are not empty, and adds their materials.
  Json primitives(std::span<const SolidPart> parts) {
    Json made = Json::array();
    for (const SolidPart& part : parts) {
      if (part.indices.empty()) continue;
      Json attributes{{"POSITION", builder.positions(part.positions)}};
      attributes["NORMAL"] = builder.add(std::span(part.normals), kFloat, kVertices, {{"type", "VEC3"}});
      if (!part.colours.empty())
        attributes["COLOR_0"] = builder.add(std::span(part.colours), kFloat, kVertices, {{"type", "VEC3"}});
      const std::size_t indices = builder.add(std::span(part.indices), kUnsigned, kIndices, {{"type", "SCALAR"}});
      made.push_back({{"attributes", std::move(attributes)},
                      {"indices", indices},
                      {"material", materials.size()},
                      {"mode", kTriangles}});
      materials.push_back(material(part));
    }
    return made;
  }
};

// Adds one mesh for each kind of plants, and a node for each plant.
void add_plants(GltfScene& scene, const PlantParts& parts) {
  if (parts.plants.empty()) return;
  const auto rounded = [](float x) { return std::round(1000.0 * double{x}) / 1000; };
  const std::size_t mesh = scene.mesh(parts.model.name, scene.primitives({&parts.model, 1}));
  Json children = Json::array();
  for (const sim::Plant& plant : parts.plants) {
    // A turn from x towards z is one about -y.
    const double cosine = std::sqrt(0.5 * std::max(1 + double{plant.turn.x}, 0.0)),
                 sine = std::copysign(std::sqrt(0.5 * std::max(1 - double{plant.turn.x}, 0.0)), -double{plant.turn.y}),
                 size = rounded(plant.size);
    children.push_back(scene.nodes.size());
    scene.nodes.push_back({{"mesh", mesh},
                           {"translation", {rounded(plant.foot.x), rounded(plant.foot.y), rounded(plant.foot.z)}},
                           {"rotation", {0, sine, 0, cosine}},
                           {"scale", {size, size, size}}});
  }
  scene.root({{"name", parts.model.name}, {"children", std::move(children)}});
}

std::string gltf_of(const world::Document& document, bool with_park) {
  const Site site(document);
  const TrackSolid solid = track_solid(document, site);
  GltfScene scene;
  if (!solid.centre_line.empty()) {
    scene.root({{"name", "track"}, {"mesh", scene.mesh("track", scene.primitives(solid.parts))}});
    const Json attributes{{"POSITION", scene.builder.positions(solid.centre_line)}};
    const Json strip{{"attributes", attributes}, {"material", scene.materials.size()}, {"mode", kLineStrip}};
    scene.root({{"name", "centre line"}, {"mesh", scene.mesh("centre line", Json::array({strip}))}});
    scene.materials.push_back(material({"centre line", kLineColour}));
  }
  if (with_park) {
    const ParkSolid park = park_solid(document, site.derived, site.ground, true);
    scene.root({{"name", "park"}, {"mesh", scene.mesh("park", scene.primitives(park.parts))}});
    for (const PlantParts& plants : park.plants) add_plants(scene, plants);
  }
  Json file{{"asset", {{"version", "2.0"}, {"generator", "coaster"}}}, {"scene", 0}};
  Json root{{"name", document.name}};
  if (!scene.roots.empty()) {
    root["nodes"] = std::move(scene.roots);
    file["nodes"] = std::move(scene.nodes);
    file["meshes"] = std::move(scene.meshes);
    file["materials"] = std::move(scene.materials);
    const Json buffer{{"byteLength", scene.builder.bytes.size()},
                      {"uri", "data:application/octet-stream;base64," + base64(scene.builder.bytes, "+/")}};
    file["buffers"] = Json::array({buffer});
    file["bufferViews"] = std::move(scene.builder.views);
    file["accessors"] = std::move(scene.builder.accessors);
  }
  file["scenes"] = Json::array({root});
  return json_file(file, 1);
}

// Returns a number of 0..1 of linear light as shown on screen, with three decimals.
float shown(float light) {
  const float c = light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
  return std::round(1000 * c) / 1000;
}

// Adds a group; `before`: the number of its first vertex, counted from 1 over all groups, and then of the next one's.
void add_group(std::string& out, const SolidPart& part, std::size_t& before) {
  if (part.indices.empty()) return;
  out += fmt::format("g {0}\nusemtl {0}\n", part.name);
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    add_vector(out, "v", part.positions[i]);
    if (part.colours.empty()) continue;
    out.pop_back();
    const glm::vec3 light = part.colours[i];
    add_vector(out, "", {shown(light.x), shown(light.y), shown(light.z)});
  }
  for (const glm::vec3 n : part.normals) add_vector(out, "vn", n);
  for (std::size_t i = 0; i < part.indices.size(); ++i) {
    const std::string number = std::to_string(before + part.indices[i]);
    out += fmt::format("{}{}//{}{}", i % 3 == 0 ? "f " : " ", number, number, i % 3 == 2 ? "\n" : "");
  }
  before += part.positions.size();
}

std::string obj_of(const world::Document& document, bool with_park) {
  const Site site(document);
  const TrackSolid solid = track_solid(document, site);
  std::string out = fmt::format("# Track in metres, Y up\no {}\n", one_line(document.name));
  std::size_t before = 1;
  for (const SolidPart& part : solid.parts) add_group(out, part, before);
  if (with_park) {
    const ParkSolid park = park_solid(document, site.derived, site.ground, false);
    for (const SolidPart& part : park.parts) add_group(out, part, before);
    for (const PlantParts& plants : park.plants) add_group(out, planted(plants), before);
  }
  if (solid.centre_line.empty()) return out;
  out += "g centre_line\nusemtl centre_line\n";
  for (const glm::vec3 p : solid.centre_line) add_vector(out, "v", p);
  out += "l";
  for (std::size_t i = 0; i < solid.centre_line.size(); ++i) out += fmt::format(" {}", before + i);
  return out + "\n";
}

}  // namespace

base::Status check_solid(const world::Document& document) {
  constexpr std::size_t kFewSegments = 1000;
  constexpr double kShort = 5'000;  // m: fewer and shorter ones are far below the limit
  const Site site(document);
  if (site.derived.order.size() <= kFewSegments && site.derived.length <= kShort) return {};
  std::size_t vertices = 0;
  for_each_mesh(document, site, [&](const sim::Mesh& mesh, world::Entity) {
    vertices += mesh.vertices.size();
    return vertices <= kMostSolidVertices;
  });
  if (vertices <= kMostSolidVertices) return {};
  return {base::Code::refused,
          fmt::format("error: the solid has more than the limit of {} vertices; save some sections "
                      "of the track instead",
                      kMostSolidVertices)};
}

std::string print_obj(const world::Document& document) { return obj_of(document, false); }
std::string print_obj_park(const world::Document& document) { return obj_of(document, true); }
std::string print_gltf(const world::Document& document) { return gltf_of(document, false); }
std::string print_gltf_park(const world::Document& document) { return gltf_of(document, true); }

std::string obj_materials(const world::Document& document, bool with_park) {
  std::string out;
  const auto add = [&](const SolidPart& part) {
    out += fmt::format("newmtl {}\n", part.name);
    add_vector(out, "Kd", part.colour);
    if (part.opacity < 1) out += fmt::format("d {}\n", part.opacity);
  };
  const bool timber = sim::form_of(document.kind).supports == sim::SupportForm::bent;
  for (const SolidPart& part : TrackSolid(document).parts)
    if (timber || part.name != kTimber) add(part);
  add({"centre_line", kLineColour});
  if (!with_park) return out;
  const ParkSolid park;
  for (const SolidPart& part : park.parts) add(part);
  for (const PlantParts& plants : park.plants) add(plants.model);
  return out;
}

}  // namespace coaster::exchange
