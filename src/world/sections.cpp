#include "world/sections.h"

#include <algorithm>

#include "base/enum_names.h"
#include "world/element_rows.h"

namespace coaster::world {

std::vector<SectionRun> sections_of(const Document& document) {
  std::vector<SectionRun> runs;
  const std::vector<Entity>& segments = document.track.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Entity section = segment(document, segments[i]).section;
    if (i == 0 || runs.back().section != section) runs.push_back({section, i, 0});
    ++runs.back().count;
  }
  return runs;
}

SectionRun run_of(const Document& document, Entity section) {
  const std::vector<Entity>& segments = document.track.segments;
  const auto inside = [&](Entity e) { return segment(document, e).section == section; };
  const auto first = std::find_if(segments.begin(), segments.end(), inside);
  COASTER_CHECK(first != segments.end(), "a section has segments");
  const auto last = std::find_if_not(first, segments.end(), inside);
  return {section, static_cast<std::size_t>(first - segments.begin()), static_cast<std::size_t>(last - first)};
}

Entity section_of_knot(const Document& document, Entity knot) {
  const KnotSegments sides = neighbours(document, knot);
  if (sides.before.valid()) return segment(document, sides.before).section;
  return sides.after.valid() ? segment(document, sides.after).section : kNone;
}

const Section& section(const Document& document, Entity e) { return document.entities.get<Section>(e); }
bool is_free(const Document& document, Entity e) { return section(document, e).kind == SectionKind::free; }

std::optional<SectionRun> completing(const Document& document, std::size_t knot) {
  const std::vector<Entity>& segments = document.track.segments;
  if (!document.track.closed) return std::nullopt;
  for (std::size_t i = segments.size(); i-- > knot;)
    if (const Entity e = segment(document, segments[i]).section; section(document, e).kind == SectionKind::complete) {
      const SectionRun run = run_of(document, e);
      if (run.first >= knot) return run;
      break;
    }
  return std::nullopt;
}

void take_look(const Section& from, Section& to) { to.paint = from.paint, to.earthwork = from.earthwork; }

Section without_plan(const Section& section) {
  Section shaped;
  shaped.title = section.title;
  take_look(section, shaped);
  return shaped;
}

std::string_view kind_name(const Section& section) {
  return section.kind == SectionKind::element ? base::name_of(section.element.kind) : base::name_of(section.kind);
}

std::string title_of(const Section& section) {
  if (!section.title.empty()) return section.title;
  return std::string(section.kind == SectionKind::element ? base::row_of(section.element.kind).label
                                                          : base::row_of(section.kind).label);
}

std::string words_of(ElementKind kind) {
  const ElementRow& row = base::row_of(kind);
  std::string words(row.label);
  if (!row.proper) words[0] = static_cast<char>(words[0] - 'A' + 'a');
  return words;
}

std::string words_of(const Section& section) {
  if (!section.title.empty()) return '"' + section.title + '"';
  switch (section.kind) {
    case SectionKind::free: return "the hand-shaped section";
    case SectionKind::element: return "the " + words_of(section.element.kind);
    case SectionKind::complete: return "the closing section";
    case SectionKind::force: return "the force section";
  }
  return {};
}

}  // namespace coaster::world
