// What a document is made of: plain components. To add one, add the struct and name it in Document's registry.
#pragma once

#include <cstdint>
#include <string>

#include <glm/glm.hpp>

#include "world/entity.h"

namespace coaster::world {

// Limits of what a document may hold; files beyond them are refused, edits are clamped with a notice.
inline constexpr float kMaxCoordinate = 100'000.0f;  // m, of positions
inline constexpr float kMinHandle = 0.01f;           // m
inline constexpr float kMaxHandle = 10'000.0f;       // m
inline constexpr int kMaxTurns = 16;                 // whole turns of roll within a segment
inline constexpr double kMaxSpeed = 150.0;           // m/s, of the start speed
inline constexpr std::size_t kMaxKnots = 1'000'000;

// smooth: equal handle lengths (C1). aligned: a common tangent line (G1). automatic: direction and lengths follow from
// the neighbours (as Catmull-Rom: along the chord between them, a third of each side's chord).
enum class JointKind : std::uint8_t { smooth, aligned, automatic };

// A place the track goes through. Knots own the geometry; a common tangent line at every joint (G1) cannot be broken.
struct Knot {
  glm::vec3 position{0};      // m, |coordinate| <= kMaxCoordinate
  glm::vec3 tangent{1, 0, 0};  // unit, direction of travel
  glm::vec3 up{0, 1, 0};       // unit, perpendicular to tangent: what the riders' heads point to
  float in_length = 5;        // m, from the knot back to the handle before it; kMinHandle..kMaxHandle
  float out_length = 5;       // m, to the handle after it
  JointKind joint = JointKind::smooth;
  friend bool operator==(const Knot&, const Knot&) = default;
};

// A cubic from one knot to the next; its control points follow from the knots (world/document.h: cubic_of).
struct Segment {
  Entity from, to;
  std::int32_t turns = 0;  // whole turns about the tangent added to the least twist between the knots' `up`
  friend bool operator==(const Segment&, const Segment&) = default;
};

// A cart as designed: where it starts.
struct Cart {
  Entity segment;
  double fraction = 0;  // of the segment's arc length, [0,1)
  friend bool operator==(const Cart&, const Cart&) = default;
};

// Members of a file's object that this version does not know, kept for saving: the text of a JSON object.
struct Extra {
  std::string json;
  friend bool operator==(const Extra&, const Extra&) = default;
};

}  // namespace coaster::world
