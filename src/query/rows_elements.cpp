// Queries of the palette's element at its present position at the track's open end.
#include <array>

#include "base/portable_math.h"
#include "query/rows.h"
#include "sim/study/complete_circuit.h"

namespace coaster::query {
namespace {

const sim::ElementPlan& plan(const Context& c) { return c.find.element(); }

Answer element(const Context& c, View) { return text(base::row_of(c.session.settings.element.kind).name); }
Answer side(const Context& c, View) {
  const world::Element& e = c.session.settings.element;
  return base::row_of(e.kind).sided ? text(e.right ? "right" : "left") : none("the element has no side");
}
Answer value(const Context& c, View argument) { return parameter_of(plan(c).element, argument); }
// Returns a member of the plan; none if it has no spans.
template <auto... path>
Answer of_plan(const Context& c, View) {
  const sim::ElementPlan& found = plan(c);
  return found.spans() > 0 ? value_of(member_at(found, path...)) : none(found.refusal);
}
Answer roll_error(const Context& c, View) {
  const Answer radians = of_plan<&sim::ElementPlan::fit, &sim::ElementFit::roll_error>(c, {});
  return is_none(*radians) ? radians : number(base::degrees(std::get<double>(*radians)));
}
Answer spans(const Context& c, View) { return number(plan(c).spans()); }
Answer missing(const Context& c, View) {
  return plan(c).spans() > 0 ? number(sim::worst(c.find.room())) : none(plan(c).refusal);
}
Answer refusal(const Context& c, View) {
  return plan(c).refusal.empty() ? none("it can be placed") : text(plan(c).refusal);
}

const sim::CircuitProposals& circuit(const Context& c) { return c.find.circuit(); }
Answer proposals(const Context& c, View) { return number(circuit(c).list.size()); }
constexpr ArgumentPart kWay[]{{.usage = "N", .most = sim::kMostProposals}};
// Returns function(index) of the proposal that the argument names, none without it.
template <class Function>
Answer of_proposal(const Context& c, View argument, Function function) {
  const auto i = static_cast<std::size_t>(*base::parse_int(argument)) - 1;
  return i < circuit(c).list.size() ? number(function(i)) : none("there is no such closing section");
}
Answer circuit_length(const Context& c, View argument) {
  return of_proposal(c, argument, [&](std::size_t i) { return circuit(c).list[i].plan.length; });
}
Answer circuit_g(const Context& c, View argument) {
  return of_proposal(c, argument, [&](std::size_t i) { return circuit(c).list[i].felt.most; });
}
Answer circuit_jolt(const Context& c, View argument) {
  return of_proposal(c, argument, [&](std::size_t i) { return c.find.way_jolt(i); });
}
Answer circuit_refusal(const Context& c, View) {
  return circuit(c).refusal.empty() ? none("there is a closing section") : text(circuit(c).refusal);
}

constexpr ArgumentPart kParameter[]{{.words = parameter_names}};
std::vector<std::string> sides() { return {"left", "right"}; }

constexpr std::array kElementRows{
    Query{"element", kNoArgument, "", "The palette's element, such as loop.", element, kOneOf<world::ElementKind>},
    Query{"element.side", kNoArgument, "", "left or right; none for an element without a side.", side,
          or_none({Type::text, sides})},
    Query{"element.value", kParameter, "",
          "A parameter of the palette's element, such as radius, within its limits; none if it has no such parameter.",
          value, or_none({Type::parameter})},
    Query{"element.error", kNoArgument, "m",
          "Largest distance of the palette's element, as Bezier spans, from its ideal curve; none without a plan.",
          of_plan<&sim::ElementPlan::fit, &sim::ElementFit::error>, or_none()},
    Query{"element.roll_error", kNoArgument, "deg", "Largest angle between the spans' frames and the ideal curve's.",
          roll_error, or_none()},
    Query{"element.jump", kNoArgument, "1/m",
          "Largest jump of curvature at the joints of the palette's element, including its first.",
          of_plan<&sim::ElementPlan::fit, &sim::ElementFit::jump>, or_none()},
    Query{"element.spans", kNoArgument, "", "Number of Bezier spans of the palette's element.", spans},
    Query{"element.length", kNoArgument, "m", "Length of the palette's element with its lead-in.",
          of_plan<&sim::ElementPlan::length>, or_none()},
    Query{"element.lead", kNoArgument, "m",
          "Length of its lead-in, which eases the curvature of the open end and levels it.",
          of_plan<&sim::ElementPlan::lead>, or_none()},
    Query{"element.lowest", kNoArgument, "m", "Lowest height of its rails above the ground.",
          of_plan<&sim::ElementPlan::lowest>, or_none()},
    Query{"element.missing", kNoArgument, "m", "Clearance missing between it and other track; 0 if there is enough.",
          missing, or_none()},
    Query{"element.refusal", kNoArgument, "", "Why it cannot be placed; none if it can.", refusal, or_none(kText)},
    Query{"complete.proposals", kNoArgument, "", "Number of closing sections that are proposed: 0 to 3.", proposals},
    Query{"complete.length", kWay, "m", "Length of a closing section; none without it.", circuit_length, or_none()},
    Query{"complete.worst_g", kWay, "g",
          "Largest vertical felt g on a closing section, not low-passed; none without it.", circuit_g, or_none()},
    Query{"complete.jolt", kWay, "g",
          "Largest jolt at the joints of a closing section on a whole ride; none without it.", circuit_jolt, or_none()},
    Query{"complete.refusal", kNoArgument, "", "Why there is no closing section; none if there is one.",
          circuit_refusal, or_none(kText)},
};

}  // namespace

std::span<const Query> element_rows() { return kElementRows; }

}  // namespace coaster::query
