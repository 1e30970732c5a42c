// The tables of layers, colourings and pages.
#include "world/laboratory.h"

namespace coaster::world {
namespace {

constexpr base::NameRow kLayers[] = {
    {"polyline", "Polyline", "The evaluated polyline over the track, as the chosen method and resolution give it."},
    {"frames", "Frames", "The chosen frame along the track: tangent (red), normal (green), binormal (blue)."},
    {"comb", "Curvature comb",
     "Teeth of curvature times the comb's scale, away from the centre of curvature. A step in it is a joint that is "
     "not G2."},
    {"circle", "Osculating circle", "The circle that fits the curve best at the probe: radius 1 / curvature."},
    {"construction", "Construction",
     "De Casteljau's construction of the point at the probe: 3, 2 and 1 points between the control points."},
    {"rounding", "Rounding",
     "The polyline's float rounding, magnified: each vertex moved by its error times the magnification."},
    {"flips", "Frenet's failures", "Where the Frenet normal flips, or is undefined because there is no curvature."},
    {"limits", "Red spans", "Where some g of the ride lasts longer than it may (not a compliance check)."},
    {"supports", "Supports",
     "Columns that hold the track up, found by themselves where they leave the trains' way free."},
    {"knots", "Knots", "The knots and their handles; hidden ones can be picked all the same."},
    {"conflicts", "Conflicts",
     "Where the track is in its own way: a train on one stretch has too little room beside, under or over another."},
};

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

std::span<const base::NameRow> layers() { return kLayers; }
std::span<const ColouringRow> colourings() { return kColourings; }
std::span<const LabPageRow> lab_pages() { return kPages; }

}  // namespace coaster::world
