#include "sim/solids/station_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "curve/frames.h"
#include "sim/solids/coaster_form.h"
#include "sim/solids/track_mesh.h"

namespace coaster::sim {
namespace {

using glm::dvec2;
using glm::dvec3;

// Offsets from the middle of the rails and sizes, m.
constexpr double kShortestStation = 6, kEdge = 3.4, kEave = 4.3, kPitch = 1.3, kThick = 0.16, kColumns = 4.8;
constexpr double kLanes = 4, kLane = 1.3, kPlaza = 13, kPath = 3.2;

// Capital letters, digits and marks as 5 x 7 dots: a row each from the top, the highest of 5 bits on the left.
struct Glyph {
  char letter;
  std::array<std::uint8_t, 7> rows;
};
constexpr Glyph kGlyphs[] = {
    {'A', {14, 17, 17, 31, 17, 17, 17}}, {'B', {30, 17, 17, 30, 17, 17, 30}}, {'C', {14, 17, 16, 16, 16, 17, 14}},
    {'D', {30, 17, 17, 17, 17, 17, 30}}, {'E', {31, 16, 16, 30, 16, 16, 31}}, {'F', {31, 16, 16, 30, 16, 16, 16}},
    {'G', {14, 17, 16, 23, 17, 17, 15}}, {'H', {17, 17, 17, 31, 17, 17, 17}}, {'I', {14, 4, 4, 4, 4, 4, 14}},
    {'J', {7, 2, 2, 2, 2, 18, 12}},      {'K', {17, 18, 20, 24, 20, 18, 17}}, {'L', {16, 16, 16, 16, 16, 16, 31}},
    {'M', {17, 27, 21, 21, 17, 17, 17}}, {'N', {17, 25, 21, 19, 17, 17, 17}}, {'O', {14, 17, 17, 17, 17, 17, 14}},
    {'P', {30, 17, 17, 30, 16, 16, 16}}, {'Q', {14, 17, 17, 17, 21, 18, 13}}, {'R', {30, 17, 17, 30, 20, 18, 17}},
    {'S', {15, 16, 16, 14, 1, 1, 30}},   {'T', {31, 4, 4, 4, 4, 4, 4}},       {'U', {17, 17, 17, 17, 17, 17, 14}},
    {'V', {17, 17, 17, 17, 17, 10, 4}},  {'W', {17, 17, 17, 21, 21, 27, 17}}, {'X', {17, 17, 10, 4, 10, 17, 17}},
    {'Y', {17, 17, 10, 4, 4, 4, 4}},     {'Z', {31, 1, 2, 4, 8, 16, 31}},     {'0', {14, 17, 19, 21, 25, 17, 14}},
    {'1', {4, 12, 4, 4, 4, 4, 14}},      {'2', {14, 17, 1, 6, 8, 16, 31}},    {'3', {30, 1, 1, 14, 1, 1, 30}},
    {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},   {'6', {14, 16, 16, 30, 17, 17, 14}},
    {'7', {31, 1, 2, 4, 8, 8, 8}},       {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 1, 14}},
    {'&', {12, 18, 20, 8, 21, 18, 13}},  {'-', {0, 0, 0, 14, 0, 0, 0}},       {'.', {0, 0, 0, 0, 0, 12, 12}},
    {'!', {4, 4, 4, 4, 4, 0, 4}},        {'\'', {4, 4, 8, 0, 0, 0, 0}}};

std::string shown_name(std::string_view name) {
  std::string text;
  for (const char c : name.substr(0, kMostLetters)) text += c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  return text;
}

class StationBuilder {
 public:
  StationBuilder(const Ground& ground, const CoasterForm& form, std::vector<Ring> rings, Mesh& mesh)
      : ground_(ground),
        rings_(std::move(rings)),
        mesh_(mesh),
        floor_(form.platform),
        eaves_(std::max(form.platform + 3.6, form.side < 0 ? 2.4 : 0.0)),
        timber_(form.supports == SupportForm::bent ? Material::timber : Material::support) {
    for (std::size_t i = 1; i < rings_.size(); ++i)
      length_ += glm::distance(rings_[i - 1].position, rings_[i].position);
  }

  bool fits() const {
    return length_ >= kShortestStation && std::ranges::all_of(rings_, [](const Ring& ring) {
             return std::abs(ring.frame.forward.y) <= 0.35 && ring.frame.up.y >= 0.9;
           });
  }

  void add(std::string_view name) {
    add_roof();
    add_gates();
    for (const double side : {1.0, -1.0}) add_board(name, side);
    add_queue();
  }

 private:
  // Returns the ring at a distance from the station's start.
  Ring at(double distance) const {
    double before = 0;
    for (std::size_t i = 1; i < rings_.size(); ++i) {
      const double step = glm::distance(rings_[i - 1].position, rings_[i].position);
      if (distance > before + step && i + 1 < rings_.size()) {
        before += step;
        continue;
      }
      Ring ring = rings_[i - 1];
      const double t = step > 0 ? std::clamp((distance - before) / step, 0.0, 1.0) : 0.0;
      ring.position = glm::mix(rings_[i - 1].position, rings_[i].position, t);
      return ring;
    }
    return rings_.front();
  }
  std::vector<Ring> spaced(double spacing, double inset) const {
    std::vector<Ring> some;
    const double room = length_ - 2 * inset;
    const int count = std::max(1, static_cast<int>(std::lround(room / spacing)));
    for (int i = 0; i <= count; ++i) some.push_back(at(inset + room * i / count));
    return some;
  }

  void add_roof() {
    for (const double side : {1.0, -1.0}) {
      const dvec2 ridge(0, eaves_ + kPitch), eave(side * kEave, eaves_), thick(0, kThick);
      const std::array<dvec2, 4> slope = side > 0 ? std::array{ridge, ridge + thick, eave + thick, eave}
                                                  : std::array{eave, eave + thick, ridge + thick, ridge};
      add_extrusion(rings_, slope, Material::spine, true, mesh_);
      add_beam(rings_, eave + dvec2(-0.06, -0.22), eave + dvec2(0.06, kThick), Material::linen, true, mesh_);
    }
    for (const Ring& ring : spaced(kColumns, 0.6)) {
      for (const double side : {1.0, -1.0}) {
        const double out = side * (kEdge - 0.25);
        add_bar(ring.place(out, floor_), ring.place(out, eaves_ + 0.25), 0.11, 0.11, 8, timber_, true, mesh_);
        add_bar(ring.place(out, eaves_ - 0.7), ring.place(0.45 * out, eaves_ + 0.5), 0.06, 0.06, 6, timber_, false,
                mesh_);
      }
      add_bar(ring.place(kEdge, eaves_ + 0.2), ring.place(-kEdge, eaves_ + 0.2), 0.08, 0.08, 6, timber_, false, mesh_);
    }
  }

  // A pair of low wings at each place where a car may stop, on both platforms.
  void add_gates() {
    for (const Ring& ring : spaced(1.5, 0.75))
      for (const double side : {1.0, -1.0}) {
        const double left = side * 1.45;
        add_bar(ring.place(left, floor_), ring.place(left, floor_ + 1.05), 0.035, 0.035, 6, Material::fin, false,
                mesh_);
        for (const double height : {0.45, 0.95})
          add_box(ring.place(left, floor_ + height), ring.frame, {0.6, 0.025, 0.02}, Material::fin, false, mesh_);
      }
  }

  // A board on the eave of one side that faces away from the track.
  void add_board(std::string_view name, double side) {
    const std::string text = shown_name(name);
    if (text.empty()) return;
    const double dots = 6.0 * static_cast<double>(text.size()) + 3, dot = std::min(0.11, 0.8 * length_ / dots);
    const double half = 0.5 * dots * dot, tall = 10 * dot;
    const Ring ring = at(0.5 * length_);
    const dvec3 forward = ring.frame.forward, out = side * ring.frame.left(), up(0, 1, 0);
    const dvec3 along = side > 0 ? -forward : forward;  // the way the text runs for who looks at it
    const dvec3 middle = ring.place(side * (kEave + 0.14), eaves_ + 0.1 + 0.5 * tall);
    const curve::Frame frame{along, up};
    add_box(middle, frame, {half, 0.5 * tall, 0.06}, Material::body, true, mesh_);
    const dvec3 corner = middle + 0.075 * out - (half - 2 * dot) * along + 3.5 * dot * up;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto glyph = std::ranges::find(kGlyphs, text[i], &Glyph::letter);
      if (glyph == std::end(kGlyphs)) continue;
      for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 5; ++column)
          if (glyph->rows[static_cast<std::size_t>(row)] >> (4 - column) & 1)
            add_dot(corner + (6.0 * static_cast<double>(i) + column) * dot * along - row * dot * up, along, dot);
    }
  }
  void add_dot(dvec3 corner, dvec3 along, double size) {
    const dvec3 right = size * along, down(0, -size, 0);
    const std::array<dvec3, 4> face{corner, corner + down, corner + down + right, corner + right};
    add_face(face, Material::linen, false, mesh_);
  }

  // A point on the ground to the right of the station, `along` it and `out` from the rails.
  dvec3 on_ground(double along, double out, double over) const {
    const dvec3 p = at(along).place(-out, 0) + std::min(along, 0.0) * rings_.front().frame.forward;
    return {p.x, ground_.height(p.x, p.z) + over, p.z};
  }
  void add_paving(double from, double to, double inner, double outer, Material material) {
    const int columns = static_cast<int>(std::ceil(to - from)), rows = static_cast<int>(std::ceil(outer - inner));
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        const double a = from + (to - from) * i / columns, b = from + (to - from) * (i + 1) / columns;
        const double c = inner + (outer - inner) * j / rows, d = inner + (outer - inner) * (j + 1) / rows;
        const std::array<dvec3, 4> face{on_ground(a, c, 0.07), on_ground(a, d, 0.07), on_ground(b, d, 0.07),
                                        on_ground(b, c, 0.07)};
        const bool upwards = glm::cross(face[1] - face[0], face[2] - face[0]).y > 0;
        const std::array<dvec3, 4> turned{face[0], face[3], face[2], face[1]};
        add_face(upwards ? face : turned, material, true, mesh_);
      }
    }
  }

  // Lanes between fences on a plaza, steps up to the platform, and a path that leads to them.
  void add_queue() {
    const double first = kEdge + 1.9, last = first + kLanes * kLane, middle = 0.5 * length_;
    const double from = std::max(middle - 7, 0.5), to = std::min(middle + 7, length_ - 0.5);
    add_paving(from - 0.5, to + 0.5, kEdge + 0.1, kPlaza, Material::sand);
    add_paving(middle - 0.5 * kPath, middle + 0.5 * kPath, kPlaza, kPlaza + 9, Material::sand);
    for (int lane = 0; lane <= static_cast<int>(kLanes); ++lane) {
      const double out = first + lane * kLane, begin = from + (lane % 2 == 0 ? 0.0 : 1.4),
                   end = to - (lane % 2 == 0 ? 1.4 : 0.0);
      const int posts = std::max(1, static_cast<int>(std::lround((end - begin) / 2)));
      for (int i = 0; i <= posts; ++i) {
        const double a = begin + (end - begin) * i / posts, b = begin + (end - begin) * (i + 1) / posts;
        add_bar(on_ground(a, out, 0), on_ground(a, out, 1.0), 0.04, 0.04, 6, timber_, i % 2 == 0, mesh_);
        for (const double height : {0.5, 0.95})
          if (i < posts)
            add_bar(on_ground(a, out, height), on_ground(b, out, height), 0.03, 0.03, 4, timber_, false, mesh_);
      }
    }
    add_steps(to - 1.2, last);
  }
  void add_steps(double along, double most_out) {
    const Ring ring = at(along);
    const double top = ring.place(-kEdge, floor_).y, rise = top - on_ground(along, kEdge + 1, 0).y;
    const int steps = static_cast<int>(std::ceil(rise / 0.18));
    if (steps < 1 || steps * 0.28 > most_out - kEdge) return;
    for (int i = 0; i < steps; ++i) {
      const double height = top - rise * (i + 1) / (steps + 1), out = kEdge + 0.14 + 0.28 * i;
      const dvec3 place = ring.place(-out, 0);
      const double low = ground_.height(place.x, place.z);
      const curve::Frame frame{ring.frame.forward, {0, 1, 0}};
      if (height > low)
        add_box({place.x, 0.5 * (low + height), place.z}, frame, {1.0, 0.5 * (height - low), 0.14}, Material::concrete,
                true, mesh_);
    }
  }

  const Ground& ground_;
  std::vector<Ring> rings_;
  Mesh& mesh_;
  double floor_, eaves_, length_ = 0;
  Material timber_;
};

}  // namespace

Mesh station_mesh(const DerivedTrack& derived, const Ground& ground, std::string_view name) {
  Mesh mesh;
  const std::size_t count = derived.order.size();
  const auto is_station = [&](std::size_t i) {
    return derived.shape_at(i % count).fitted == world::EquipmentKind::station;
  };
  if (count == 0) return mesh;
  std::size_t start = 0;  // the first segment after one that is no station, so that none is cut at the track's start
  while (derived.closed && start < count && is_station(start)) ++start;
  for (std::size_t i = 0; i < count;) {
    std::vector<Ring> rings;
    for (; i < count && is_station(start + i); ++i)
      for (const Ring& ring : level(spaced_rings(derived.shape_at((start + i) % count), 1.0))) rings.push_back(ring);
    if (rings.size() < 2) {
      ++i;
      continue;
    }
    StationBuilder builder(ground, form_of(derived.made.kind), std::move(rings), mesh);
    if (builder.fits()) builder.add(name);
  }
  // The roof is dark below, and darkens the gates; the ground darkens the feet of fences.
  for (MeshVertex& vertex : mesh.vertices)
    vertex.along = vertex.normal.y < -0.3f ? 0.7f : vertex.part == static_cast<float>(Material::fin) ? 0.5f : 0;
  return mesh;
}

}  // namespace coaster::sim
