// The tables of colourings and pages.
#include "world/laboratory.h"

namespace coaster::world {
namespace {

constexpr ColouringRow kColourings[] = {
    {"plain", "Plain", "", "Painted steel."},
    {"speed", "Speed", "m/s", "Speed of the ride as simulated over the present track.", true},
    {"height", "Height", "m", "Height over the ground."},
    {"vertical", "Vertical g", "g", "What presses riders into the seat; 1 at rest, below 0 they float.", true},
    {"lateral", "Lateral g", "g", "What pushes riders to either side.", true},
    {"longitudinal", "Longitudinal g", "g", "What pushes riders into the seat's back; below 0 into the bar.", true},
    {"curvature", "Curvature", "1/m", "1 / radius of the osculating circle."},
    {"error", "Evaluator error", "mm", "Distance of the chosen evaluator's vertices from the exact curve."},
};

constexpr LabPageRow kPages[] = {
    {"construction", "De Casteljau's construction of the point at the probe."},
    {"weights", "The Bernstein weights of the control points."},
    {"hodograph", "The derivative's curve."},
    {"error", "Error of the chosen evaluator along the segment."},
    {"lengths", "Arc length by every method, and how fast each converges."},
    {"frames", "How carts are turned; curvature and torsion."},
    {"joints", "Continuity at the joints."},
    {"errata", "Claims of the paper beside what is right."},
    {"measurements", "Time and error of every evaluator, measured on this machine."},
    {"forces", "Speed, height and g of the whole ride, what may not last that long, and ratings."},
};

}  // namespace

std::span<const ColouringRow> colourings() { return kColourings; }
std::span<const LabPageRow> lab_pages() { return kPages; }

}  // namespace coaster::world
