// Random commands of every kind, through the same lists of fields that the codec uses.
#pragma once

#include <cmath>
#include <random>
#include <type_traits>
#include <utility>

#include "edit/commands/commands.h"
#include "sim/ride/ride.h"

namespace coaster::test {

class RandomCommands {
 public:
  explicit RandomCommands(std::uint32_t seed) : bits_(seed) {}

  std::uint32_t below(std::uint32_t n) { return bits_() % n; }
  double uniform(double low, double high) { return low + (high - low) * (bits_() / 4294967296.0); }

  // A command of the kind at that place of the list, with every field set.
  edit::Command of_kind(std::size_t kind);

 private:
  template <class C>
  edit::Command made() {
    C command;
    C::fields(command, [&](std::string_view, auto& value) { fill(value); });
    return command;
  }
  world::Name name() { return {static_cast<world::Kind>(below(3)), 1 + below(9)}; }
  double number() { return uniform(-1, 1) * std::exp2(uniform(-20, 12)); }
  void fill(edit::Target& v) { v.name = below(9) ? name() : world::Name{}; }
  void fill(edit::HandleTarget& v) {
    v = {{world::Kind::knot, 1 + below(9)}, below(2) ? edit::HandleEnd::in : edit::HandleEnd::out};
  }
  void fill(edit::Knots& v) {
    const std::uint32_t which = below(6);
    if (which < 2) v = which == 0 ? edit::Knots::Which::all : edit::Knots::Which::selected;
    else
      for (std::uint32_t i = below(4); i > 0; --i) v.names.push_back({world::Kind::knot, 1 + below(9)});
  }
  void fill(world::Axis& v) { v = static_cast<world::Axis>(below(3)); }
  void fill(world::SplineSteps& v) { v = static_cast<world::SplineSteps>(below(2)); }
  void fill(world::SnapTo& v) { v = static_cast<world::SnapTo>(below(4)); }
  void fill(glm::vec3& v) { v = {number(), number(), number()}; }
  void fill(float& v) { v = static_cast<float>(number()); }
  void fill(double& v) { v = number(); }
  void fill(int& v) { v = static_cast<int>(below(2000)) - 1000; }
  void fill(std::int64_t& v) { v = static_cast<std::int64_t>(bits_()) * 1000 - 7; }
  void fill(bool& v) { v = below(2) == 1; }
  void fill(std::string& v) {
    constexpr std::string_view kLetters = "ab \"\\#@'\n.";
    for (std::uint32_t i = below(8); i > 0; --i) v += kLetters[below(kLetters.size())];
  }
  void fill(world::EquipmentKind& v) { v = static_cast<world::EquipmentKind>(below(5)); }
  void fill(world::Element& v) {
    v = world::usual_element(static_cast<world::ElementKind>(below(world::elements().size())));
    const world::ElementRow& row = world::element_row(v.kind);
    v.right = row.sided && below(2) == 1;
    for (std::size_t i = 0; i < row.parameters.size(); ++i) v.values[i] = number();
  }
  void fill(world::JointKind& v) { v = static_cast<world::JointKind>(below(3)); }
  void fill(world::FrameMethod& v) { v = static_cast<world::FrameMethod>(below(4)); }
  void fill(world::Colouring& v) { v = static_cast<world::Colouring>(below(world::colourings().size())); }
  void fill(world::CameraMode& v) { v = static_cast<world::CameraMode>(below(4)); }
  void fill(world::Layer& v) { v = static_cast<world::Layer>(below(world::layers().size())); }
  void fill(world::LabPage& v) { v = static_cast<world::LabPage>(below(world::lab_pages().size())); }
  void fill(world::Theme& v) { v = static_cast<world::Theme>(below(world::kThemeNames.size())); }
  void fill(world::Style& v) { v = static_cast<world::Style>(below(world::kStyleNames.size())); }
  void fill(curve::EvaluatorId& v) { v = static_cast<curve::EvaluatorId>(below(curve::evaluators().size())); }
  void fill(curve::ArcLengthId& v) { v = static_cast<curve::ArcLengthId>(below(curve::arc_length_methods().size())); }
  void fill(edit::IntegratorId& v) { v.row = static_cast<int>(below(sim::integrators().size())); }

  std::mt19937 bits_;
};

inline edit::Command RandomCommands::of_kind(std::size_t kind) {
  using Maker = edit::Command (RandomCommands::*)();
  static constexpr auto kMakers = edit::Commands::table([]<class C>() -> Maker { return &RandomCommands::made<C>; });
  return (this->*kMakers[kind])();
}

}  // namespace coaster::test
