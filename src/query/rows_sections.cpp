// Queries of sections: those of the track, those of forces, and the palette's element at the open end.

#include "base/portable_math.h"
#include "query/rows.h"
#include "sim/plan/force_plan.h"
#include "sim/study/complete_circuit.h"
#include "sim/study/riders.h"
#include "world/sections.h"

namespace coaster::query {
namespace {

// Returns the value of `function` for the segments of the section that the argument names.
template <class Function>
Answer of_run(const QueryContext& c, View argument, Function function) {
  return of_entity(c, argument, world::EntityKind::section,
                   [&](world::Entity e) { return std::invoke(function, world::run_of(c.session.document, e)); });
}
std::string knot_at(const QueryContext& c, std::size_t index) {
  const auto& knots = c.session.document.track.knots;
  return world::label_of(c.session.document, knots[index % knots.size()]);
}

Answer sections(const QueryContext& c, View) {
  return number(c.session.document.entities.pool<world::Section>().size());
}
Answer section_segments(const QueryContext& c, View argument) { return of_run(c, argument, &world::SectionRun::count); }
Answer section_length(const QueryContext& c, View argument) {
  return of_run(c, argument, [&](const world::SectionRun& run) {
    const std::vector<double>& starts = c.session.derived.starts;
    return starts[run.end()] - starts[run.first];
  });
}
Answer section_first(const QueryContext& c, View argument) {
  return of_run(c, argument, [&](const world::SectionRun& run) { return knot_at(c, run.first); });
}
Answer section_last(const QueryContext& c, View argument) {
  return of_run(c, argument, [&](const world::SectionRun& run) { return knot_at(c, run.end()); });
}
Answer section_of(const QueryContext& c, View argument) {
  return of_entity(c, argument, world::EntityKind::segment, [&](world::Entity e) {
    return world::label_of(c.session.document, world::segment(c.session.document, e).section);
  });
}
// Returns a figure of the section; none if the ride does not reach it.
template <auto Member>
Answer section_figure(const QueryContext& c, View argument) {
  return of_run(c, argument, [&](const world::SectionRun& run) { return c.find.sections().of(run).*Member; });
}
// The argument is "@q1.height".
Answer section_value(const QueryContext& c, View argument) {
  const std::size_t dot = argument.find('.');
  const auto entity = entity_of(c, argument.substr(0, dot), world::EntityKind::section);
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

constexpr Query kSectionRows[]{
    {"sections", "", "Number of sections of the track.", sections},
    {"section.of", kSegment, "", "The section of a segment, such as q2.", section_of, kText},
    {"section.kind", kSection, "", "What a section was planned as, such as loop; free if shaped by hand.",
     of_section<world::kind_name>, texts(kinds)},
    {"section.title", kSection, "", "A section's title; without one its kind.", of_section<world::title_of>, kText},
    {"section.paint", kSection, "", "Palette of a section's paint: own for the track's, mixed for other colours.",
     of_section<&world::Section::paint, palette_name>, kText},
    {"section.value", kSectionParameter, "",
     "A parameter that a section was planned with, such as @q2.height; none if it has no such parameter.",
     section_value, or_none({ValueType::parameter})},
    {"section.length", kSection, "m", "A section's length.", section_length},
    {"section.top", kSection, "m", "A section's largest height.", section_figure<&sim::SectionFigures::top>},
    {"section.speed_in", kSection, "m/s",
     "Speed of the chosen seat where a section begins; none where the ride does not arrive.",
     section_figure<&sim::SectionFigures::speed_in>, or_none()},
    {"section.speed_out", kSection, "m/s", "The same where it ends.", section_figure<&sim::SectionFigures::speed_out>,
     or_none()},
    {"section.g_most", kSection, "g", "Largest vertical felt g of the chosen seat on a section, not low-passed.",
     section_figure<&sim::SectionFigures::g_most>, or_none()},
    {"section.g_least", kSection, "g", "Least vertical g on it.", section_figure<&sim::SectionFigures::g_least>,
     or_none()},
    {"section.g_side", kSection, "g", "Largest lateral g on it, to either side.",
     section_figure<&sim::SectionFigures::g_side>, or_none()},
    {"section.segments", kSection, "", "Number of a section's segments.", section_segments},
    {"section.first", kSection, "", "The knot where a section begins.", section_first, kText},
    {"section.last", kSection, "", "The knot where a section ends.", section_last, kText},
};

const sim::ElementPlan& plan(const QueryContext& c) { return c.find.element(); }

Answer side(const QueryContext& c, View) {
  const world::Element& e = c.session.settings.element;
  return base::row_of(e.kind).sided ? text(e.right ? "right" : "left") : none("the element has no side");
}
Answer value(const QueryContext& c, View argument) { return parameter_of(plan(c).element, argument); }
// Returns a member of the plan; none if it has no spans.
template <auto... path>
Answer of_plan(const QueryContext& c, View) {
  const sim::ElementPlan& found = plan(c);
  return found.spans() > 0 ? value_at(found, path...) : none(found.refusal);
}
Answer spans(const QueryContext& c, View) { return number(plan(c).spans()); }
Answer missing(const QueryContext& c, View) {
  return plan(c).spans() > 0 ? number(sim::worst(c.find.room())) : none(plan(c).refusal);
}
Answer refusal(const QueryContext& c, View) { return text_or_none(plan(c).refusal, "it can be placed"); }

constexpr ArgumentPart kProposal[]{{.usage = "N", .most = sim::kMostProposals}};
// Returns function(index) of the proposal that the argument names, none without it.
template <class Function>
Answer of_proposal(const QueryContext& c, View argument, Function function) {
  const auto i = static_cast<std::size_t>(*base::parse_int(argument)) - 1;
  return i < c.find.circuit().list.size() ? value_of(function(i)) : none("there is no such closing section");
}
template <auto... path>
Answer of_circuit(const QueryContext& c, View argument) {
  return of_proposal(c, argument, [&](std::size_t i) { return value_at(c.find.circuit().list[i], path...); });
}
Answer circuit_jolt(const QueryContext& c, View argument) {
  return of_proposal(c, argument, [&](std::size_t i) { return c.find.closing_jolt(i); });
}
Answer circuit_refusal(const QueryContext& c, View) {
  return text_or_none(c.find.circuit().refusal, "there is a closing section");
}

constexpr ArgumentPart kParameter[]{{.words = parameter_names}};
std::vector<std::string> sides() { return {"left", "right"}; }

constexpr Query kElementRows[]{
    {"element", "", "The palette's element, such as loop.",
     of_session<&edit::Session::settings, &world::Settings::element, &world::Element::kind>,
     kOneOf<world::ElementKind>},
    {"element.side", "", "left or right; none for an element without a side.", side, or_none(texts(sides))},
    {"element.value", kParameter, "",
     "A parameter of the palette's element, such as radius, within its limits; none if it has no such parameter.",
     value, or_none({ValueType::parameter})},
    {"element.error", "m",
     "Largest distance of the palette's element, as Bezier spans, from its ideal curve; none without a plan.",
     of_plan<&sim::ElementPlan::fit, &sim::ElementFit::error>, or_none()},
    {"element.roll_error", "deg", "Largest angle between the spans' frames and the ideal curve's.",
     of_plan<&sim::ElementPlan::fit, &sim::ElementFit::roll_error, base::degrees>, or_none()},
    {"element.jump", "1/m", "Largest jump of curvature at the joints of the palette's element, including its first.",
     of_plan<&sim::ElementPlan::fit, &sim::ElementFit::jump>, or_none()},
    {"element.spans", "", "Number of Bezier spans of the palette's element.", spans},
    {"element.length", "m", "Length of the palette's element with its lead-in.", of_plan<&sim::ElementPlan::length>,
     or_none()},
    {"element.lead", "m", "Length of its lead-in, which eases the curvature of the open end and levels it.",
     of_plan<&sim::ElementPlan::lead>, or_none()},
    {"element.lowest", "m", "Lowest height (y) of its rails.", of_plan<&sim::ElementPlan::lowest>, or_none()},
    {"element.missing", "m", "Clearance missing between it and other track; 0 if there is enough.", missing, or_none()},
    {"element.refusal", "", "Why it cannot be placed; none if it can.", refusal, or_none(kText)},
    {"complete.proposals", "", "Number of closing sections that are proposed: 0 to 3.",
     of_findings<&edit::SessionFindings::circuit, &sim::CircuitProposals::list>},
    {"complete.length", kProposal, "m", "Length of a closing section; none without it.",
     of_circuit<&sim::CircuitProposal::plan, &sim::ElementPlan::length>, or_none()},
    {"complete.worst_g", kProposal, "g",
     "Largest vertical felt g on a closing section, not low-passed; none without it.",
     of_circuit<&sim::CircuitProposal::felt, &sim::FeltRange::most>, or_none()},
    {"complete.jolt", kProposal, "g",
     "Largest jolt at the joints of a closing section on a whole ride; none without it.", circuit_jolt, or_none()},
    {"complete.refusal", "", "Why there is no closing section; none if there is one.", circuit_refusal, or_none(kText)},
};

// Returns the value of `function` for the plan of the force section that the argument names; "none" for others.
template <class Function>
Answer of_plan(const QueryContext& c, View argument, Function function) {
  const auto section = entity_of(c, argument, world::EntityKind::section);
  if (!section) return section.status();
  const sim::ForcePlan* const plan = c.find.force(*section);
  return plan != nullptr ? function(*plan) : Answer(none("it is not a force section"));
}

// A position of a channel: "@q3.vertical/40".
struct ChannelPosition {
  View section;
  world::ForceChannel channel{};
  double at = 0;
};
ChannelPosition force_place(View word) {
  const std::size_t dot = word.find('.'), slash = word.find('/', dot);
  return {word.substr(0, dot), *base::value_named<world::ForceChannel>(word.substr(dot + 1, slash - dot - 1)),
          *base::parse_double(word.substr(slash + 1))};
}

// Returns a value of the plan's points at a position, linear between them.
double asked_at(const sim::ForcePlan& plan, const ChannelPosition& spot) {
  const auto value = [&](std::size_t i) { return plan.path.points[i].asked(spot.channel); };
  return sim::between_points(plan, spot.at, value);
}

// Returns nothing where the ride does not arrive.
std::optional<double> met_at(const QueryContext& c, const sim::ForcePlan& plan, const ChannelPosition& spot,
                             std::size_t first) {
  const double start = c.session.derived.starts[first];
  const sim::SimulatedRide* const ride = c.find.ride();
  const sim::RailTables& tables = c.find.tables();
  const auto length = [&](std::size_t i) { return plan.path.curve.points[i].s; };
  const double place = start + sim::between_points(plan, spot.at, length);
  if (plan.task.program.of == world::ForceQuantity::curvature)
    return sim::curvature_at(c.session.derived, first, place)[static_cast<std::size_t>(spot.channel)];
  const auto passing = ride != nullptr ? sim::passing(*ride, place) : std::nullopt;
  if (!passing) return std::nullopt;
  std::size_t index = 0;
  const double s = tables.locate(place, index), g = world::kGravity;
  if (spot.channel == world::ForceChannel::roll) {
    const double spin = base::degrees(c.session.derived.shape_at(index).roll.spin(s));
    return plan.task.program.over == world::ForceDomain::distance ? spin : spin * passing->speed;
  }
  const glm::vec3 felt = sim::felt_at(tables.segment(index), s, static_cast<float>(passing->along / g),
                                      static_cast<float>(passing->speed * passing->speed / g));
  return double{spot.channel == world::ForceChannel::vertical ? felt.z : felt.y};
}

Answer force_asked(const QueryContext& c, View word) {
  const ChannelPosition spot = force_place(word);
  return of_plan(c, spot.section, [&](const sim::ForcePlan& plan) { return number(asked_at(plan, spot)); });
}
Answer force_met(const QueryContext& c, View word) {
  const ChannelPosition spot = force_place(word);
  return of_plan(c, spot.section, [&](const sim::ForcePlan& plan) {
    const auto section = entity_of(c, spot.section, world::EntityKind::section);
    const world::SectionRun run = world::run_of(c.session.document, *section);
    return value_of(met_at(c, plan, spot, run.first));
  });
}
Answer force_keys(const QueryContext& c, View word) {
  const std::size_t dot = word.find('.');
  const auto channel = *base::value_named<world::ForceChannel>(word.substr(dot + 1));
  return of_plan(c, word.substr(0, dot),
                 [&](const sim::ForcePlan& plan) { return number(plan.task.program.keys(channel).size()); });
}
template <auto... path>
Answer of_program(const QueryContext& c, View word) {
  return of_plan(c, word, [](const sim::ForcePlan& plan) { return value_at(plan.task.program, path...); });
}
template <auto... path>
Answer of_force(const QueryContext& c, View word) {
  return of_plan(c, word, [](const sim::ForcePlan& plan) { return value_at(plan, path...); });
}
Answer force_unmet_at(const QueryContext& c, View word) {
  return of_plan(c, word, [](const sim::ForcePlan& plan) {
    return plan.unmet > 0 ? number(plan.unmet_at) : none("the keys are met");
  });
}
Answer force_stopped(const QueryContext& c, View word) {
  return of_plan(c, word, [](const sim::ForcePlan& plan) {
    return text_or_none(sim::stop_text(plan), "it has its whole length");
  });
}

constexpr ArgumentPart kOfSection = kSection[0],
                       kOfChannel{.usage = "CHANNEL", .words = base::names_of<world::ForceChannel>, .before = '.'};
constexpr ArgumentPart kChannel[]{kOfSection, kOfChannel};
constexpr ArgumentPart kChannelPlace[]{kOfSection, kOfChannel, {.usage = "PLACE", .number = true, .before = '/'}};

constexpr Query kForceRows[]{
    {"force.asked", kChannelPlace, "",
     "The value that a force section requires at a position (m or s from its start), such as @q3.vertical/40: "
     "vertical or lateral g, or roll in degrees per metre or second; of curvature 1/m, or degrees. With the ramp "
     "at its start.",
     force_asked, or_none()},
    {"force.met", kChannelPlace, "",
     "What the riders of the first car feel there, none where the ride does not arrive; of curvature, what the "
     "track "
     "has there.",
     force_met, or_none()},
    {"force.keys", kChannel, "", "Number of keys of a channel.", force_keys, or_none()},
    {"force.over", kSection, "", "Axis of the keys: distance or time.", of_program<&world::ForceProgram::over>,
     or_none(kOneOf<world::ForceDomain>)},
    {"force.of", kSection, "", "Quantity of the keys: forces or curvature.", of_program<&world::ForceProgram::of>,
     or_none(kOneOf<world::ForceQuantity>)},
    {"force.length", kSection, "", "Length of a force section's program, m or s.",
     of_program<&world::ForceProgram::length>, or_none()},
    {"force.tolerance", kSection, "g",
     "Largest allowed difference between what riders feel and the keys; of curvature, at 20 m/s.",
     of_program<&world::ForceProgram::tolerance>, or_none()},
    {"force.speed", kSection, "m/s", "The speed at its start that a force section was planned for.",
     of_program<&world::ForceProgram::speed>, or_none()},
    {"force.error", kSection, "g",
     "Largest difference between what riders feel on its spans and the required value, vertical or lateral; of "
     "curvature, at 20 m/s.",
     of_force<&sim::ForcePlan::fit, &sim::ForceFit::felt_error>, or_none()},
    {"force.shape_error", kSection, "m", "Largest distance of its spans from the path with those forces.",
     of_force<&sim::ForcePlan::fit, &sim::ForceFit::spans, &sim::ElementFit::error>, or_none()},
    {"force.hold", kSection, "", "Whether both ends of a force section stay.", of_program<&world::ForceProgram::hold>,
     or_none(kSwitch)},
    {"force.unmet", kSection, "",
     "Largest difference between what riders feel and the keys, vertical or lateral, because both ends stay: g; of "
     "curvature 1/m.",
     of_force<&sim::ForcePlan::unmet>, or_none()},
    {"force.unmet_at", kSection, "", "Where that is, m or s from its start; none if it is 0.", force_unmet_at,
     or_none()},
    {"force.ramp", kSection, "", "Length of the ramp at its start from the felt values to those of the keys, m or s.",
     of_force<&sim::ForcePlan::path, &sim::ForcePath::ramp>, or_none()},
    {"force.stopped", kSection, "", "Why a force section is shorter than its program; none if it is not.",
     force_stopped, or_none(kText)},
};

}  // namespace

std::span<const Query> section_rows() { return kSectionRows; }
std::span<const Query> element_rows() { return kElementRows; }
std::span<const Query> force_rows() { return kForceRows; }

}  // namespace coaster::query
