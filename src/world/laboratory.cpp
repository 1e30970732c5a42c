// The tables of colourings and pages.
#include "world/laboratory.h"

namespace coaster::world {
namespace {

constexpr ColouringRow kColourings[] = {
    {"plain", "Plain", "", "Painted steel."},
    {"speed", "Speed", "m/s", "Speed of the simulated ride.", true},
    {"height", "Height", "m", "Height above the ground."},
    {"vertical", "Vertical g", "g", "Presses riders into the seat. 1 at rest, below 0 in airtime.", true},
    {"lateral", "Lateral g", "g", "Pushes riders sideways.", true},
    {"longitudinal", "Longitudinal g", "g", "Pushes riders into the backrest. Below 0 into the lap bar.", true},
    {"curvature", "Curvature", "1/m", "1 / radius of the osculating circle."},
    {"error", "Evaluator error", "mm", "Distance of the selected evaluator's vertices from the exact curve."},
};

constexpr base::NameRow kPages[] = {
#define COASTER_ROW(name, label, help) {#name, label, help},
    COASTER_LAB_PAGES(COASTER_ROW)
#undef COASTER_ROW
};

}  // namespace

std::span<const ColouringRow> colourings() { return kColourings; }
std::span<const base::NameRow> lab_pages() { return kPages; }

}  // namespace coaster::world
