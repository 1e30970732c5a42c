// Queries of the track's sections.
#include <array>

#include "query/rows.h"
#include "sim/study/section_figures.h"
#include "world/sections.h"

namespace coaster::query {
namespace {

// Returns the value of `function` for the segments of the section that the argument names.
template <class Function>
Answer of_run(const Context& c, View argument, Function function) {
  return of_entity(c, argument, world::Kind::section,
                   [&](world::Entity e) { return function(world::run_of(c.session.document, e)); });
}
std::string knot_at(const Context& c, std::size_t index) {
  const auto& knots = c.session.document.track.knots;
  return world::label_of(c.session.document, knots[index % knots.size()]);
}

Answer sections(const Context& c, View) { return number(c.session.document.entities.pool<world::Section>().size()); }
Answer section_kind(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::section, [&](world::Entity e) {
    return std::string(world::kind_name(world::section(c.session.document, e)));
  });
}
Answer section_title(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::section,
                   [&](world::Entity e) { return world::title_of(world::section(c.session.document, e)); });
}
Answer section_segments(const Context& c, View argument) {
  return of_run(c, argument, [](const world::SectionRun& run) { return run.count; });
}
Answer section_length(const Context& c, View argument) {
  return of_run(c, argument, [&](const world::SectionRun& run) {
    const std::vector<double>& starts = c.session.derived.starts;
    return starts[run.end()] - starts[run.first];
  });
}
Answer section_first(const Context& c, View argument) {
  return of_run(c, argument, [&](const world::SectionRun& run) { return knot_at(c, run.first); });
}
Answer section_last(const Context& c, View argument) {
  return of_run(c, argument, [&](const world::SectionRun& run) { return knot_at(c, run.end()); });
}
Answer section_of(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::segment, [&](world::Entity e) {
    return world::label_of(c.session.document, world::segment(c.session.document, e).section);
  });
}
// Returns a figure of the section; none if the ride does not reach it.
template <auto Member>
Answer section_figure(const Context& c, View argument) {
  return of_run(c, argument, [&](const world::SectionRun& run) -> Value {
    const auto value = c.find.sections().of(run).*Member;
    return value_of(value);
  });
}
// The argument is "@q1.height".
Answer section_value(const Context& c, View argument) {
  const std::size_t dot = argument.find('.');
  const auto entity = entity_of(c, argument.substr(0, dot), world::Kind::section);
  if (!entity) return entity.status();
  const world::Section& section = world::section(c.session.document, *entity);
  if (section.kind != world::SectionKind::element) return none("the section has no parameters");
  return parameter_of(section.element, argument.substr(dot + 1));
}

constexpr ArgumentPart kSectionParameter[]{kSection[0],
                                           {.usage = "PARAMETER", .words = parameter_names, .before = '.'}};
std::vector<std::string> kinds() {
  std::vector<std::string> words = base::names_of<world::ElementKind>();
  for (const auto kind : {world::SectionKind::free, world::SectionKind::complete, world::SectionKind::force})
    words.emplace_back(base::name_of(kind));
  return words;
}

constexpr std::array kSectionRows{
    Query{"sections", kNoArgument, "", "Number of sections of the track.", sections},
    Query{"section.of", kSegment, "", "The section of a segment, such as q2.", section_of, kText},
    Query{"section.kind",
          kSection,
          "",
          "What a section was planned as, such as loop; free if shaped by hand.",
          section_kind,
          {Type::text, kinds}},
    Query{"section.title", kSection, "", "A section's title; without one its kind.", section_title, kText},
    Query{"section.value", kSectionParameter, "",
          "A parameter that a section was planned with, such as @q2.height; none if it has no such parameter.",
          section_value, or_none({Type::parameter})},
    Query{"section.length", kSection, "m", "A section's length.", section_length},
    Query{"section.top", kSection, "m", "A section's largest height.", section_figure<&sim::SectionFigures::top>},
    Query{"section.speed_in", kSection, "m/s",
          "Speed of the chosen seat where a section begins; none where the ride does not arrive.",
          section_figure<&sim::SectionFigures::speed_in>, or_none()},
    Query{"section.speed_out", kSection, "m/s", "The same where it ends.",
          section_figure<&sim::SectionFigures::speed_out>, or_none()},
    Query{"section.g_most", kSection, "g", "Largest vertical felt g of the chosen seat on a section, not low-passed.",
          section_figure<&sim::SectionFigures::g_most>, or_none()},
    Query{"section.g_least", kSection, "g", "Least vertical g on it.", section_figure<&sim::SectionFigures::g_least>,
          or_none()},
    Query{"section.g_side", kSection, "g", "Largest lateral g on it, to either side.",
          section_figure<&sim::SectionFigures::g_side>, or_none()},
    Query{"section.segments", kSection, "", "Number of a section's segments.", section_segments},
    Query{"section.first", kSection, "", "The knot where a section begins.", section_first, kText},
    Query{"section.last", kSection, "", "The knot where a section ends.", section_last, kText},
};

}  // namespace

std::span<const Query> section_rows() { return kSectionRows; }

}  // namespace coaster::query
