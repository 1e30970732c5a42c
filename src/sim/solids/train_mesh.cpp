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

// Adds a block between two opposite corners.
void add_block(dvec3 a, dvec3 b, Material part, Mesh& mesh) {
  add_box(0.5 * (a + b), kAhead, 0.5 * glm::abs(b - a), part, true, mesh);
}

// Adds a block whose upper face is shifted by `lean` along X.
void add_leaning(dvec3 low, dvec3 high, double lean, Material part, Mesh& mesh) {
  const auto face = [&](double x) {
    return std::array{dvec3(x, low.y, high.z), dvec3(x, low.y, low.z), dvec3(x + lean, high.y, low.z),
                      dvec3(x + lean, high.y, high.z)};
  };
  add_prism(face(high.x), face(low.x), part, true, mesh);
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
  add_face(sections.back(), parts[0], true, mesh);
  add_face(std::vector<dvec3>(sections.front().rbegin(), sections.front().rend()), parts[0], true, mesh);
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
  add_bar(middle - half_axis, middle + half_axis, radius, radius, kWheelSides, Material::wheel, true, mesh);
  add_bar(middle + half_axis, middle + 1.12 * half_axis, 0.5 * radius, 0.45 * radius, 10, Material::fin, false, mesh);
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
  add_box(at(0, 0.5 * (axle - 0.26), kPlate - 0.015), kAhead, {0.07, 0.5 * (axle + 0.26) - 0.02, 0.018},
          Material::chassis, true, mesh);
  add_box(at(0, axle + 0.01, kPlate - 0.015), kAhead, {0.22, 0.032, 0.02}, Material::chassis, true, mesh);
  for (const double along : {-0.17, 0.17})
    add_bar(at(along, axle, 0.3), at(along, axle, kPlate), 0.03, 0.03, 8, Material::chassis, true, mesh);
  add_bar(at(0, -kRailRadius - kUnder, rail), at(0, -kRailRadius - kUnder, kPlate), 0.025, 0.025, 8, Material::chassis,
          false, mesh);
}

constexpr double kHip = 0.62;  // m above the rails

void add_seat(double x, double z, Mesh& mesh) {
  add_leaning({x - 0.22, 0.62, z - 0.21}, {x - 0.10, 1.08, z + 0.21}, -0.09, Material::seat, mesh);
  add_leaning({x - 0.32, 1.06, z - 0.13}, {x - 0.21, 1.28, z + 0.13}, -0.03, Material::seat, mesh);
  add_bar({x + 0.30, 0.62, z}, {x + 0.25, 0.86, z}, 0.028, 0.028, 8, Material::chain, true, mesh);
  add_bar({x + 0.25, 0.86, z - 0.21}, {x + 0.25, 0.86, z + 0.21}, 0.032, 0.032, 8, Material::chain, true, mesh);
}

// Adds a bench for two with a low back, and its lap bar.
void add_bench(double x, Mesh& mesh) {
  add_block({x - 0.28, 0.66, -0.48}, {x + 0.16, 0.74, 0.48}, Material::seat, mesh);
  add_leaning({x - 0.30, 0.70, -0.48}, {x - 0.18, 1.10, 0.48}, -0.08, Material::seat, mesh);
  for (const double side : {-1.0, 1.0})
    add_bar({x + 0.28, 0.66, 0.44 * side}, {x + 0.24, 0.90, 0.44 * side}, 0.025, 0.025, 8, Material::chain, true, mesh);
  add_bar({x + 0.24, 0.90, -0.45}, {x + 0.24, 0.90, 0.45}, 0.035, 0.035, 8, Material::chain, true, mesh);
}

// A rider's clothes and hair, and the size of chest and head.
struct RiderLook {
  Material shirt, trousers, hair;
  double size = 1;
};
constexpr RiderLook kLooks[kRiderGroups][4] = {{{Material::teal, Material::hair, Material::hair},
                                                {Material::sand, Material::chassis, Material::hair},
                                                {Material::linen, Material::chassis, Material::hair},
                                                {Material::plum, Material::hair, Material::hair}},
                                               {{Material::plum, Material::chassis, Material::timber, 0.9},
                                                {Material::linen, Material::hair, Material::sand, 0.94},
                                                {Material::stripe, Material::teal, Material::hair},
                                                {Material::teal, Material::sand, Material::chassis, 0.88}}};

// Adds an arm from the shoulder: to the bar, or raised.
void add_arm(dvec3 hip, double side, Material shirt, bool raised, Mesh& mesh) {
  const dvec3 shoulder = hip + dvec3(-0.05, 0.45, 0.17 * side);
  const dvec3 elbow = hip + (raised ? dvec3(0.05, 0.68, 0.23 * side) : dvec3(0.06, 0.20, 0.235 * side)),
              hand = hip + (raised ? dvec3(0.07, 0.93, 0.20 * side) : dvec3(0.24, 0.24, 0.12 * side));
  add_ball(shoulder, {0.07, 0.07, 0.07}, 8, shirt, mesh);
  add_bar(shoulder, elbow, 0.06, 0.048, 8, shirt, false, mesh);
  add_bar(elbow, hand, 0.045, 0.035, 8, Material::skin, false, mesh);
  add_ball(hand, {0.045, 0.045, 0.04}, 8, Material::skin, mesh);
}

// Adds a rider whose hip is at `hip`, looking along +X.
void add_rider(dvec3 hip, const RiderLook& look, bool arms_up, Mesh& mesh) {
  const dvec3 chest = hip + dvec3(-0.05, 0.26, 0), head = hip + dvec3(-0.07, 0.66 * look.size, 0);
  add_ball(chest, look.size * dvec3(0.125, 0.31, 0.19), 12, look.shirt, mesh);
  add_bar(hip + dvec3(-0.06, 0.50 * look.size, 0), head, 0.05, 0.05, 8, Material::skin, false, mesh);
  add_ball(head, {0.105, 0.125, 0.09}, 16, Material::skin, mesh);
  add_ball(head + dvec3(-0.022, 0.03, 0), {0.105, 0.112, 0.098}, 16, look.hair, mesh);
  for (const double side : {-1.0, 1.0}) {
    add_arm(hip, side, look.shirt, arms_up, mesh);
    const dvec3 knee = hip + dvec3(0.36, 0.06, 0.10 * side);
    add_bar(hip + dvec3(-0.02, 0.03, 0.09 * side), knee, 0.09, 0.07, 8, look.trousers, false, mesh);
    add_ball(knee, {0.07, 0.07, 0.07}, 8, look.trousers, mesh);
    add_bar(knee, hip + dvec3(0.44, -0.18, 0.10 * side), 0.065, 0.05, 8, look.trousers, false, mesh);
  }
}

// The riders of a car, who take their seats one after another.
class RiderRow {
 public:
  explicit RiderRow(CarRiders riders) : riders_(riders) {}
  void seat(dvec3 hip, Mesh& mesh) {
    add_rider(hip, kLooks[riders_.group % kRiderGroups][next_++], riders_.arms_up, mesh);
  }

 private:
  CarRiders riders_;
  int next_ = 0;
};

}  // namespace

void add_ball(dvec3 middle, dvec3 half, int sides, Material part, Mesh& mesh) {
  const int rows = sides / 2;
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size()), count = static_cast<std::uint32_t>(sides);
  for (int row = 0; row <= rows; ++row) {
    base::SinCos high = base::sin_cos(base::kPi * (static_cast<double>(row) / rows - 0.5));
    if (row == 0 || row == rows) high.cos = 0;  // a pole is one point
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

namespace {

void add_bogies(Mesh& mesh) {
  for (const double x : {-0.66, 0.66})
    for (const double side : {-1.0, 1.0}) add_bogie(x, side, mesh);
}

Mesh steel_car(bool leading, CarRiders riders) {
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
  add_block({-1.02, 0.14, -0.34}, {leading ? 0.98 : 1.02, 0.25, 0.34}, Material::chassis, mesh);
  add_bogies(mesh);
  RiderRow seats(riders);
  for (const double x : {-0.06, -0.74})
    for (const double z : {-0.265, 0.265}) {
      const double shifted = leading ? x : x + 0.24;
      add_seat(shifted, z, mesh);
      seats.seat({shifted, kHip, z}, mesh);
    }
  return mesh;
}

// A box with low sides and benches, and a flat front that leans back.
Mesh wooden_car(bool leading, CarRiders riders) {
  Mesh mesh;
  add_block({-1.10, 0.24, -0.60}, {1.06, 0.30, 0.60}, Material::chassis, mesh);
  for (const double side : {-1.0, 1.0}) {
    const double inner = 0.54 * side, outer = 0.60 * side, rim = 0.02 * side;
    add_block({-1.10, 0.30, inner}, {1.00, 0.78, outer}, Material::body, mesh);
    add_block({-1.10, 0.52, outer}, {1.00, 0.60, outer + 0.012 * side}, Material::stripe, mesh);
    add_block({-1.10, 0.78, inner - rim}, {1.02, 0.82, outer + rim}, Material::seat, mesh);
  }
  add_block({-1.10, 0.30, -0.60}, {-1.04, 1.12, 0.60}, Material::body, mesh);
  if (leading) {
    add_leaning({0.90, 0.26, -0.60}, {1.09, 0.76, 0.60}, -0.14, Material::body, mesh);
    add_leaning({0.94, 0.40, -0.30}, {1.10, 0.70, 0.30}, -0.09, Material::stripe, mesh);
  } else {
    add_block({1.02, 0.30, -0.60}, {1.10, 0.80, 0.60}, Material::body, mesh);
  }
  add_bogies(mesh);
  RiderRow seats(riders);
  for (const double row : {-0.08, -0.70}) {
    const double x = leading ? row : row + 0.26;
    add_bench(x, mesh);
    for (const double z : {-0.25, 0.25}) seats.seat({x, 0.74, z}, mesh);
  }
  return mesh;
}

// A frame between the wheels, and seats that hang from it back to back with the frame's hangers, feet free.
Mesh inverted_car(bool leading, CarRiders riders) {
  constexpr double kSeat = -1.68;  // of the hips
  Mesh mesh;
  add_bogies(mesh);
  add_block({-1.10, -0.36, -0.40}, {leading ? 0.90 : 1.10, -0.20, 0.40}, Material::chassis, mesh);
  // Arms below the rails hold the bogies from there.
  for (const double x : {-0.66, 0.66}) {
    add_block({x - 0.05, -0.36, -0.933}, {x + 0.05, -0.30, 0.933}, Material::chassis, mesh);
    for (const double z : {-0.915, 0.915})
      add_block({x - 0.05, -0.36, z - 0.018}, {x + 0.05, -0.2, z + 0.018}, Material::chassis, mesh);
  }
  if (leading) add_ball({0.90, -0.24, 0}, {0.20, 0.14, 0.44}, 16, Material::body, mesh);
  RiderRow seats(riders);
  for (const double row : {-0.10, -0.74}) {
    const double x = leading ? row : row + 0.40;
    add_bar({x - 0.26, -0.34, 0}, {x - 0.26, kSeat + 0.86, 0}, 0.09, 0.08, 10, Material::body, true, mesh);
    add_block({x - 0.34, kSeat + 0.74, -0.62}, {x - 0.18, kSeat + 0.88, 0.62}, Material::body, mesh);
    add_block({x - 0.35, kSeat + 0.78, -0.63}, {x - 0.17, kSeat + 0.83, 0.63}, Material::stripe, mesh);
    for (const double z : {-0.34, 0.34}) {
      add_leaning({x - 0.24, kSeat - 0.06, z - 0.22}, {x - 0.13, kSeat + 0.78, z + 0.22}, -0.07, Material::body, mesh);
      add_block({x - 0.24, kSeat - 0.12, z - 0.22}, {x + 0.26, kSeat - 0.02, z + 0.22}, Material::body, mesh);
      for (const double side : {-1.0, 1.0})
        add_bar({x - 0.20, kSeat + 0.74, z + 0.14 * side}, {x + 0.20, kSeat + 0.20, z + 0.12 * side}, 0.045, 0.035, 8,
                Material::stripe, true, mesh);
      seats.seat({x, kSeat, z}, mesh);
    }
  }
  return mesh;
}

// The boiler, chimney and cow catcher of a locomotive in front of a row of riders.
void add_locomotive(Mesh& mesh) {
  constexpr double kAxis = 0.64;
  add_bar({-0.12, kAxis, 0}, {0.94, kAxis, 0}, 0.34, 0.34, 16, Material::body, true, mesh);
  for (const double x : {0.06, 0.46, 0.86})
    add_bar({x, kAxis, 0}, {x + 0.05, kAxis, 0}, 0.36, 0.36, 16, Material::stripe, true, mesh);
  add_bar({0.94, kAxis, 0}, {1.00, kAxis, 0}, 0.30, 0.22, 16, Material::chain, true, mesh);
  add_bar({0.74, 0.92, 0}, {0.74, 1.10, 0}, 0.08, 0.09, 12, Material::chassis, true, mesh);
  add_bar({0.74, 1.10, 0}, {0.74, 1.18, 0}, 0.15, 0.11, 12, Material::chassis, true, mesh);
  add_ball({0.36, 0.96, 0}, {0.11, 0.11, 0.11}, 12, Material::stripe, mesh);
  add_ball({0.98, 0.94, 0}, {0.09, 0.09, 0.09}, 12, Material::stripe, mesh);
  add_leaning({0.90, 0.16, -0.50}, {1.10, 0.42, 0.50}, -0.16, Material::stripe, mesh);
  for (const double side : {-1.0, 1.0})
    add_block({-0.20, 0.34, 0.42 * side - 0.10}, {0.90, 0.40, 0.42 * side + 0.10}, Material::chassis, mesh);
}

// A bucket whose sides flare, with bands of iron.
void add_bucket(double from, double to, Mesh& mesh) {
  for (const double side : {-1.0, 1.0}) {
    const auto wall = [&](double low, double high, double out, double thick, Material part) {
      // Sides lean outwards by a quarter of their height.
      const auto face = [&](double x) {
        const double a = side * (out + 0.25 * low), b = side * (out + 0.25 * high), c = a + side * thick,
                     d = b + side * thick;
        return side < 0 ? std::array{dvec3(x, low, a), dvec3(x, low, c), dvec3(x, high, d), dvec3(x, high, b)}
                        : std::array{dvec3(x, low, c), dvec3(x, low, a), dvec3(x, high, b), dvec3(x, high, d)};
      };
      add_prism(face(to), face(from), part, true, mesh);
    };
    wall(0.28, 0.92, 0.34, 0.06, Material::body);
    wall(0.86, 0.94, 0.34, 0.09, Material::chassis);
    wall(0.44, 0.50, 0.34, 0.08, Material::chassis);
  }
  add_block({from, 0.24, -0.44}, {to, 0.30, 0.44}, Material::chassis, mesh);
  for (const double x : {from, to - 0.06}) add_block({x, 0.28, -0.52}, {x + 0.06, 0.90, 0.52}, Material::body, mesh);
}

Mesh mine_car(bool leading, CarRiders riders) {
  Mesh mesh;
  if (leading) add_locomotive(mesh);
  add_block({-1.02, 0.14, -0.34}, {1.02, 0.26, 0.34}, Material::chassis, mesh);
  add_bucket(-1.10, leading ? -0.16 : 1.10, mesh);
  add_bogies(mesh);
  RiderRow seats(riders);
  for (const double x : {-0.66, 0.34}) {
    if (leading && x > 0) break;
    add_bench(x, mesh);
    for (const double z : {-0.25, 0.25}) seats.seat({x, 0.72, z}, mesh);
  }
  return mesh;
}

// A low round car; the first one is a dragon.
Mesh kiddie_car(bool leading, CarRiders riders) {
  Mesh mesh;
  const BodySection body[] = {{-1.10, 0.30, 0.50, 0.30}, {-1.00, 0.22, 0.66, 0.46}, {-0.80, 0.20, 0.76, 0.56},
                              {0.60, 0.20, 0.76, 0.56},  {0.90, 0.22, 0.72, 0.48},  {1.10, 0.28, 0.60, 0.32}};
  add_body(body, mesh);
  add_bogies(mesh);
  if (leading) {
    add_bar({0.56, 0.60, 0}, {0.76, 0.86, 0}, 0.24, 0.18, 12, Material::body, true, mesh);
    add_ball({0.80, 0.84, 0}, {0.24, 0.17, 0.22}, 16, Material::body, mesh);
    add_ball({0.96, 0.80, 0}, {0.14, 0.09, 0.17}, 12, Material::stripe, mesh);
    for (const double side : {-1.0, 1.0}) {
      add_ball({0.84, 0.98, 0.12 * side}, {0.07, 0.07, 0.07}, 10, Material::linen, mesh);
      add_ball({0.89, 0.99, 0.13 * side}, {0.035, 0.04, 0.04}, 8, Material::wheel, mesh);
      add_bar({0.72, 0.94, 0.12 * side}, {0.60, 1.12, 0.17 * side}, 0.05, 0.01, 8, Material::stripe, true, mesh);
    }
  }
  RiderRow seats(riders);
  for (const double row : {-0.08, -0.70}) {
    const double x = leading ? row : row + 0.36;
    add_ball({x, 0.70, 0}, {0.26, 0.08, 0.46}, 12, Material::seat, mesh);
    add_leaning({x - 0.30, 0.70, -0.03}, {x - 0.16, 0.94, 0.03}, -0.06, Material::stripe, mesh);
    for (const double z : {-0.26, 0.26}) seats.seat({x, 0.56, z}, mesh);
  }
  return mesh;
}

}  // namespace

Mesh car_mesh(world::CoasterKind kind, bool leading, CarRiders riders) {
  Mesh mesh;
  switch (kind) {
    case world::CoasterKind::steel: mesh = steel_car(leading, riders); break;
    case world::CoasterKind::wooden: mesh = wooden_car(leading, riders); break;
    case world::CoasterKind::inverted: mesh = inverted_car(leading, riders); break;
    case world::CoasterKind::mine: mesh = mine_car(leading, riders); break;
    case world::CoasterKind::kiddie: mesh = kiddie_car(leading, riders); break;
  }
  // The body hides the sky from what is below it, and from the riders' legs within it.
  constexpr float kRim = 1.0f, kDeep = 0.5f, kFloor = 0.30f;  // m over the rails
  for (MeshVertex& vertex : mesh.vertices) {
    const float y = vertex.position.y, out = std::abs(vertex.position.z);
    const bool below = y < kFloor && vertex.part != static_cast<float>(Material::body);
    if (form_of(kind).side > 0) vertex.along = below ? 0.6f : out < 0.5f ? std::min((kRim - y) / kDeep, 0.9f) : 0;
  }
  return mesh;
}

Mesh distant_car_mesh(world::CoasterKind kind) {
  Mesh mesh;
  const bool hangs = form_of(kind).side < 0;
  add_block({-1.10, hangs ? -2.0 : 0.23, -0.575}, {1.10, hangs ? -0.2 : 0.68, 0.575}, Material::body, mesh);
  return mesh;
}

Mesh coupling_mesh() {
  Mesh mesh;
  add_bar({0, 0, 0}, {1, 0, 0}, 0.055, 0.055, 10, Material::chassis, true, mesh);
  return mesh;
}

}  // namespace coaster::sim
