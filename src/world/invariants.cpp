// Checks every invariant of document.h, components.h and registry.h. For tests and after loading.
#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"
#include "world/sections.h"

namespace coaster::world {
namespace {

using Broken = std::optional<std::string>;

// Twice the tolerance of orthonormalise(): rounding to float afterwards must not break the invariant.
constexpr double kUnitTolerance = 2e-6;

bool within(double value, double low, double high) { return value >= low && value <= high; }  // false for NaN

Broken broken_knot(const Document& document, Entity e) {
  const Knot& k = knot(document, e);
  const auto broken = [&](const char* what) { return fmt::format("{}: {}", label_of(document, e), what); };
  for (int axis = 0; axis < 3; ++axis)
    if (!within(k.position[axis], -kMaxCoordinate, kMaxCoordinate)) return broken("position beyond the limit");
  const glm::dvec3 tangent(k.tangent), up(k.up);
  if (!within(glm::dot(tangent, tangent), 1 - kUnitTolerance, 1 + kUnitTolerance)) return broken("tangent is not unit");
  if (!within(glm::dot(up, up), 1 - kUnitTolerance, 1 + kUnitTolerance)) return broken("up is not unit");
  if (!within(glm::dot(tangent, up), -kUnitTolerance, kUnitTolerance)) return broken("up is not perpendicular");
  if (!within(k.in_length, kMinHandle, kMaxHandle) || !within(k.out_length, kMinHandle, kMaxHandle))
    return broken("handle length beyond the limits");
  if (!within(k.spin, -kMaxSpin, kMaxSpin)) return broken("spin beyond the limit");
  if (k.joint == JointKind::smooth && k.in_length != k.out_length) return broken("smooth joint with unequal lengths");
  return {};
}

Broken broken_names(const Document& document) {
  const auto& names = document.entities.pool<EntityName>();
  if (names.size() != document.entities.size()) return "an entity without a name";
  std::vector<EntityName> sorted = names.items();
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    return to_text(*twice) + ": the name is taken twice";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const EntityName name = names.items()[i];
    const Entity e = names.entities()[i];
    if (name.number < 1 || name.number > document.last_number[static_cast<std::size_t>(name.kind)])
      return to_text(name) + ": number beyond the last one given";
    if (!document.entities.alive(e)) return to_text(name) + ": names a dead entity";
    const bool knot_here = document.entities.find<Knot>(e), segment_here = document.entities.find<Segment>(e),
               cart_here = document.entities.find<Train>(e), section_here = document.entities.find<Section>(e);
    if (knot_here != (name.kind == EntityKind::knot) || segment_here != (name.kind == EntityKind::segment) ||
        cart_here != (name.kind == EntityKind::cart) || section_here != (name.kind == EntityKind::section))
      return to_text(name) + ": components of another kind";
  }
  return {};
}

Broken broken_chain(const Document& document) {
  const Track& track = document.track;
  const std::size_t count = track.knots.size();
  if (count > kMaxKnots) return "more knots than the limit";
  if (track.closed && count < 2) return "a closed track has at least 2 knots";
  const std::size_t expected = track.closed ? count : count > 0 ? count - 1 : 0;
  if (track.segments.size() != expected) return "the number of segments does not fit the knots";
  if (document.entities.pool<Knot>().size() != count) return "a knot is not on the track, or twice";
  if (document.entities.pool<Segment>().size() != expected) return "a segment is not on the track, or twice";
  std::vector<char> seen;  // by slot
  const auto first_seen = [&](Entity e) {
    if (e.index >= seen.size()) seen.resize(e.index + 1);
    return std::exchange(seen[e.index], 1) == 0;
  };
  for (const Entity e : track.knots)
    if (!document.entities.find<Knot>(e) || !first_seen(e)) return "the order of knots is broken";
  for (std::size_t i = 0; i < expected; ++i) {
    const Entity e = track.segments[i];
    if (!document.entities.find<Segment>(e) || !first_seen(e)) return "the order of segments is broken";
    const Segment& s = segment(document, e);
    if (s.from != track.knots[i] || s.to != track.knots[(i + 1) % count])
      return label_of(document, e) + ": does not lead from its knot to the next";
    if (s.turns < -kMaxTurns || s.turns > kMaxTurns) return label_of(document, e) + ": turns beyond the limit";
  }
  return {};
}

bool within_limits(const ClosingPlan& way) {
  bool within = true;
  ClosingPlan::fields([&](const Field& field, auto member) {
    const auto value = way.*member;
    if constexpr (std::is_same_v<decltype(value), const double>)
      within = within && value >= field.low && value <= field.high;
  });
  return within;
}

bool sound(const Section& section) {
  if (section.title.size() > kMaxNameBytes || !base::is_printable_utf8(section.title)) return false;
  if (!base::has_row(section.kind)) return false;
  return (section.kind == SectionKind::element ? within_limits(section.element) && !is_of_forces(section.element.kind)
                                               : section.element == Element{}) &&
         (section.kind == SectionKind::complete ? within_limits(section.closing) : section.closing == ClosingPlan{}) &&
         (section.kind == SectionKind::force ? !broken(section.force) : section.force == ForceProgram{});
}

// Each segment belongs to a section, and the segments of a section are neighbours.
Broken broken_sections(const Document& document) {
  const std::vector<SectionRun> runs = sections_of(document);
  for (const SectionRun& run : runs) {
    const Section* const section = document.entities.find<Section>(run.section);
    if (!section) return label_of(document, document.track.segments[run.first]) + ": in no section";
    if (!sound(*section)) return label_of(document, run.section) + ": title or parameters beyond the limits";
  }
  std::vector<Entity> seen;
  for (const SectionRun& run : runs) seen.push_back(run.section);
  std::ranges::sort(seen);
  if (const auto twice = std::ranges::adjacent_find(seen); twice != seen.end())
    return label_of(document, *twice) + ": its segments are not neighbours";
  if (document.entities.pool<Section>().size() != runs.size()) return "a section without segments";
  return {};
}

Broken broken_park(const Park& park) {
  if (park.plain()) return park == Park() ? Broken() : "a park without a land";
  if (!within(park.relief, 0.0, kMaxRelief) || !within(park.woods, 0.0, 1.0) ||
      !within(park.water, kLowestWater, kHighestWater))
    return "park beyond the limits";
  constexpr int kHighest = static_cast<int>(kHighestGround / kHeightStep);
  for (const auto& [place, tile] : park.tiles.map()) {
    if (!in_square(place) || tile->empty()) return "a tile of the park outside the square, or one that holds nothing";
    for (const std::int16_t height : tile->heights)
      if (height != GroundTile::kSeeded && (height < -kHighest || height > kHighest))
        return "height of the park beyond the limit";
  }
  return {};
}

}  // namespace

std::optional<std::string> broken_invariant(const Document& document) {
  if (!within(document.start_speed, -kMaxSpeed, kMaxSpeed)) return "start speed beyond the limit";
  if (!within(document.datum, -double{kMaxCoordinate}, double{kMaxCoordinate})) return "datum beyond the limit";
  if (Broken broken = broken_park(document.park)) return broken;
  if (Broken broken = broken_names(document)) return broken;
  if (Broken broken = broken_chain(document)) return broken;
  if (Broken broken = broken_sections(document)) return broken;
  for (const Entity e : document.track.knots)
    if (Broken broken = broken_knot(document, e)) return broken;
  const auto& carts = document.entities.pool<Train>();
  for (std::size_t i = 0; i < carts.size(); ++i) {
    const Train& cart = carts.items()[i];
    if (!document.entities.find<Segment>(cart.segment))
      return label_of(document, carts.entities()[i]) + ": on no segment";
    if (!(cart.fraction >= 0 && cart.fraction < 1))
      return label_of(document, carts.entities()[i]) + ": fraction not in [0,1)";
  }
  return {};
}

}  // namespace coaster::world
