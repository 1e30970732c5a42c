// Builds all segments and sorts the triangles by part; the centre line has as many chords as its curvature needs.
#include "exchange/export/track_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "exchange/export/track_shapes.h"
#include "sim/shape/rails.h"
#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"

namespace coaster::exchange {
namespace {

constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

std::size_t part_of(const sim::MeshVertex& vertex) {
  switch (static_cast<sim::Part>(static_cast<int>(vertex.part))) {
    case sim::Part::rail: return 0;
    case sim::Part::spine: return 1;
    case sim::Part::tie: return 2;
    case sim::Part::support: return 4;
    case sim::Part::concrete: return 5;
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
void for_each_mesh(const world::Document& document, const sim::Derived& derived, const auto& visit) {
  sim::Supports supports;
  supports.update(derived);
  const sim::Detail detail = sim::detail_of(derived);
  sim::Mesh mesh;
  for (const world::Entity segment : document.track.segments) {
    const sim::SegmentShape& shape = derived.shape(segment);
    // Neighbours meet bit for bit: caps between them would be inside the tubes.
    const bool open = !document.track.closed;
    sim::sweep_track(
        shape, mesh,
        {open && segment == document.track.segments.front(), open && segment == document.track.segments.back()},
        detail);
    if (shape.fitted) sim::add_fittings(shape, *shape.fitted, mesh, detail);
    if (!visit(mesh)) return;
    const sim::SegmentSupports* const held = supports.of(segment);
    if (held == nullptr) continue;
    sim::build_support_mesh(*held, mesh);
    if (!visit(mesh)) return;
  }
}

}  // namespace

TrackSolid track_solid(const world::Document& document) {
  TrackSolid solid;
  sim::Derived derived;
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

base::Status check_solid(const world::Document& document) {
  constexpr std::size_t kFewSegments = 1000;
  constexpr double kShort = 5'000;  // m: fewer and shorter ones are far below the limit
  sim::Derived derived;
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

}  // namespace coaster::exchange
