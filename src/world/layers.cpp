// The table of layers.
#include "world/layers.h"

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

}  // namespace

std::span<const base::NameRow> layers() { return kLayers; }

}  // namespace coaster::world
