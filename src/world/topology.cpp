// Changes of the track: knots, segments, sections, joints and orientation. Orientation is computed in double and
// rounded to float once; stored values use no libm function except sqrt, so knots have the same bits everywhere.
#include "world/topology.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/portable_math.h"
#include "curve/arc_length.h"
#include "curve/frames.h"
#include "world/sections.h"

namespace coaster::world {
namespace {

constexpr double kAcceptedTolerance = 1e-6;  // of squared length and of the cosine between tangent and up
constexpr double kShortDirection = 1e-9;     // m, shorter vectors have no reliable direction

bool unit(glm::vec3 v) {
  const glm::dvec3 d(v);
  return std::abs(glm::dot(d, d) - 1.0) <= kAcceptedTolerance;
}
glm::dvec3 forward_of(const Knot& knot) { return glm::normalize(glm::dvec3(knot.tangent)); }

double chord(glm::vec3 a, glm::vec3 b) { return glm::length(glm::dvec3(b) - glm::dvec3(a)); }

float third(double length) { return as_handle(length / 3.0); }

void remove_carts_on(Document& document, Entity segment_entity) {
  const std::vector<Entity> carts = document.entities.pool<Train>().entities();  // a copy: destroying reorders the pool
  for (const Entity e : carts)
    if (document.entities.get<Train>(e).segment == segment_entity) document.entities.destroy(e);
}

// Gives it the next number of its kind.
Entity create_named(Document& document, EntityKind kind) {
  std::uint32_t& last = document.last_number[static_cast<std::size_t>(kind)];
  COASTER_CHECK(last < std::numeric_limits<std::uint32_t>::max(), "numbers are never used again");
  const Entity e = document.entities.create();
  document.entities.put(e, EntityName{kind, ++last});
  return e;
}

// Creates a free one.
Entity create_section(Document& document) {
  const Entity e = create_named(document, EntityKind::section);
  document.entities.put(e, Section{});
  return e;
}

Entity create_segment(Document& document, Entity from, Entity to, Entity section) {
  const Entity e = create_named(document, EntityKind::segment);
  document.entities.put(e, Segment{from, to, 0, section});
  return e;
}

// Returns the section of the segment at that index; kNone beyond the order's ends.
Entity section_at(const Document& document, std::size_t index) {
  const std::vector<Entity>& segments = document.track.segments;
  return index < segments.size() ? segment(document, segments[index]).section : kNone;
}

// Removes a segment and the trains on it, and its section if it was the section's last segment.
void remove_segment(Document& document, std::size_t index) {
  std::vector<Entity>& segments = document.track.segments;
  remove_carts_on(document, segments[index]);
  const Entity section = section_at(document, index);
  const bool last_of_it = section_at(document, index - 1) != section && section_at(document, index + 1) != section;
  if (last_of_it && document.entities.alive(section)) document.entities.destroy(section);
  document.entities.destroy(segments[index]);
  segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(index));
}

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
  for (Train& cart : document.entities.pool<Train>().items())
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
  for_carts_on(document, before, [&](Train& c) { c.fraction = as_fraction(c.fraction * first, first + second); });
  for_carts_on(document, after, [&](Train& c) {
    c.segment = before, c.fraction = as_fraction(first + c.fraction * second, first + second);
  });
  const Segment removed = segment(document, after);
  Segment& survivor = document.entities.get<Segment>(before);
  survivor.to = removed.to;
  survivor.turns = std::clamp(survivor.turns + removed.turns, -kMaxTurns, kMaxTurns);
  remove_segment(document, after_index);
}

// Makes the segments [begin, end) lead from knot to knot again.
void link_segments(Document& document, std::size_t begin, std::size_t end) {
  const Track& track = document.track;
  for (std::size_t i = begin; i < end; ++i) {
    Segment& segment = document.entities.get<Segment>(track.segments[i]);
    segment.from = track.knots[i], segment.to = track.knots[(i + 1) % track.knots.size()];
  }
}

// Merges the segments [survivor, end) into the first of them, as remove_knot() does with two, but in a time that is
// linear in their number, and without a look at shapes: turns and trains' fractions stay.
void merge_run(Document& document, std::size_t survivor, std::size_t end) {
  Track& track = document.track;
  const Entity whole = track.segments[survivor];
  for (std::size_t i = end; i-- > survivor + 1;) {
    const Entity merged = track.segments[i];
    for (Train& cart : document.entities.pool<Train>().items())
      if (cart.segment == merged) cart.segment = whole;
    document.entities.destroy(merged), document.entities.destroy(track.knots[i]);
  }
  const auto erase = [&](std::vector<Entity>& order) {
    order.erase(order.begin() + static_cast<std::ptrdiff_t>(survivor) + 1,
                order.begin() + static_cast<std::ptrdiff_t>(end));
  };
  erase(track.segments), erase(track.knots);
  link_segments(document, survivor, survivor + 1);
}

}  // namespace

void orthonormalise(Knot& knot) {
  const glm::dvec3 tangent(knot.tangent);
  const double length = glm::length(tangent);
  if (!(length > 0) || !std::isfinite(length)) knot.tangent = {1, 0, 0};
  else if (!unit(knot.tangent)) knot.tangent = glm::vec3(tangent / length);
  const bool right = std::abs(glm::dot(glm::dvec3(knot.tangent), glm::dvec3(knot.up))) <= kAcceptedTolerance;
  if (!unit(knot.up) || !right) knot.up = glm::vec3(curve::perpendicular(forward_of(knot), glm::dvec3(knot.up)));
}

void set_tangent(Knot& knot, glm::vec3 direction) {
  const glm::dvec3 wanted(direction);
  const double length = glm::length(wanted);
  if (!(length >= kShortDirection) || !std::isfinite(length)) return;
  const glm::vec3 tangent(wanted / length);
  if (tangent == knot.tangent) return;  // keeps the bits of `up`: settling twice changes nothing
  const glm::dvec3 from = forward_of(knot), up = curve::perpendicular(from, glm::dvec3(knot.up));
  knot.tangent = tangent;
  const glm::dvec3 forward = forward_of(knot);
  // For a reversal the axis is up itself, which does not change.
  knot.up = glm::vec3(curve::perpendicular(forward, curve::least_rotation(from, forward, up, up)));
}

double roll_deg(const Knot& knot) {
  const glm::dvec3 forward = forward_of(knot), level = curve::perpendicular(forward, {0, 1, 0});
  return base::degrees(curve::signed_angle(level, glm::dvec3(knot.up), forward));
}

void set_roll(Knot& knot, double degrees) {
  if (!std::isfinite(degrees)) return;
  const glm::dvec3 forward = forward_of(knot), level = curve::perpendicular(forward, {0, 1, 0});
  // remainder() is exact, so any number of whole turns gives the same bits.
  const glm::dvec3 up = curve::rotate(level, forward, base::radians(std::remainder(degrees, 360.0)));
  knot.up = glm::vec3(curve::perpendicular(forward, up));
}

void shape_between(Knot& knot, const glm::vec3* before, const glm::vec3* after) {
  if (!before && !after) return;
  // In double: float differences of distant positions would lose the direction of short chords.
  const glm::dvec3 start(before ? *before : knot.position), end(after ? *after : knot.position);
  set_tangent(knot, glm::vec3(end - start));
  knot.in_length = third(before ? chord(*before, knot.position) : chord(knot.position, *after));
  knot.out_length = third(after ? chord(knot.position, *after) : chord(*before, knot.position));
}

void settle_joints(Document& document) {
  const Track& track = document.track;
  const std::size_t count = track.knots.size();
  auto& knots = document.entities.pool<Knot>();
  bool any_automatic = false;
  for (Knot& k : knots.items()) {
    any_automatic = any_automatic || k.joint == JointKind::automatic;
    if (k.joint == JointKind::smooth && k.in_length != k.out_length) k.in_length = k.out_length;
  }
  if (!any_automatic) return;
  const auto position = [&](std::size_t i) { return &knots.get(track.knots[i]).position; };
  for (std::size_t i = 0; i < count; ++i) {
    Knot& k = knots.get(track.knots[i]);
    if (k.joint != JointKind::automatic) continue;
    const glm::vec3* const before = i > 0 ? position(i - 1) : track.closed ? position(count - 1) : nullptr;
    const glm::vec3* const after = i + 1 < count ? position(i + 1) : track.closed ? position(0) : nullptr;
    shape_between(k, before, after);
  }
}

Entity add_cart(Document& document, Entity segment_entity, double fraction) {
  const Entity e = create_named(document, EntityKind::cart);
  document.entities.put(e, Train{segment_entity, as_fraction(fraction, 1.0)});
  return e;
}

Entity append_knot(Document& document, const Knot& value) {
  Track& track = document.track;
  COASTER_CHECK(!track.closed, "only an open track has an end to append to");
  const Entity e = create_named(document, EntityKind::knot);
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

  const Entity e = create_named(document, EntityKind::knot);
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
  for_carts_on(document, first, [&](Train& cart) {
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
                 [&](Train& cart) { cart.segment = track.segments.front(), cart.fraction = 0; });
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

Entity make_section(Document& document, std::size_t first, std::size_t count, Section value) {
  const std::vector<Entity>& segments = document.track.segments;
  COASTER_CHECK(count > 0 && first + count <= segments.size(), "a section has segments of the track");
  const Entity before = section_at(document, first - 1), after = section_at(document, first + count);
  const auto put = [&](std::size_t i, Entity e) { document.entities.get<Segment>(segments[i]).section = e; };
  if (before == after && before.valid()) {
    const Entity rest = create_section(document);
    take_look(section(document, before), document.entities.get<Section>(rest));
    for (std::size_t i = first + count; section_at(document, i) == before; ++i) put(i, rest);
  }
  Entity made;
  for (std::size_t i = first; i < first + count; ++i) {
    const Entity former = section_at(document, i);
    const bool whole = former != before && former != after && document.entities.alive(former);
    if (whole && !made.valid()) made = former;
    else if (whole && former != made) document.entities.destroy(former);
    put(i, kNone);
  }
  if (!made.valid()) made = create_section(document);
  for (std::size_t i = first; i < first + count; ++i) put(i, made);
  document.entities.put(made, std::move(value));
  return made;
}

void resize_section(Document& document, Entity section, std::size_t count) {
  COASTER_CHECK(count > 0, "a section has segments");
  Track& track = document.track;
  SectionRun run = run_of(document, section);
  if (run.count > count) {
    const bool opens = track.closed && count + track.knots.size() - run.count < 2;
    merge_run(document, run.first + count - (opens ? 0 : 1), run.end());
    if (opens) remove_knot(document, track.knots[run.first + count]);
    return;
  }
  for (; run.count < count; ++run.count) {
    const Entity before = track.segments[run.end() - 1], end = segment(document, before).to;
    const Entity knot = create_named(document, EntityKind::knot);
    document.entities.put(knot, Knot(world::knot(document, end)));
    const Entity after = create_segment(document, knot, end, section);
    document.entities.get<Segment>(before).to = knot;
    copy_fittings(document, before, document, after);
    const auto place = static_cast<std::ptrdiff_t>(run.end());
    track.knots.insert(track.knots.begin() + place, knot);
    track.segments.insert(track.segments.begin() + place, after);
  }
}

void remove_section(Document& document, Entity section) {
  Track& track = document.track;
  const SectionRun run = run_of(document, section);
  const bool follows = run.end() < track.segments.size();
  COASTER_CHECK(!track.closed || follows, "the last section of a closed track leads to its first knot");
  for (std::size_t i = run.end(); i-- > run.first;) remove_segment(document, i);
  const auto from = track.knots.begin() + static_cast<std::ptrdiff_t>(run.first + (run.first == 0 && follows ? 0 : 1)),
             to = from + static_cast<std::ptrdiff_t>(run.count);
  for (auto knot = from; knot != to; ++knot) document.entities.destroy(*knot);
  track.knots.erase(from, to);
  link_segments(document, run.first, track.segments.size());
}

void swap_sections(Document& document, Entity section) {
  Track& track = document.track;
  const SectionRun run = run_of(document, section), next = run_of(document, section_at(document, run.end()));
  COASTER_CHECK(!track.closed || next.end() < track.segments.size(), "no knot belongs to two ends");
  const auto rotate = [&](std::vector<Entity>& order, std::size_t begin) {
    const auto first = order.begin() + static_cast<std::ptrdiff_t>(begin),
               middle = first + static_cast<std::ptrdiff_t>(run.count);
    std::rotate(first, middle, middle + static_cast<std::ptrdiff_t>(next.count));
  };
  rotate(track.segments, run.first), rotate(track.knots, run.first + 1);
  link_segments(document, run.first, track.segments.size());
}

}  // namespace coaster::world
