// Queries of force sections: the required values, and what the first train's riders feel in its ride over the present
// track.
#include <array>
#include <cmath>

#include "base/portable_math.h"
#include "query/rows.h"
#include "sim/plan/force_quantity.h"
#include "world/sections.h"

namespace coaster::query {
namespace {

// Returns the value of `function` for the plan of the force section that the argument names; "none" for others.
template <class Function>
Answer of_plan(const Context& c, View argument, Function function) {
  const auto section = entity_of(c, argument, world::Kind::section);
  if (!section) return section.status();
  const sim::ForcePlan* const plan = c.find.force(*section);
  return plan != nullptr ? function(*plan) : Answer(none("it is not a force section"));
}

// A position of a channel: "@q3.vertical/40".
struct ForcePlace {
  View section;
  world::ForceChannel channel{};
  double at = 0;
};
ForcePlace force_place(View word) {
  const std::size_t dot = word.find('.'), slash = word.find('/', dot);
  return {word.substr(0, dot), *base::value_named<world::ForceChannel>(word.substr(dot + 1, slash - dot - 1)),
          *base::parse_double(word.substr(slash + 1))};
}

// Returns a value of the plan's points at a position, linear between them.
double asked_at(const sim::ForcePlan& plan, const ForcePlace& spot) {
  const auto value = [&](std::size_t i) { return plan.path.points[i].asked(spot.channel); };
  return sim::between_points(plan, spot.at, value);
}

// Returns nothing where the ride does not arrive.
std::optional<double> met_at(const Context& c, const sim::ForcePlan& plan, const ForcePlace& spot, std::size_t first) {
  const double start = c.session.derived.starts[first];
  const sim::Ghost* const ride = c.find.ride();
  const sim::RailTables& tables = c.find.tables();
  const auto length = [&](std::size_t i) { return plan.path.curve.points[i].s; };
  const double place = start + sim::between_points(plan, spot.at, length);
  if (plan.task.program.of == world::ForceOf::curvature)
    return sim::curvature_at(c.session.derived, first, place)[static_cast<std::size_t>(spot.channel)];
  const auto passing = ride != nullptr ? sim::passing(*ride, place) : std::nullopt;
  if (!passing) return std::nullopt;
  std::size_t index = 0;
  const double s = tables.locate(place, index), g = world::kGravity;
  if (spot.channel == world::ForceChannel::roll) {
    const double spin = base::degrees(c.session.derived.shape_at(index).roll.spin(s));
    return plan.task.program.over == world::ForceOver::distance ? spin : spin * passing->speed;
  }
  const glm::vec3 felt = sim::felt_at(tables.segment(index), s, static_cast<float>(passing->along / g),
                                      static_cast<float>(passing->speed * passing->speed / g));
  return double{spot.channel == world::ForceChannel::vertical ? felt.z : felt.y};
}

Answer force_asked(const Context& c, View word) {
  const ForcePlace spot = force_place(word);
  return of_plan(c, spot.section, [&](const sim::ForcePlan& plan) { return number(asked_at(plan, spot)); });
}
Answer force_met(const Context& c, View word) {
  const ForcePlace spot = force_place(word);
  return of_plan(c, spot.section, [&](const sim::ForcePlan& plan) {
    const auto section = entity_of(c, spot.section, world::Kind::section);
    const world::SectionRun run = world::run_of(c.session.document, *section);
    return value_of(met_at(c, plan, spot, run.first));
  });
}
Answer force_keys(const Context& c, View word) {
  const std::size_t dot = word.find('.');
  const auto channel = *base::value_named<world::ForceChannel>(word.substr(dot + 1));
  return of_plan(c, word.substr(0, dot),
                 [&](const sim::ForcePlan& plan) { return number(plan.task.program.keys(channel).size()); });
}
template <auto... path>
Answer of_program(const Context& c, View word) {
  return of_plan(c, word, [](const sim::ForcePlan& plan) { return value_of(member_at(plan.task.program, path...)); });
}
template <auto... path>
Answer of_force(const Context& c, View word) {
  return of_plan(c, word, [](const sim::ForcePlan& plan) { return value_of(member_at(plan, path...)); });
}
Answer force_unmet_at(const Context& c, View word) {
  return of_plan(c, word, [](const sim::ForcePlan& plan) {
    return plan.unmet > 0 ? number(plan.unmet_at) : none("the keys are met");
  });
}
Answer force_stopped(const Context& c, View word) {
  return of_plan(c, word, [](const sim::ForcePlan& plan) {
    const std::string stopped = sim::stop_text(plan);
    return stopped.empty() ? none("it has its whole length") : text(stopped);
  });
}

constexpr ArgumentPart kOfSection = kSection[0],
                       kOfChannel{.usage = "CHANNEL", .words = base::names_of<world::ForceChannel>, .before = '.'};
constexpr ArgumentPart kChannel[]{kOfSection, kOfChannel};
constexpr ArgumentPart kChannelPlace[]{kOfSection, kOfChannel, {.usage = "PLACE", .number = true, .before = '/'}};

constexpr std::array kForceRows{
    Query{"force.asked", kChannelPlace, "",
          "The value that a force section requires at a position (m or s from its start), such as @q3.vertical/40: "
          "vertical or lateral g, or roll in degrees per metre or second; of curvature 1/m, or degrees. With the ramp "
          "at its start.",
          force_asked, or_none()},
    Query{"force.met", kChannelPlace, "",
          "What the riders of the first car feel there, none where the ride does not arrive; of curvature, what the "
          "track "
          "has there.",
          force_met, or_none()},
    Query{"force.keys", kChannel, "", "Number of keys of a channel.", force_keys, or_none()},
    Query{"force.over", kSection, "", "Axis of the keys: distance or time.", of_program<&world::ForceProgram::over>,
          or_none(kOneOf<world::ForceOver>)},
    Query{"force.of", kSection, "", "Quantity of the keys: forces or curvature.", of_program<&world::ForceProgram::of>,
          or_none(kOneOf<world::ForceOf>)},
    Query{"force.length", kSection, "", "Length of a force section's program, m or s.",
          of_program<&world::ForceProgram::length>, or_none()},
    Query{"force.tolerance", kSection, "g",
          "Largest allowed difference between what riders feel and the keys; of curvature, at 20 m/s.",
          of_program<&world::ForceProgram::tolerance>, or_none()},
    Query{"force.speed", kSection, "m/s", "The speed at its start that a force section was planned for.",
          of_program<&world::ForceProgram::speed>, or_none()},
    Query{"force.error", kSection, "g",
          "Largest difference between what riders feel on its spans and the required value, vertical or lateral; of "
          "curvature, at 20 m/s.",
          of_force<&sim::ForcePlan::fit, &sim::ForceFit::felt_error>, or_none()},
    Query{"force.shape_error", kSection, "m", "Largest distance of its spans from the path with those forces.",
          of_force<&sim::ForcePlan::fit, &sim::ForceFit::spans, &sim::ElementFit::error>, or_none()},
    Query{"force.hold", kSection, "", "Whether both ends of a force section stay.",
          of_program<&world::ForceProgram::hold>, or_none(kSwitch)},
    Query{
        "force.unmet", kSection, "",
        "Largest difference between what riders feel and the keys, vertical or lateral, because both ends stay: g; of "
        "curvature 1/m.",
        of_force<&sim::ForcePlan::unmet>, or_none()},
    Query{"force.unmet_at", kSection, "", "Where that is, m or s from its start; none if it is 0.", force_unmet_at,
          or_none()},
    Query{"force.ramp", kSection, "",
          "Length of the ramp at its start from the felt values to those of the keys, m or s.",
          of_force<&sim::ForcePlan::path, &sim::ForcePath::ramp>, or_none()},
    Query{"force.stopped", kSection, "", "Why a force section is shorter than its program; none if it is not.",
          force_stopped, or_none(kText)},
};

}  // namespace

std::span<const Query> force_rows() { return kForceRows; }

}  // namespace coaster::query
