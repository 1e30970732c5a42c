// Lists of marks and thin lines that are drawn over the scene, rebuilt each frame from const state. No GL.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/shape/folds.h"
#include "sim/shape/frame_methods.h"
#include "sim/solids/conflict_types.h"
#include "sim/study/force_limits.h"
#include "sim/study/jolt.h"
#include "view/pick.h"

namespace coaster::sim {
struct ElementPlan;
}

namespace coaster::view {

enum class MarkShape : std::uint8_t { disc, square };

// Screen-facing marks of constant pixel size.
struct Mark {
  glm::vec3 position{0};
  float radius_px = kKnotRadius;
  std::uint32_t rgba = 0xffffffff;  // 0xRRGGBBAA
  MarkShape shape = MarkShape::disc;
  friend bool operator==(const Mark&, const Mark&) = default;
};

// Lines of constant pixel width, drawn as quads.
struct Line {
  glm::vec3 from{0}, to{0};
  float width_px = 1.5f;
  std::uint32_t rgba = 0xffffffff;
  friend bool operator==(const Line&, const Line&) = default;
};

struct Overlay {
  std::vector<Line> lines;
  std::vector<Mark> marks;  // in drawing order, far to near within a layer
  friend bool operator==(const Overlay&, const Overlay&) = default;
};

// Findings about the track and its ride that are marked on it.
struct MarkedFindings {
  std::span<const sim::FrenetBreak> breaks;   // read for Layer::flips
  std::span<const sim::Overload> spans;       // read for Layer::limits
  std::span<const sim::Jolt> jolts;           // of the track's knots; read for Layer::limits
  std::span<const sim::Conflict> conflicts;   // read for Layer::conflicts
  std::span<const sim::Fold> folds;           // read for Layer::conflicts
  world::RideFailure failure;                 // of the ride; kind none: no failure
  const sim::ElementPlan* element = nullptr;  // the palette's element at its preview position; null: not shown
  std::span<const sim::LineConflict> narrow;  // parts of it without clearance
  bool riding = false;  // the eye follows a running train: hide knots that are neither selected nor hovered
  std::span<const sim::Fold> tight_bends;           // read for Layer::conflicts
  const sim::Ground* ground = nullptr;              // under the element; null: the plane y = 0
  std::span<const sim::FloodedTrack> flooded = {};  // read for Layer::conflicts
};

// Returns knots, handles of the selection, the control polygon of the selected segment (or of the segments at the
// selected knot), the picked position and the ride's failure. The hovered mark is larger and brighter. The visible
// laboratory layers are below them.
Overlay build_overlay(const world::Document& document, const sim::DerivedTrack& derived,
                      const world::Settings& settings, const View& view, const Pick& hovered,
                      const MarkedFindings& findings = {});

// 0xRRGGBBAA: the element, its lead-in, and its parts below the ground (on a land: under water) or without clearance
// (as conflicts).
inline constexpr std::uint32_t kElementColour = 0x66d9e8ff, kLeadColour = 0xffc078ff, kBuriedColour = 0xff6b6bff,
                               kNarrowColour = 0xffdd33ff;
inline constexpr int kMaxElementSteps = 900;  // per rail, for any length

// Adds the preview; nothing for an element that cannot be placed. `rails`: as world::rails_height(). At most 9 lines
// per step.
void add_element(const sim::ElementPlan& plan, std::span<const sim::LineConflict> narrow, double rails,
                 const View& view, float scale, Overlay& overlay, const sim::Ground* ground = nullptr);

inline constexpr std::size_t kMaxSectionLines = 2000;  // for each, unless its number of segments is larger

// Adds the lines; nothing if no section is selected. The section under the mouse shows in the workspace Build, if it is
// planned.
void add_sections(const world::Document& document, const sim::DerivedTrack& derived, const world::Settings& settings,
                  const View& view, const Pick& hovered, Overlay& overlay);

// True in Build, where a press selects sections and their handles show.
bool selects_sections(const world::Settings& settings);

}  // namespace coaster::view
