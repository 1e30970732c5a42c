// Rails below the curve: points, directions and meshes compared with the curve and its `up`, computed by hand.
#include "sim/shape/rails.h"

#include <sstream>

#include <gtest/gtest.h>

#include "exchange/nolimits/nl2_csv.h"
#include "sim/ride/ride.h"
#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace rails_test {

using glm::dvec3;

world::Document heartline_document() {
  world::Document d = test::sample_document();
  d.curve = world::TrackCurve::heartline;
  d.heartline = 1.3;
  return d;
}

dvec3 below(const SegmentShape& shape, double s, double height) {
  return curve::point(shape.key.cubic, shape.arc.parameter(s)) - height * frame_at(shape, s).up;
}

TEST(rails, are_the_curve_or_below_it_by_the_heartline) {
  world::Document d = test::sample_document();
  EXPECT_EQ(world::rails_height(d), 0);
  EXPECT_EQ(world::riders_height(d), d.heartline);
  d.curve = world::TrackCurve::heartline;
  EXPECT_EQ(world::rails_height(d), -d.heartline);
  EXPECT_EQ(world::riders_height(d), 0);
}

// The closed form of the direction against differences of points.
TEST(rails, run_along_their_own_tangent) {
  const world::Document d = heartline_document();
  const DerivedTrack derived = test::derived_of(d);
  double most = 0;
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const SegmentShape& shape = derived.shape_at(i);
    const double length = shape.arc.length(), step = 1e-3 * length;
    for (int k = 1; k < 40; ++k) {
      const double s = length * k / 40;
      const dvec3 rails = below(shape, s, 1.3);
      EXPECT_LT(glm::distance(rails_at(shape, s), rails), 1e-12);
      EXPECT_LT(glm::distance(rails_point(shape, shape.arc.parameter(s)), rails), 1e-9);
      const dvec3 way = (below(shape, s + step, 1.3) - below(shape, s - step, 1.3)) / (2 * step);
      const OffsetPoint at = offset_point(shape, s, -1.3);
      EXPECT_LT(glm::distance(at.tangent(), glm::normalize(way)), 2e-4) << i << " " << s;
      EXPECT_NEAR(at.stretch(), glm::length(way), 2e-4) << i << " " << s;
      const curve::Frame frame = rails_frame_at(shape, s);
      EXPECT_LT(std::abs(glm::dot(frame.forward, frame.up)), 1e-12);
      most = std::max(most, glm::distance(frame.forward, frame_at(shape, s).forward));
    }
  }
  EXPECT_GT(most, 0.05);  // the curve's direction is another one
}

// The spin of rails about the curve, seen from a rotation-minimising frame that is carried along the rails.
TEST(rails, spin_about_their_own_tangent) {
  const world::Document d = heartline_document();
  const DerivedTrack derived = test::derived_of(d);
  const SegmentShape& shape = derived.shape_at(2);
  const double length = shape.arc.length();
  double roll = 0, wanted = 0;
  curve::Frame carried{offset_point(shape, 0, -1.3).tangent(), frame_at(shape, 0).up};
  const int steps = 20'000;
  for (int i = 0; i < steps; ++i) {
    const double s = length * i / steps, next = length * (i + 1) / steps;
    carried = curve::transport(carried, below(shape, s, 1.3), below(shape, next, 1.3),
                               offset_point(shape, next, -1.3).tangent());
    const OffsetPoint middle = offset_point(shape, 0.5 * (s + next), -1.3);
    wanted += middle.spin * middle.stretch() * (next - s);
    const dvec3 up = frame_at(shape, next).up;
    const double turned = curve::signed_angle(carried.up, up, carried.forward);
    roll += std::remainder(turned - roll, 2 * M_PI);
  }
  EXPECT_NEAR(roll, wanted, 2e-3);
  EXPECT_GT(std::abs(wanted), 3);
}

// Every vertex of a rail is on a tube next to the line below the curve.
TEST(rails, have_their_mesh_below_the_curve) {
  const world::Document d = heartline_document();
  const DerivedTrack derived = test::derived_of(d);
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const SegmentShape& shape = derived.shape_at(i);
    Mesh mesh;
    sweep_track(shape, mesh, {false, false});
    int vertices = 0;
    for (const MeshVertex& v : mesh.vertices) {
      if (static_cast<Material>(static_cast<int>(v.part)) != Material::rail) continue;
      const double s = static_cast<double>(v.along) * shape.arc.length();
      const curve::Frame frame = frame_at(shape, s);
      const dvec3 off = dvec3(v.position) - below(shape, s, 1.3);
      const double side = glm::dot(off, frame.left()) > 0 ? 0.5 : -0.5;
      EXPECT_NEAR(glm::distance(off, side * kGauge * frame.left()), kRailRadius, 1e-3) << i << " " << s;
      ++vertices;
    }
    EXPECT_GT(vertices, 100);
  }
}

TEST(rails, carry_the_cars_and_the_supports) {
  world::Document d = heartline_document();
  const DerivedTrack derived = test::derived_of(d);
  const TrackPlace place{1, 0.4 * derived.shape_at(1).arc.length()};
  for (const world::FrameMethod method : {world::FrameMethod::knots, world::FrameMethod::world_up})
    EXPECT_LT(glm::distance(pose(derived, place, method).position, below(derived.shape_at(1), place.s, 1.3)), 1e-12);
  Supports supports;
  supports.update(derived);
  ASSERT_GT(supports.count(), 0);
  for (std::size_t i = 0; i < derived.order.size(); ++i)
    for (const Ring& ring : supports.of(derived.order[i])->holds) {
      const SegmentShape& shape = derived.shape_at(i);
      const double s = static_cast<double>(ring.along) * shape.arc.length();
      EXPECT_LT(glm::distance(ring.position, below(shape, s, 1.3)), 1e-3);
    }
  d.heartline = 0.4;  // another height moves the rails: every shape is built again
  DerivedTrack again = derived;
  derive(d, {}, {}, again);
  EXPECT_EQ(again.rebuilds, static_cast<int>(again.order.size()));
  EXPECT_LT(glm::distance(rails_at(again.shape_at(0), 3), below(derived.shape_at(0), 3, 0.4)), 1e-12);
}

// Rows every 0.05 m of the curve, read by the standard library; Front is the direction from row to row.
TEST(rails, are_the_rows_of_a_csv) {
  const world::Document d = heartline_document();
  const DerivedTrack derived = test::derived_of(d);
  std::istringstream in(exchange::print_nl2_csv(d, exchange::kNl2Spacing));
  std::string line;
  std::getline(in, line);
  dvec3 last(0);
  int rows = 0;
  for (double number = 0; in >> number; ++rows) {
    dvec3 at, front, left, up;
    for (dvec3* v : {&at, &front, &left, &up}) in >> v->x >> v->y >> v->z;
    const double distance = std::min(rows * exchange::kNl2Spacing, derived.length);
    const TrackPlace place = place_at(derived, distance);
    const SegmentShape& shape = derived.shape_at(place.index);
    EXPECT_LT(glm::distance(at, below(shape, place.s, 1.3)), 2e-6) << rows;
    EXPECT_LT(glm::distance(up, frame_at(shape, place.s).up), 2e-6) << rows;
    EXPECT_LT(glm::distance(left, glm::cross(up, front)), 1e-5) << rows;
    const bool inside = place.s > 0.06 && place.s < shape.arc.length() - 0.01;
    if (inside) {
      EXPECT_LT(glm::distance(front, glm::normalize(at - last)), 0.02) << rows;
    }
    last = at;
  }
  EXPECT_NEAR(rows * exchange::kNl2Spacing, derived.length, 2 * exchange::kNl2Spacing);
}

}  // namespace rails_test
}  // namespace coaster::sim
