#include "sim/solids/track_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/kinds.h"
#include "sim/solids.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace track_mesh_test {

using test::finite;
using test::inside_out;
using test::open_edges;
using test::volume;
using test::wrong_normals;

const CoasterForm& kSteel = form_of(world::CoasterKind::steel);
const double kSpineDrop = -kSteel.hold, kSpineRadius = kSteel.hold_radius, kHalfTie = kSteel.half_tie;
constexpr int kRailSides = 8, kSpineSides = 12;

Mesh swept(const SegmentShape& shape) {
  Mesh mesh;
  sweep_track(shape, mesh);
  return mesh;
}

TEST(track_mesh, tubes_enclose_the_volume_of_prisms) {
  const world::Document d = test::straight_document({3.3f, 7.1f, -2.9f}, {17.7f, 11.3f, 9.1f});
  const DerivedTrack derived = test::derived_of(d);
  const Mesh mesh = swept(derived.shape(derived.order[0]));
  const double length = glm::distance(glm::dvec3(3.3, 7.1, -2.9), glm::dvec3(17.7, 11.3, 9.1));
  const double octagon = 4 * std::sin(M_PI / 4);  // area for circumradius 1: n/2 sin(2 pi/n)
  EXPECT_NEAR(volume(mesh, Material::rail), 2 * octagon * kRailRadius * kRailRadius * length, 1e-4 * length);
  const double dodecagon = 6 * std::sin(M_PI / 6);
  EXPECT_NEAR(volume(mesh, Material::spine), dodecagon * kSpineRadius * kSpineRadius * length, 1e-4 * length);
  EXPECT_EQ(inside_out(mesh, mesh.indices), 0);
  EXPECT_EQ(inside_out(mesh, mesh.coarse), 0);
  EXPECT_EQ(wrong_normals(mesh), 0);
  EXPECT_EQ(open_edges(mesh), 0);
  EXPECT_EQ(open_edges(mesh, mesh.coarse), 0);
}

// Each arm goes from its rail to the spine's upper side and widens from 12 to 30 cm: a trapezium times its thickness.
TEST(track_mesh, every_tie_has_two_arms_from_rail_to_spine_that_mirror_each_other) {
  const DerivedTrack derived = test::derived_of(test::straight_document({1.7f, 14.3f, 2.1f}, {25.7f, 14.3f, 20.1f}));
  const Mesh mesh = swept(derived.shape(derived.order[0]));
  std::map<std::pair<float, bool>, std::vector<glm::dvec2>> arms;  // (left, up) of the corners by place and side
  for (const MeshVertex& v : mesh.vertices) {
    if (v.part != static_cast<float>(Material::tie)) continue;
    const glm::dvec3 p = glm::dvec3(v.position) - glm::dvec3(1.7, 14.3, 2.1);
    arms[{v.along, 0.6 * p.x - 0.8 * p.z > 0}].push_back({0.6 * p.x - 0.8 * p.z, p.y});
  }
  ASSERT_GT(arms.size(), 1u);
  const double reach = std::hypot(0.5 * kGauge - 0.06, kSpineDrop - 0.04), sum = (0.12 + 0.30) / 2 * reach;
  EXPECT_NEAR(volume(mesh, Material::tie), static_cast<double>(arms.size()) * sum * 2 * kHalfTie, 1e-5);
  for (const auto& [place, corners] : arms) {
    const auto other = arms.find({place.first, !place.second});
    ASSERT_NE(other, arms.end());
    for (const glm::dvec2 corner : corners)
      EXPECT_TRUE(std::any_of(other->second.begin(), other->second.end(),
                              [&](glm::dvec2 c) { return glm::distance(c, glm::dvec2(-corner.x, corner.y)) < 1e-5; }))
          << corner.x << ' ' << corner.y;
  }
}

TEST(track_mesh, normals_of_bent_track_point_outwards) {
  for (const auto& d : {test::ring_document(8, 21.3), test::sample_document(),
                        test::circle_document(7.5, {3.1, 2.2, -1.7}, {1, 0, 0.3}, 8)}) {
    const DerivedTrack derived = test::derived_of(d);
    for (const world::Entity e : derived.order) {
      const Mesh mesh = swept(derived.shape(e));
      EXPECT_TRUE(finite(mesh));
      EXPECT_EQ(wrong_normals(mesh), 0);
      EXPECT_GT(volume(mesh, Material::rail), 0);
      for (const std::uint32_t i : mesh.indices) ASSERT_LT(i, mesh.vertices.size());
    }
  }
}

// The corners of triangles, whatever their order in the mesh.
using Triangles = std::vector<std::array<std::array<double, 3>, 3>>;
void add_triangles(const Mesh& mesh, const std::vector<std::uint32_t>& indices, const auto& place, Triangles& out) {
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    std::array<std::array<double, 3>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 at = place(mesh.vertices[indices[i + k]]);
      corners[k] = {std::round(at.x * 1e3), std::round(at.y * 1e3), std::round(at.z * 1e3)};  // mm
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    out.push_back(corners);
  }
}

// As the vertex shader sweeps them. Rounding may put a corner into the next millimetre, and the first cap is cut
// otherwise.
class TrackMeshOfKind : public testing::TestWithParam<world::CoasterKind> {};
TEST_P(TrackMeshOfKind, consists_of_pieces_between_rings) {
  const CoasterForm& form = form_of(GetParam());
  const TrackPieces pieces = track_pieces(form);
  world::Document d = test::ring_document(8, 21.3);
  d.kind = GetParam();
  const DerivedTrack derived = test::derived_of(d);
  for (const world::Entity e : derived.order) {
    const SegmentShape& shape = derived.shape(e);
    Triangles wanted, found;
    const auto as_it_is = [](const MeshVertex& v) { return glm::dvec3(v.position); };
    const Mesh whole = swept(shape);
    add_triangles(whole, whole.indices, as_it_is, wanted);
    const auto sweep = [&](const Mesh& mesh, const std::vector<std::uint32_t>& indices, const Ring& from,
                           const Ring& to, Triangles& out) {
      add_triangles(
          mesh, indices,
          [&](const MeshVertex& v) {
            const Ring& at = v.along > 0.5f ? to : from;
            return at.place(-double(v.position.z), double(v.position.y)) + double(v.position.x) * at.frame.forward;
          },
          out);
    };
    const std::vector<Ring> rings = rings_of(shape);
    for (std::size_t i = 0; i + 1 < rings.size(); ++i)
      sweep(pieces.tubes, pieces.tubes.indices, rings[i], rings[i + 1], found);
    Ring back = rings.front();
    back.frame.forward = -back.frame.forward;
    sweep(pieces.caps, pieces.caps.indices, back, back, found);
    sweep(pieces.caps, pieces.caps.indices, rings.back(), rings.back(), found);
    for (const Ring& at : tie_rings(shape, {})) {
      Ring from = at, to = at;
      from.position -= form.half_tie * at.frame.forward, to.position += form.half_tie * at.frame.forward;
      sweep(pieces.tie, pieces.tie.indices, from, to, found);
    }
    ASSERT_EQ(found.size(), wanted.size());
    std::sort(wanted.begin(), wanted.end());
    int off = 0;
    for (const auto& corners : found) off += !std::binary_search(wanted.begin(), wanted.end(), corners);
    EXPECT_LT(off, int(found.size() / 10));
  }
}
INSTANTIATE_TEST_SUITE_P(all, TrackMeshOfKind, testing::ValuesIn(test::kinds()), test::kind_name);

// Whatever a kind has for rails: the wheels of all trains roll a gauge apart, kRailRadius above the rails' plane.
TEST_P(TrackMeshOfKind, has_its_running_surfaces_where_the_wheels_roll) {
  world::Document d = test::straight_document({1.7f, 14.3f, 2.1f}, {9.7f, 14.3f, 8.1f});
  d.kind = GetParam();
  const DerivedTrack derived = test::derived_of(d);
  const Mesh mesh = swept(derived.shape(derived.order[0]));
  EXPECT_TRUE(finite(mesh));
  EXPECT_EQ(inside_out(mesh, mesh.indices), 0);
  EXPECT_EQ(wrong_normals(mesh), 0);
  double top = -9, inner = 9, outer = 0, reach = 0;
  for (const MeshVertex& v : mesh.vertices) {
    const glm::dvec3 p = glm::dvec3(v.position) - glm::dvec3(1.7, 14.3, 2.1);
    const double left = 0.6 * p.x - 0.8 * p.z;
    reach = std::max(reach, std::hypot(left, p.y));
    if (v.part != static_cast<float>(Material::rail)) continue;
    top = std::max(top, p.y), inner = std::min(inner, std::abs(left)), outer = std::max(outer, std::abs(left));
  }
  EXPECT_NEAR(top, kRailRadius, 0.01);
  EXPECT_LT(inner, 0.5 * kGauge - 0.08);
  EXPECT_GT(outer, 0.5 * kGauge + 0.08);
  EXPECT_LE(reach, form_of(GetParam()).reach) << "the drawing code takes this for the track's radius";
}

TEST(track_mesh, rails_run_a_gauge_apart_on_the_rails_plane) {
  // On the straight the frame is known by hand: forward (0.8, 0, 0.6), up Y, left = up x forward = (0.6, 0, -0.8).
  const world::Document d = test::straight_document({1.7f, 4.3f, 2.1f}, {9.7f, 4.3f, 8.1f});
  const DerivedTrack derived = test::derived_of(d);
  const Mesh mesh = swept(derived.shape(derived.order[0]));
  const glm::dvec3 left(0.6, 0, -0.8), start(1.7, 4.3, 2.1);
  double widest = 0, lowest = 0;
  for (const MeshVertex& v : mesh.vertices) {
    const double x = glm::dot(glm::dvec3(v.position) - start, left), y = v.position.y - 4.3;
    if (v.part == static_cast<float>(Material::tie))
      widest = std::max(widest, std::abs(x)), lowest = std::min(lowest, y);
    if (v.part == static_cast<float>(Material::rail)) {
      EXPECT_NEAR(std::hypot(std::abs(x) - kGauge / 2, y), kRailRadius, 1e-5);
    }
    if (v.part == static_cast<float>(Material::spine)) {
      EXPECT_NEAR(std::hypot(x, y + kSpineDrop), kSpineRadius, 1e-5);
    }
  }
  // Ties end inside the rails and inside the spine.
  EXPECT_NEAR(widest, kGauge / 2, kRailRadius);
  EXPECT_NEAR(lowest, -kSpineDrop, kSpineRadius);
}

TEST(track_mesh, end_rings_of_neighbours_coincide) {
  world::Document d = test::ring_document(7, 19.1);
  for (std::size_t i = 0; i < 7; ++i)
    world::set_roll(d.entities.get<world::Knot>(d.track.knots[i]), 31.7 * static_cast<double>(i) - 90);
  d.entities.get<world::Segment>(d.track.segments[3]).turns = 2;
  const DerivedTrack derived = test::derived_of(d);
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const Mesh before = swept(derived.shape(derived.order[i])),
               after = swept(derived.shape(derived.order[(i + 1) % derived.order.size()]));
    // Each tube's last ring before the joint is its first one after it, bit for bit.
    const auto rings = [](const Mesh& mesh, Material part) {
      std::vector<const MeshVertex*> found;
      for (const MeshVertex& v : mesh.vertices)
        if (v.part == static_cast<float>(part)) found.push_back(&v);
      return found;
    };
    for (const auto& [part, tubes, sides] :
         {std::tuple{Material::rail, 2u, kRailSides}, {Material::spine, 1u, kSpineSides}}) {
      const auto a = rings(before, part), b = rings(after, part);
      for (std::size_t tube = 0; tube < tubes; ++tube)
        for (std::size_t k = 0; k < static_cast<std::size_t>(sides); ++k) {
          const MeshVertex& last = *a[(tube + 1) * a.size() / tubes - static_cast<std::size_t>(sides) + k];
          const MeshVertex& first = *b[tube * b.size() / tubes + k];
          EXPECT_EQ(last.position, first.position) << "joint " << i;
          EXPECT_EQ(last.normal, first.normal) << "joint " << i;
        }
    }
  }
}

TEST(track_mesh, rings_never_turn_by_more_than_a_quarter_and_never_flip) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const world::Document d = seed < 10    ? test::random_document(seed)
                              : seed == 10 ? test::sample_document()
                                           : test::circle_document(6.3, {1, 2, 3}, {1, 0, 0.4}, 5);
    const DerivedTrack derived = test::derived_of(d);
    for (const world::Entity e : derived.order) {
      const SegmentShape& shape = derived.shape(e);
      const std::vector<Ring> rings = rings_of(shape);
      // A turn between two of the places at which frames are kept is sharper than any ring can follow: a cusp.
      bool cusp = false;
      for (int i = 0; i < kFrameIntervals; ++i)
        cusp = cusp || glm::dot(shape.frame(i).forward, shape.frame(i + 1).forward) < 0.7;
      if (cusp) continue;
      for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
        ASSERT_GT(glm::dot(rings[i].frame.forward, rings[i + 1].frame.forward), 0)
            << seed << ' ' << i << '/' << rings.size();
        ASSERT_GT(glm::dot(rings[i].frame.up, rings[i + 1].frame.up), 0) << seed << ' ' << i << '/' << rings.size();
      }
    }
  }
}

TEST(track_mesh, degenerate_segments_give_no_nan) {
  const auto shape_of = [](glm::vec3 p, glm::vec3 q, float in, float out, glm::vec3 tangent, int turns) {
    world::Document d;
    world::append_knot(d, test::skew_knot(p, tangent, in, out));
    world::append_knot(d, test::skew_knot(q, -tangent, in, out));
    d.entities.get<world::Segment>(d.track.segments[0]).turns = turns;
    return test::derived_of(d).segments.items()[0];
  };
  const glm::vec3 p(7.3f, 1.9f, -5.7f);
  EXPECT_TRUE(finite(swept(shape_of(p, p, world::kMinHandle, world::kMinHandle, {0.3f, 0.2f, 0.9f}, 0))));
  EXPECT_TRUE(finite(swept(shape_of(p, p, 5, 5, {0, 1, 0}, 16))));
  EXPECT_TRUE(finite(swept(shape_of(p, p + glm::vec3(0, 9.1f, 0), 3, 3, {0, 1, 0}, -16))));
  EXPECT_TRUE(finite(swept(shape_of(p, p + glm::vec3(4, 0, 0), 4, 4, {-1, 0, 0}, 3))));
  EXPECT_TRUE(finite(
      swept(shape_of(glm::vec3(1e5f), glm::vec3(-1e5f), world::kMaxHandle, world::kMaxHandle, {1, 0.1f, 0}, 16))));
  SegmentShape point;  // four equal points
  point.key.cubic = {p, p, p, p};
  point.key.up_from = point.key.up_to = {0, 1, 0};
  point.arc = curve::ArcLengthMap(point.key.cubic);
  point.ups.fill({0, 1, 0});
  EXPECT_TRUE(finite(swept(point)));
}

TEST(track_mesh, rings_follow_bend_and_twist_within_their_cap) {
  const auto rings = [](const world::Document& d) {
    const DerivedTrack derived = test::derived_of(d);
    const Mesh mesh = swept(derived.shape(derived.order[0]));
    std::size_t spine = 0;
    for (const MeshVertex& v : mesh.vertices) spine += v.part == static_cast<float>(Material::spine);
    return spine / kSpineSides;
  };
  world::Document straight = test::straight_document({1.1f, 2.3f, 3.7f}, {81.1f, 2.3f, 3.7f});
  EXPECT_EQ(rings(straight), 2u);
  straight.entities.get<world::Segment>(straight.track.segments[0]).turns = 2;
  EXPECT_NEAR(static_cast<double>(rings(straight)), 720 / 6 + 1, 1.0);
  straight.entities.get<world::Segment>(straight.track.segments[0]).turns = 16;
  EXPECT_EQ(rings(straight), static_cast<std::size_t>(kMaxRings));
  // A chord over b radians of a circle of radius r is off by r b^2 / 8; a cubic's bend is spread a little unevenly.
  for (const auto& [radius, count] : {std::pair{5.0, 8}, {40.0, 16}}) {
    const double chord = std::sqrt(8 * radius * kSagitta);
    EXPECT_NEAR(static_cast<double>(rings(test::circle_document(radius, {1, 2, 3}, {1, 0, 0}, count))),
                2 * M_PI * radius / count / chord + 1.5, 1.0);
  }
  // 90 degrees over 1571 m: the greatest distance decides.
  EXPECT_NEAR(static_cast<double>(rings(test::circle_document(1000.0, {1, 2, 3}, {1, 0, 0}, 4))), 1570.8 / 4 + 1.5,
              1.0);
}

TEST(track_mesh, five_thousand_segments_stay_under_three_million_vertices) {
  // A ring of 20 m radius bends as much as coasters do; one of its 10 m segments counts for 5,000.
  const int count = 13;
  world::Document ring = test::ring_document(count, 20.0, 2.0);
  set_automatic_spins(ring);
  const DerivedTrack derived = test::derived_of(ring);
  std::size_t vertices = 0;
  for (const world::Entity e : derived.order) vertices += swept(derived.shape(e)).vertices.size();
  EXPECT_GT(derived.length / count, 9.6);
  EXPECT_LT(vertices * 5000 / count, 3'000'000u);
}

Mesh fitted(const SegmentShape& shape, world::EquipmentKind kind) {
  Mesh mesh;
  add_fittings(shape, kind, mesh);
  return mesh;
}
constexpr world::EquipmentKind kKinds[] = {world::EquipmentKind::station, world::EquipmentKind::lift,
                                           world::EquipmentKind::launch, world::EquipmentKind::brake,
                                           world::EquipmentKind::block};

TEST(fittings, are_closed_solids_that_face_outwards) {
  for (const auto& d :
       {test::ring_document(8, 21.3), test::straight_document({3.3f, 7.1f, -2.9f}, {17.7f, 9.3f, 9.1f})}) {
    const DerivedTrack derived = test::derived_of(d);
    for (const world::EquipmentKind kind : kKinds) {
      const Mesh mesh = fitted(derived.shape(derived.order[0]), kind);
      if (kind == world::EquipmentKind::station && derived.closed) continue;  // on a slope
      ASSERT_FALSE(mesh.indices.empty());
      EXPECT_TRUE(finite(mesh));
      EXPECT_EQ(open_edges(mesh), 0) << static_cast<int>(kind);
      EXPECT_EQ(open_edges(mesh, mesh.coarse), 0);
      EXPECT_EQ(inside_out(mesh, mesh.indices), 0) << static_cast<int>(kind);
      EXPECT_EQ(inside_out(mesh, mesh.coarse), 0) << static_cast<int>(kind);
      EXPECT_EQ(wrong_normals(mesh), 0);
      EXPECT_LT(mesh.coarse.size(), mesh.indices.size());
    }
  }
}

// Left and up of a straight's vertices, by hand: forward (0.8, 0, 0.6), left (0.6, 0, -0.8).
TEST(fittings, leave_the_way_of_wheels_and_cars_free) {
  const world::Document d = test::straight_document({1.7f, 14.3f, 2.1f}, {25.7f, 14.3f, 20.1f});
  const DerivedTrack derived = test::derived_of(d);
  for (const world::EquipmentKind kind : kKinds) {
    for (const MeshVertex& v : fitted(derived.shape(derived.order[0]), kind).vertices) {
      const glm::dvec3 p = glm::dvec3(v.position) - glm::dvec3(1.7, 14.3, 2.1);
      const double left = std::abs(0.6 * p.x - 0.8 * p.z), up = p.y;
      // Beside wheels and body, below both, or between the rails under the car's floor.
      EXPECT_TRUE(left > 1.0 || up < -0.3 || (left < 0.37 && up < 0.13))
          << static_cast<int>(kind) << ' ' << left << ' ' << up;
    }
  }
}

TEST(fittings, each_kind_has_its_own_parts_and_none_to_stand_on_where_nobody_can) {
  const auto has = [](const Mesh& mesh, Material part) {
    return std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                       [&](const MeshVertex& v) { return v.part == static_cast<float>(part); });
  };
  const DerivedTrack flat = test::derived_of(test::straight_document({1.7f, 4.3f, 2.1f}, {25.7f, 4.9f, 20.1f}));
  const DerivedTrack steep = test::derived_of(test::straight_document({1.7f, 4.3f, 2.1f}, {6.7f, 34.9f, 5.1f}));
  const SegmentShape &level = flat.shape(flat.order[0]), &rising = steep.shape(steep.order[0]);
  EXPECT_TRUE(has(fitted(level, world::EquipmentKind::lift), Material::chain) &&
              has(fitted(level, world::EquipmentKind::lift), Material::deck));
  EXPECT_TRUE(has(fitted(rising, world::EquipmentKind::lift), Material::chain));
  EXPECT_FALSE(has(fitted(rising, world::EquipmentKind::lift), Material::deck));
  EXPECT_TRUE(has(fitted(level, world::EquipmentKind::launch), Material::stator));
  EXPECT_TRUE(has(fitted(level, world::EquipmentKind::brake), Material::fin) &&
              has(fitted(level, world::EquipmentKind::block), Material::fin));
  EXPECT_TRUE(has(fitted(level, world::EquipmentKind::station), Material::concrete));
  EXPECT_TRUE(fitted(rising, world::EquipmentKind::station).vertices.empty());
}

TEST(fittings, degenerate_segments_show_none) {
  const glm::vec3 p(7.3f, 1.9f, -5.7f);
  world::Document d;
  world::append_knot(d, test::skew_knot(p, {0.3f, 0.2f, 0.9f}, world::kMinHandle, world::kMinHandle));
  world::append_knot(d, test::skew_knot(p, {0.3f, 0.2f, 0.9f}, world::kMinHandle, world::kMinHandle));
  const DerivedTrack derived = test::derived_of(d);
  for (const world::EquipmentKind kind : kKinds)
    EXPECT_TRUE(fitted(derived.shape(derived.order[0]), kind).vertices.empty());
}

}  // namespace track_mesh_test
}  // namespace coaster::sim
