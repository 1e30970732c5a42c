// Queries of the park: its land, the ground as it is cut to the track, tunnels and trees.
#include <algorithm>
#include <cmath>
#include <limits>

#include "query/rows.h"
#include "sim/ground/ground.h"
#include "sim/ground/plants.h"
#include "sim/shape/derived_track.h"
#include "world/park.h"
#include "world/sections.h"

namespace coaster::query {
namespace {

constexpr View kNoLand = "there is no land";

// Row of a member of the park; none without a land.
template <auto member>
Answer of_park(const QueryContext& c, View) {
  const world::Park& park = c.session.document.park;
  return park.plain() ? none(kNoLand) : number(park.*member);
}
Answer water(const QueryContext& c, View) {
  const world::Park& park = c.session.document.park;
  if (park.plain()) return none(kNoLand);
  return park.water == world::kNoWater ? none("there is no water") : number(park.water);
}

// The argument is "X,Z".
Answer ground_height(const QueryContext& c, View place) {
  const std::size_t comma = place.find(',');
  const double x = *base::parse_double(place.substr(0, comma)), z = *base::parse_double(place.substr(comma + 1));
  return number(c.find.ground().height(x, z));
}

// Calls visit(sample) for points of the track, also where the ground is plain and has none.
void each_sample(const QueryContext& c, auto visit) {
  const sim::Ground& ground = c.find.ground();
  if (!ground.plain()) {
    std::ranges::for_each(ground.samples(), visit);
    return;
  }
  const sim::DerivedTrack& derived = c.session.derived;
  for (const world::Entity e : derived.order)
    std::ranges::for_each(sim::samples_of(derived.shape(e), ground.land()), visit);
}
Answer ground_clearance(const QueryContext& c, View) {
  double least = std::numeric_limits<double>::infinity();
  const sim::Ground& ground = c.find.ground();
  each_sample(c, [&](const sim::TrackSample& sample) {
    if (!sample.tunnel) least = std::fmin(least, sample.at.y - ground.height(sample.at.x, sample.at.z));
  });
  if (std::isfinite(least)) return number(least);
  return none(c.session.derived.order.empty() ? kNoSegment : "all of the track is in tunnels");
}

Answer tunnels_length(const QueryContext& c, View) {
  double sum = 0;
  for (const sim::Tunnel& tunnel : c.find.ground().tunnels()) sum += tunnel.length;
  return number(sum);
}
Answer trees(const QueryContext& c, View) { return number(c.find.ground().plain() ? 0 : c.find.plants().trees()); }

constexpr ArgumentPart kPlace[]{{.usage = "X", .number = true}, {.usage = "Z", .number = true, .before = ','}};

constexpr Query kParkRows[]{
    {"park", "", "The land around the coaster: plain without a park.",
     of_document<&world::Document::park, &world::Park::land>, kOneOf<world::Land>},
    {"park.seed", "", "Seed of the land; none without one.", of_park<&world::Park::seed>, or_none()},
    {"park.relief", "", "Factor of the land's heights; none without a land.", of_park<&world::Park::relief>, or_none()},
    {"park.woods", "", "How much of the land is wooded, 0 to 1; none without a land.", of_park<&world::Park::woods>,
     or_none()},
    {"park.water", "m", "Level of lakes and seas; none without water.", water, or_none()},
    {"park.tiles", "", "Number of tiles of 64 m that brushes have touched.",
     of_document<&world::Document::park, &world::Park::tiles, &world::GroundTiles::map>},
    {"ground.height", kPlace, "m",
     "Height of the ground at a place, such as 12,-30, as it is cut to the track; 0 without a park.", ground_height},
    {"ground.clearance", "m", "Least height of the rails above the ground outside tunnels; none without track there.",
     ground_clearance, or_none()},
    {"tunnels", "", "Number of tunnels.", of_findings<&edit::SessionFindings::ground, &sim::Ground::tunnels>},
    {"tunnels.length", "m", "Length of all tunnels.", tunnels_length},
    {"trees", "", "Number of trees, without bushes and rocks.", trees},
    {"section.earthwork", kSection, "",
     "What is done to the land where a section runs below it: automatic, cut, tunnel or none.",
     of_section<&world::Section::earthwork>, or_none(kOneOf<world::Earthwork>)},
};

}  // namespace

std::span<const Query> park_rows() { return kParkRows; }

}  // namespace coaster::query
