// The table of layers.
#include "world/layers.h"

namespace coaster::world {
namespace {

constexpr base::NameRow kLayers[] = {
    {"polyline", "Polyline", "The evaluated polyline over the track."},
    {"frames", "Frames", "Frames along the track: tangent (red), normal (green), binormal (blue)."},
    {"comb", "Curvature comb",
     "Curvature times the comb's scale, pointing away from the centre of curvature. A step marks a joint that is not "
     "G2."},
    {"circle", "Osculating circle", "Osculating circle at the probe: radius 1 / curvature."},
    {"construction", "Construction", "De Casteljau's construction of the curve point at the probe."},
    {"rounding", "Rounding",
     "Float rounding of the polyline: each vertex is displaced by its error times the magnification."},
    {"flips", "Frenet failures###Frenet's failures", "Where the Frenet normal flips or is undefined."},
    {"limits", "Highlight overloads###Red spans",
     "Where g exceeds its limit for longer than allowed. Not a compliance check."},
    {"supports", "Supports", "Supports, built automatically and clear of the trains."},
    {"knots", "Knots", "Knots and their handles. Hidden ones can still be selected."},
    {"conflicts", "Conflicts", "Where the track lacks clearance from itself."},
};

}  // namespace

std::span<const base::NameRow> layers() { return kLayers; }

}  // namespace coaster::world
