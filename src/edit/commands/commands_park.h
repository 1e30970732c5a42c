// The commands of the park: its land and the strokes of brushes. See command.h.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "edit/commands/command_fields.h"
#include "world/components.h"
#include "world/park.h"

namespace coaster::edit {

// The level of a park's water, a number (m) or "none".
struct WaterLevel {
  double level = world::kNoWater;
  friend bool operator==(const WaterLevel&, const WaterLevel&) = default;
};

COASTER_COMMAND_GROUP(Park);

struct SetLand {
  world::Land to{};
  COASTER_COMMAND(SetLand, "park", "Set the land around the coaster, with its usual water and woods; plain: none.",
                  Effect::document, "Made the land {}");
  COASTER_FIELDS(visit("", self.to))
};
struct SetParkSeed {
  std::int64_t to = 0;
  COASTER_COMMAND(SetParkSeed, "park.seed", "Set the seed of the land: another number, other hills. Strokes stay.",
                  Effect::document, "Set the seed of the land to {}");
  COASTER_FIELDS(visit("", self.to))
};
struct SetParkRelief {
  double to = 1;
  COASTER_COMMAND(SetParkRelief, "park.relief", "Set the factor of the land's heights, 0 to 3.", Effect::document,
                  "Set the relief of the land to {}");
  COASTER_FIELDS(visit("", self.to))
};
struct SetParkWoods {
  double to = 0;
  COASTER_COMMAND(SetParkWoods, "park.woods", "Set how much of the land is wooded, 0 to 1.", Effect::document,
                  "Set the woods of the land to {}");
  COASTER_FIELDS(visit("", self.to))
};
struct SetParkWater {
  WaterLevel to;
  COASTER_COMMAND(SetParkWater, "park.water", "Set the level of lakes and seas (m), or none.", Effect::document,
                  "Set the water to {}");
  COASTER_FIELDS(visit("", self.to))
};
struct ResetPark {
  COASTER_COMMAND(ResetPark, "park.reset", "Take all strokes of brushes away: the land as its seed has it.",
                  Effect::document, "Took all strokes of brushes away");
  COASTER_FIELDS()
};

// Places on the ground are x and z, m; radii and heights are in m, too.
struct RaiseGround {
  glm::vec2 at{0};
  double radius = 20, by = 0;
  COASTER_COMMAND(RaiseGround, "ground.raise",
                  "Raise the land about a place (x and z, m), or lower it by a negative height.", Effect::document,
                  "Raised the ground by {by} m");
  COASTER_FIELDS(visit("at", self.at), visit("radius", self.radius), visit("by", self.by))
};
struct SmoothGround {
  glm::vec2 at{0};
  double radius = 20;
  COASTER_COMMAND(SmoothGround, "ground.smooth", "Smooth the land about a place.", Effect::document,
                  "Smoothed the ground");
  COASTER_FIELDS(visit("at", self.at), visit("radius", self.radius))
};
struct FlattenGround {
  glm::vec2 at{0};
  double radius = 20, to = 0;
  COASTER_COMMAND(FlattenGround, "ground.flatten", "Make the land about a place level, at a height (m).",
                  Effect::document, "Flattened the ground at {to} m");
  COASTER_FIELDS(visit("at", self.at), visit("radius", self.radius), visit("to", self.to))
};
struct SlopeGround {
  glm::vec2 from{0}, to{0};
  double radius = 20;
  COASTER_COMMAND(SlopeGround, "ground.slope",
                  "Make a strip of land between two places one slope, straight between their heights.",
                  Effect::document, "Made the ground one slope");
  COASTER_FIELDS(visit("from", self.from), visit("to", self.to), visit("radius", self.radius))
};
struct PaintWoods {
  glm::vec2 at{0};
  double radius = 20, to = 1;
  COASTER_COMMAND(PaintWoods, "woods.paint", "Let trees grow about a place, from 0 (none) to 1 (dense).",
                  Effect::document, "Painted woods of {to}");
  COASTER_FIELDS(visit("at", self.at), visit("radius", self.radius), visit("to", self.to))
};
struct ResetWoods {
  glm::vec2 at{0};
  double radius = 20;
  COASTER_COMMAND(ResetWoods, "woods.reset", "Let trees grow about a place as the land has them.", Effect::document,
                  "Took the paint of woods away");
  COASTER_FIELDS(visit("at", self.at), visit("radius", self.radius))
};

struct SetEarthwork {
  Sections sections;
  world::Earthwork to{};
  COASTER_COMMAND(SetEarthwork, "section.earthwork",
                  "Set what is done to the land where sections run below it: an open cut, a tunnel, nothing, or what "
                  "fits its depth.",
                  Effect::document, "Set the earthwork of {} to {to}");
  COASTER_FIELDS(visit("", self.sections), visit("to", self.to))
};

COASTER_COMMAND_LIST(Park, SetLand, SetParkSeed, SetParkRelief, SetParkWoods, SetParkWater, ResetPark, RaiseGround,
                     SmoothGround, FlattenGround, SlopeGround, PaintWoods, ResetWoods, SetEarthwork);

}  // namespace coaster::edit
