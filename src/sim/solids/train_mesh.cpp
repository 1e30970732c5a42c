#include "sim/solids/train_mesh.h"

#include <algorithm>

#include "base/check.h"
#include "base/portable_math.h"
#include "sim/solids/track_mesh.h"

namespace coaster::sim {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr curve::Frame kAhead{{1, 0, 0}, {0, 1, 0}};

void add_block(dvec3 low, dvec3 high, Material part, Mesh& mesh) {
  add_box(0.5 * (low + high), kAhead, 0.5 * (high - low), part, 0, true, mesh);
}

// Adds a block whose upper face is shifted by `lean` along X.
void add_leaning(dvec3 low, dvec3 high, double lean, Material part, Mesh& mesh) {
  const auto face = [&](double x) {
    return std::array{dvec3(x, low.y, high.z), dvec3(x, low.y, low.z), dvec3(x + lean, high.y, low.z),
                      dvec3(x + lean, high.y, high.z)};
  };
  add_prism(face(high.x), face(low.x), part, 0, true, mesh);
}

// A cross-section of the body: a rounded rectangle with a stripe on each side and on top.
struct BodySection {
  double x, low, high, half_width;
};
constexpr int kCorner = 3;  // steps of a rounded corner
constexpr double kStripeLow = 0.38, kStripeHigh = 0.60,
                 kTopStripe = 0.16;  // fractions of the height, and of half the width

std::vector<dvec3> outline(const BodySection& s) {
  std::vector<dvec3> out;
  const double round = std::min(0.32 * (s.high - s.low), 0.35 * s.half_width), height = s.high - s.low;
  const auto point = [&](double left, double y) { out.push_back({s.x, y, -left}); };
  const auto corner = [&](double left, double y, int quarter) {
    for (int i = 0; i <= kCorner; ++i) {
      const base::SinCos turn = base::sin_cos(0.5 * base::kPi * (quarter + static_cast<double>(i) / kCorner));
      point(left + round * turn.cos, y + round * turn.sin);
    }
  };
  const double w = s.half_width - round;
  corner(w, s.low + round, 3);
  point(s.half_width, s.low + kStripeLow * height), point(s.half_width, s.low + kStripeHigh * height);
  corner(w, s.high - round, 0);
  point(kTopStripe * s.half_width, s.high), point(-kTopStripe * s.half_width, s.high);
  corner(-w, s.high - round, 1);
  point(-s.half_width, s.low + kStripeHigh * height), point(-s.half_width, s.low + kStripeLow * height);
  corner(-w, s.low + round, 2);
  return out;
}

// Adds a solid through sections of equally many corners, back to front, counter-clockwise as seen from the front;
// smooth except at both ends. parts[k] is the strip between corners k and k + 1.
void add_loft(std::span<const std::vector<dvec3>> sections, std::span<const Material> parts, Mesh& mesh) {
  const std::size_t count = parts.size(), rows = sections.size();
  // Normals of corners: the area-weighted sum of the adjacent faces' normals.
  std::vector<dvec3> normals(rows * count, dvec3(0));
  for (std::size_t row = 0; row + 1 < rows; ++row)
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t next = (k + 1) % count;
      const dvec3 area =
          glm::cross(sections[row + 1][next] - sections[row][k], sections[row + 1][k] - sections[row][next]);
      for (const std::size_t corner :
           {row * count + k, row * count + next, (row + 1) * count + k, (row + 1) * count + next})
        normals[corner] += area;
    }
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = (k + 1) % count;
    for (std::size_t row = 0; row < rows; ++row) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const std::size_t corner : {k, next}) {
        COASTER_CHECK(sections[row].size() == count, "all sections have the same number of corners");
        const dvec3 normal = normals[row * count + corner];
        mesh.vertices.push_back(
            {glm::vec3(sections[row][corner]), glm::vec3(glm::normalize(normal)), static_cast<float>(parts[k])});
      }
      if (row > 0) mesh.add_triangles({first - 2, first - 1, first, first - 1, first + 1, first}, true);
    }
  }
  add_face(sections.back(), parts[0], 0, true, mesh);
  add_face(std::vector<dvec3>(sections.front().rbegin(), sections.front().rend()), parts[0], 0, true, mesh);
}

void add_body(std::span<const BodySection> sections, Mesh& mesh) {
  constexpr std::size_t kArc = kCorner + 1;
  std::vector<std::vector<dvec3>> rows;
  for (const BodySection& section : sections) rows.push_back(outline(section));
  std::vector<Material> parts(rows[0].size(), Material::body);
  parts[kArc] = parts[2 * kArc + 2] = parts[3 * kArc + 4] = Material::stripe;
  add_loft(rows, parts, mesh);
}

// Adds a wheel about an axis along Z or Y, with a hub on the outside.
void add_wheel(dvec3 middle, dvec3 half_axis, double radius, Mesh& mesh) {
  constexpr int kWheelSides = 16;
  add_bar(middle - half_axis, middle + half_axis, radius, radius, kWheelSides, Material::wheel, 0, true, mesh);
  add_bar(middle + half_axis, middle + 1.12 * half_axis, 0.5 * radius, 0.45 * radius, 10, Material::fin, 0, false,
          mesh);
}

// Adds wheels above, next to and below one rail, and their bogie.
void add_bogie(double x, double side, Mesh& mesh) {
  constexpr double kRoad = 0.15, kGuide = 0.09, kUnder = 0.085, kHalf = 0.05, kPlate = 0.93;
  const double rail = 0.5 * kGauge;
  const auto at = [&](double along, double y, double out) { return dvec3(x + along, y, side * out); };
  const dvec3 outward(0, 0, side * kHalf);
  for (const double along : {-0.17, 0.17}) {
    add_wheel(at(along, kRailRadius + kRoad, rail), outward, kRoad, mesh);
    add_wheel(at(along, 0, rail + kRailRadius + kGuide), {0, 0.8 * kHalf, 0}, kGuide, mesh);
  }
  add_wheel(at(0, -kRailRadius - kUnder, rail), outward, kUnder, mesh);
  const double axle = kRailRadius + kRoad;
  add_box(at(0, 0.5 * (axle - 0.26), kPlate - 0.015), kAhead, {0.07, 0.5 * (axle + 0.26) - 0.02, 0.018}, Material::tie,
          0, true, mesh);
  add_box(at(0, axle + 0.01, kPlate - 0.015), kAhead, {0.22, 0.032, 0.02}, Material::tie, 0, true, mesh);
  for (const double along : {-0.17, 0.17})
    add_bar(at(along, axle, 0.3), at(along, axle, kPlate), 0.03, 0.03, 8, Material::tie, 0, true, mesh);
  add_bar(at(0, -kRailRadius - kUnder, rail), at(0, -kRailRadius - kUnder, kPlate), 0.025, 0.025, 8, Material::tie, 0,
          false, mesh);
}

void add_seat(double x, double z, Mesh& mesh) {
  add_leaning({x - 0.22, 0.62, z - 0.21}, {x - 0.10, 1.08, z + 0.21}, -0.09, Material::seat, mesh);
  add_leaning({x - 0.32, 1.06, z - 0.13}, {x - 0.21, 1.28, z + 0.13}, -0.03, Material::seat, mesh);
  add_bar({x + 0.30, 0.62, z}, {x + 0.25, 0.86, z}, 0.028, 0.028, 8, Material::chain, 0, true, mesh);
  add_bar({x + 0.25, 0.86, z - 0.21}, {x + 0.25, 0.86, z + 0.21}, 0.032, 0.032, 8, Material::chain, 0, true, mesh);
}

// Adds a rider whose hip is at `hip`, looking along +X, with hands on the bar.
void add_rider(dvec3 hip, Material shirt, Material trousers, Mesh& mesh) {
  const dvec3 chest = hip + dvec3(-0.05, 0.26, 0), head = hip + dvec3(-0.07, 0.66, 0);
  add_ball(chest, {0.125, 0.31, 0.19}, 12, shirt, mesh);
  add_bar(hip + dvec3(-0.06, 0.50, 0), head, 0.05, 0.05, 8, Material::skin, 0, false, mesh);
  add_ball(head, {0.105, 0.125, 0.09}, 16, Material::skin, mesh);
  add_ball(head + dvec3(-0.022, 0.03, 0), {0.105, 0.112, 0.098}, 16, Material::hair, mesh);
  for (const double side : {-1.0, 1.0}) {
    const dvec3 shoulder = hip + dvec3(-0.05, 0.45, 0.17 * side), elbow = hip + dvec3(0.06, 0.20, 0.235 * side),
                hand = hip + dvec3(0.24, 0.24, 0.12 * side);
    add_ball(shoulder, {0.07, 0.07, 0.07}, 8, shirt, mesh);
    add_bar(shoulder, elbow, 0.06, 0.048, 8, shirt, 0, false, mesh);
    add_bar(elbow, hand, 0.045, 0.035, 8, Material::skin, 0, false, mesh);
    add_ball(hand, {0.045, 0.045, 0.04}, 8, Material::skin, mesh);
    const dvec3 knee = hip + dvec3(0.36, 0.06, 0.10 * side);
    add_bar(hip + dvec3(-0.02, 0.03, 0.09 * side), knee, 0.09, 0.07, 8, trousers, 0, false, mesh);
    add_ball(knee, {0.07, 0.07, 0.07}, 8, trousers, mesh);
    add_bar(knee, hip + dvec3(0.44, -0.18, 0.10 * side), 0.065, 0.05, 8, trousers, 0, false, mesh);
  }
}

}  // namespace

void add_ball(dvec3 middle, dvec3 half, int sides, Material part, Mesh& mesh) {
  const int rows = sides / 2;
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size()), count = static_cast<std::uint32_t>(sides);
  for (int row = 0; row <= rows; ++row) {
    const base::SinCos high = base::sin_cos(base::kPi * (static_cast<double>(row) / rows - 0.5));
    for (int k = 0; k < sides; ++k) {
      const base::SinCos turn = base::sin_cos(2 * base::kPi * k / sides);
      const dvec3 unit(high.cos * turn.cos, high.sin, -high.cos * turn.sin);
      mesh.vertices.push_back(
          {glm::vec3(middle + half * unit), glm::vec3(glm::normalize(unit / half)), static_cast<float>(part)});
    }
  }
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row)
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t a = first + row * count + k, b = first + row * count + (k + 1) % count;
      if (row > 0) mesh.add_triangles({a, b, a + count}, true);
      if (row + 1 < static_cast<std::uint32_t>(rows)) mesh.add_triangles({b, b + count, a + count}, true);
    }
}

Mesh car_mesh(bool leading) {
  Mesh mesh;
  std::vector<BodySection> body{{-1.10, 0.34, 0.54, 0.40},
                                {-1.06, 0.28, 0.62, 0.49},
                                {-0.96, 0.24, 0.67, 0.55},
                                {-0.60, 0.23, 0.68, 0.575},
                                {0.20, 0.23, 0.68, 0.575}};
  const BodySection plain[] = {
      {0.60, 0.23, 0.68, 0.575}, {0.96, 0.24, 0.67, 0.55}, {1.06, 0.28, 0.62, 0.49}, {1.10, 0.34, 0.54, 0.40}};
  const BodySection nose[] = {{0.36, 0.23, 0.69, 0.575}, {0.50, 0.23, 0.715, 0.565}, {0.64, 0.23, 0.715, 0.54},
                              {0.80, 0.235, 0.68, 0.48}, {0.93, 0.25, 0.62, 0.40},   {1.02, 0.275, 0.56, 0.31},
                              {1.075, 0.31, 0.51, 0.22}, {1.10, 0.36, 0.45, 0.12}};
  if (leading) body.insert(body.end(), std::begin(nose), std::end(nose));
  else body.insert(body.end(), std::begin(plain), std::end(plain));
  add_body(body, mesh);
  // The floor of the seats, and the chassis below the body.
  add_block({-0.98, 0.66, -0.44}, {leading ? 0.36 : 0.62, 0.69, 0.44}, Material::seat, mesh);
  add_block({-1.02, 0.14, -0.34}, {leading ? 0.98 : 1.02, 0.25, 0.34}, Material::tie, mesh);
  for (const double x : {-0.66, 0.66})
    for (const double side : {-1.0, 1.0}) add_bogie(x, side, mesh);
  const Material shirts[] = {Material::teal, Material::sand, Material::linen, Material::plum},
                 trousers[] = {Material::hair, Material::tie, Material::tie, Material::hair};
  int rider = 0;
  for (const double x : {-0.06, -0.74})
    for (const double z : {-0.265, 0.265}) {
      const double shifted = leading ? x : x + 0.24;
      add_seat(shifted, z, mesh);
      add_rider({shifted, 0.62, z}, shirts[rider], trousers[rider], mesh);
      ++rider;
    }
  return mesh;
}

Mesh distant_car_mesh() {
  Mesh mesh;
  add_block({-1.10, 0.23, -0.575}, {1.10, 0.68, 0.575}, Material::body, mesh);
  return mesh;
}

Mesh coupling_mesh() {
  Mesh mesh;
  add_bar({0, 0, 0}, {1, 0, 0}, 0.055, 0.055, 10, Material::tie, 0, true, mesh);
  return mesh;
}

}  // namespace coaster::sim
