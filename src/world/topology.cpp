// Changes the track: creates, splits and removes knots, segments and trains. No undo, no checks of user input.
#include "world/topology.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/arc_length.h"
#include "world/topology_parts.h"

namespace coaster::world {
namespace {

// Adds a segment at the end of the order: to the last section if it is free, else to a new one.
void push_segment(Document& document, Entity from, Entity to) {
  std::vector<Entity>& segments = document.track.segments;
  Entity into = segments.empty() ? kNone : segment(document, segments.back()).section;
  const Section* const last = document.entities.find<Section>(into);
  const Entity e = create_segment(document, from, to, kNone);
  if (!last || last->kind != SectionKind::free) into = create_section(document);
  document.entities.get<Segment>(e).section = into;
  segments.push_back(e);
}

template <class Fn>
void for_carts_on(Document& document, Entity segment_entity, Fn fn) {
  for (Cart& cart : document.entities.pool<Cart>().items())
    if (cart.segment == segment_entity) fn(cart);
}

// Returns a fraction below 1, where the next segment begins.
double as_fraction(double part, double whole) {
  const double below_one = std::nextafter(1.0, 0.0);
  return whole > 0 ? std::clamp(part / whole, 0.0, below_one) : 0.0;
}

// Extends segments[before] over the knot between it and segments[after], and removes the latter.
void merge_segments(Document& document, std::size_t before_index, std::size_t after_index) {
  const Entity before = document.track.segments[before_index], after = document.track.segments[after_index];
  const double first = curve::arc_length(cubic_of(document, before)),
               second = curve::arc_length(cubic_of(document, after));
  for_carts_on(document, before, [&](Cart& c) { c.fraction = as_fraction(c.fraction * first, first + second); });
  for_carts_on(document, after, [&](Cart& c) {
    c.segment = before, c.fraction = as_fraction(first + c.fraction * second, first + second);
  });
  const Segment removed = segment(document, after);
  Segment& survivor = document.entities.get<Segment>(before);
  survivor.to = removed.to;
  survivor.turns = std::clamp(survivor.turns + removed.turns, -kMaxTurns, kMaxTurns);
  remove_segment(document, after_index);
}

void remove_carts_on(Document& document, Entity segment_entity) {
  const std::vector<Entity> carts = document.entities.pool<Cart>().entities();  // a copy: destroying reorders the pool
  for (const Entity e : carts)
    if (document.entities.get<Cart>(e).segment == segment_entity) document.entities.destroy(e);
}

}  // namespace

Entity create_named(Document& document, Kind kind) {
  std::uint32_t& last = document.last_number[static_cast<std::size_t>(kind)];
  COASTER_CHECK(last < std::numeric_limits<std::uint32_t>::max(), "numbers are never used again");
  const Entity e = document.entities.create();
  document.entities.put(e, Name{kind, ++last});
  return e;
}

Entity create_section(Document& document) {
  const Entity e = create_named(document, Kind::section);
  document.entities.put(e, Section{});
  return e;
}

Entity create_segment(Document& document, Entity from, Entity to, Entity section) {
  const Entity e = create_named(document, Kind::segment);
  document.entities.put(e, Segment{from, to, 0, section});
  return e;
}

Entity section_at(const Document& document, std::size_t index) {
  const std::vector<Entity>& segments = document.track.segments;
  return index < segments.size() ? segment(document, segments[index]).section : kNone;
}

void remove_segment(Document& document, std::size_t index) {
  std::vector<Entity>& segments = document.track.segments;
  remove_carts_on(document, segments[index]);
  const Entity section = section_at(document, index);
  const bool last_of_it = section_at(document, index - 1) != section && section_at(document, index + 1) != section;
  if (last_of_it && document.entities.alive(section)) document.entities.destroy(section);
  document.entities.destroy(segments[index]);
  segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(index));
}

Entity add_cart(Document& document, Entity segment_entity, double fraction) {
  const Entity e = create_named(document, Kind::cart);
  document.entities.put(e, Cart{segment_entity, as_fraction(fraction, 1.0)});
  return e;
}

Entity append_knot(Document& document, const Knot& value) {
  Track& track = document.track;
  COASTER_CHECK(!track.closed, "only an open track has an end to append to");
  const Entity e = create_named(document, Kind::knot);
  document.entities.put(e, value);
  if (!track.knots.empty()) push_segment(document, track.knots.back(), e);
  track.knots.push_back(e);
  return e;
}

SplitResult split_segment(Document& document, Entity first, double t, glm::vec3 up, float spin) {
  const auto index = index_of(document.track.segments, first);
  COASTER_CHECK(index, "the segment is on the track");
  const curve::Cubic whole = cubic_of(document, first);
  const curve::SplitCubic parts = curve::split(whole, t);
  const Entity from = segment(document, first).from, to = segment(document, first).to;
  const double lengths[4] = {
      t * knot(document, from).out_length, glm::length(glm::dvec3(parts.left.p3) - glm::dvec3(parts.left.p2)),
      glm::length(glm::dvec3(parts.right.p1) - glm::dvec3(parts.right.p0)), (1 - t) * knot(document, to).in_length};
  for (const double length : lengths)
    if (!(length >= kMinHandle && length <= kMaxHandle)) return {kNone, first, kNone};
  // A curve between knots at the coordinate limit can exceed it.
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(parts.left.p3[axis]) <= kMaxCoordinate)) return {kNone, first, kNone};

  Knot middle;
  middle.position = parts.left.p3;
  middle.tangent = glm::vec3(curve::unit_tangent(whole, t));
  middle.up = up;
  middle.spin = std::clamp(spin, -kMaxSpin, kMaxSpin);
  middle.joint = JointKind::aligned;
  middle.in_length = as_handle(lengths[1]), middle.out_length = as_handle(lengths[2]);
  orthonormalise(middle);

  const Entity e = create_named(document, Kind::knot);
  document.entities.put(e, middle);
  const Entity second = create_segment(document, e, to, segment(document, first).section);
  document.entities.get<Segment>(first).to = e;
  copy_fittings(document, first, document, second);
  const auto place = static_cast<std::ptrdiff_t>(*index) + 1;
  document.track.knots.insert(document.track.knots.begin() + place, e);
  document.track.segments.insert(document.track.segments.begin() + place, second);
  Knot& start = document.entities.get<Knot>(from);
  start.out_length = as_handle(lengths[0]);
  start.joint = JointKind::aligned;
  Knot& end = document.entities.get<Knot>(to);
  end.in_length = as_handle(lengths[3]);
  end.joint = JointKind::aligned;

  const double left = curve::arc_length(cubic_of(document, first)),
               right = curve::arc_length(cubic_of(document, second));
  for_carts_on(document, first, [&](Cart& cart) {
    const double s = cart.fraction * (left + right);
    cart.segment = s < left ? first : second,
    cart.fraction = s < left ? as_fraction(s, left) : as_fraction(s - left, right);
  });
  return {e, first, second};
}

void remove_knot(Document& document, Entity e) {
  Track& track = document.track;
  const auto index = index_of(track.knots, e);
  COASTER_CHECK(index, "the knot is on the track");
  const std::size_t i = *index, count = track.knots.size();
  if (track.closed && count == 2) {
    remove_segment(document, 1), remove_segment(document, 0);
    track.closed = false;
  } else if (track.closed) {
    merge_segments(document, (i + count - 1) % count, i);
  } else if (i > 0 && i + 1 < count) {
    merge_segments(document, i - 1, i);
  } else if (count > 1) {
    remove_segment(document, i == 0 ? 0 : i - 1);
  }
  document.entities.destroy(e);
  track.knots.erase(track.knots.begin() + static_cast<std::ptrdiff_t>(i));
}

void set_closed(Document& document, bool closed) {
  Track& track = document.track;
  if (closed == track.closed || track.knots.size() < 2) return;
  if (closed) {
    push_segment(document, track.knots.back(), track.knots.front());
  } else {
    for_carts_on(document, track.segments.back(),
                 [&](Cart& cart) { cart.segment = track.segments.front(), cart.fraction = 0; });
    remove_segment(document, track.segments.size() - 1);
  }
  track.closed = closed;
}

void reverse(Document& document) {
  Track& track = document.track;
  for (const Entity e : track.knots) {
    Knot& knot = document.entities.get<Knot>(e);
    knot.tangent = -knot.tangent;
    std::swap(knot.in_length, knot.out_length);
  }
  for (const Entity e : track.segments) {
    Segment& segment = document.entities.get<Segment>(e);
    std::swap(segment.from, segment.to);
  }
  std::reverse(track.knots.begin() + (track.closed ? 1 : 0), track.knots.end());
  std::reverse(track.segments.begin(), track.segments.end());
}

bool weld_ends(Document& document) {
  Track& track = document.track;
  if (track.closed || track.knots.size() < 3) return false;
  const Entity first = track.knots.front(), last = track.knots.back();
  Knot& joint = document.entities.get<Knot>(first);
  joint.in_length = knot(document, last).in_length;
  if (joint.in_length != joint.out_length || joint.joint == JointKind::automatic) joint.joint = JointKind::aligned;
  document.entities.get<Segment>(track.segments.back()).to = first;
  document.entities.destroy(last);
  track.knots.pop_back();
  track.closed = true;
  return true;
}

}  // namespace coaster::world
