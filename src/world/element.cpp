// The table of elements.
#include "world/element.h"

#include "base/check.h"

namespace coaster::world {
namespace {

constexpr ElementParameter kStraight[] = {
    {"length", "Length", "m", 30, 2, 2000, "How long it is."},
    {"roll", "Roll", "deg", 0, -1440, 1440,
     "By how much the track rolls along it, positive to the rider's right; 0 levels it out. 360 is an inline twist."},
};
constexpr ElementParameter kCurve[] = {
    {"radius", "Radius", "m", 25, 3, 1000, "Of the circle between the two clothoids that lead into it and out of it."},
    {"angle", "Angle", "deg", 90, 1, 1080, "By how much the direction turns."},
    {"bank", "Bank", "deg", 40, -30, 110,
     "How far the track rolls towards the inside where the curve is tightest. Not used when a speed is given."},
    {"speed", "For speed", "m/s", 0, 0, 150,
     "When above 0: banked so that riders feel nothing sideways at this speed where it is tightest."},
};
constexpr ElementParameter kHelix[] = {
    {"radius", "Radius", "m", 16, 3, 1000, "Of its plan, between the two clothoids."},
    {"turns", "Turns", "", 2, 0.25, 12, "How often it goes round; 1 is 360 degrees."},
    {"height", "Height", "m", -10, -200, 200, "From its start to its end: below 0 it descends."},
    {"bank", "Bank", "deg", 50, -30, 110,
     "How far the track rolls towards the inside. Not used when a speed is given."},
    {"speed", "For speed", "m/s", 0, 0, 150,
     "When above 0: banked so that riders feel nothing sideways at this speed where it is tightest."},
};
constexpr ElementParameter kClimb[] = {
    {"height", "Height", "m", 25, 0.5, 300, "How much higher its end is."},
    {"angle", "Angle", "deg", 35, 2, 90, "The steepest it gets."},
    {"radius", "Radius", "m", 20, 3, 500, "Of its bends, at their tightest."},
};
constexpr ElementParameter kDive[] = {
    {"height", "Height", "m", 20, 0.5, 300, "How much lower its end is."},
    {"angle", "Angle", "deg", 55, 2, 90, "The steepest it gets."},
    {"radius", "Radius", "m", 22, 3, 500, "Of its bends, at their tightest."},
};
constexpr ElementParameter kCamelback[] = {
    {"height", "Height", "m", 14, 1, 150, "Of its crest over its foot."},
    {"speed", "At speed", "m/s", 22, 5, 100,
     "Of the train at the foot: at this speed riders float over the whole crest, which is the parabola of a thrown "
     "stone."},
    {"radius", "Radius", "m", 25, 3, 500, "Of the bends at its feet, at their tightest."},
};
constexpr ElementParameter kLoop[] = {
    {"height", "Height", "m", 16, 3, 100, "Of its top over its foot."},
    {"top", "Top", "deg", 90, 0, 240,
     "How many degrees of it, round the top, are a circle; the rest are clothoids, which open towards the foot."},
    {"shift", "Shift", "m", 3.5, 2.5, 30, "How far to the side it ends, so that it does not hit itself."},
};
constexpr ElementParameter kCorkscrew[] = {
    {"height", "Height", "m", 9, 3, 60, "Of its top over its foot."},
    {"angle", "Axis", "deg", 45, 10, 70, "Between the way in and the axis that it winds around."},
    {"top", "Top", "deg", 150, 0, 240,
     "How many degrees of its turn are a helix proper; before and after that it opens."},
};

constexpr ElementRow kRows[] = {
    {"straight", "Straight", "Straight on; can roll.", false, kStraight},
    {"curve", "Curve",
     "A turn: clothoid, circle, clothoid, banked towards the inside. It keeps the slope it starts with.", true, kCurve},
    {"helix", "Helix", "Turns round and round, up or down, and ends level.", true, kHelix},
    {"climb", "Climb", "Up to a height, and level there: for lifts.", false, kClimb},
    {"dive", "Dive", "Down by a height, and level there.", false, kDive},
    {"camelback", "Camelback", "A hill over which riders float: a parabola between clothoids.", false, kCamelback},
    {"loop", "Loop",
     "Over the top in a teardrop: its curvature rises from the foot to the top, so that the foot does not crush.", true,
     kLoop},
    {"corkscrew", "Corkscrew",
     "Upside down around an axis that lies across: ends upright and straight ahead, to the side.", true, kCorkscrew},
};

}  // namespace

std::span<const ElementRow> elements() { return kRows; }

Element usual_element(ElementKind kind) {
  Element element{kind, false, {}};
  const std::span<const ElementParameter> parameters = base::row_of(kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) element.values[i] = parameters[i].usual;
  return element;
}

double value_of(const Element& element, std::string_view parameter) {
  const std::span<const ElementParameter> parameters = base::row_of(element.kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].name == parameter) return element.values[i];
  COASTER_CHECK(false, "the element has this parameter");
  return 0;
}

}  // namespace coaster::world
