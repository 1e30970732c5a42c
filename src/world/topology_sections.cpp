// Makes, resizes, removes and swaps sections.
#include <algorithm>

#include "world/sections.h"
#include "world/topology.h"
#include "world/topology_parts.h"

namespace coaster::world {
namespace {

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
    for (Cart& cart : document.entities.pool<Cart>().items())
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

Entity make_section(Document& document, std::size_t first, std::size_t count, Section value) {
  const std::vector<Entity>& segments = document.track.segments;
  COASTER_CHECK(count > 0 && first + count <= segments.size(), "a section has segments of the track");
  const Entity before = section_at(document, first - 1), after = section_at(document, first + count);
  const auto put = [&](std::size_t i, Entity e) { document.entities.get<Segment>(segments[i]).section = e; };
  if (before == after && before.valid()) {
    const Entity rest = create_section(document);
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
    const Entity knot = create_named(document, Kind::knot);
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
