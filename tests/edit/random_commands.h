// Random commands of every kind, made from the lists of fields that the codec uses.
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <type_traits>
#include <utility>

#include "edit/commands/command_list.h"
#include "sim/ride/ride.h"
#include "sim/shape/frame_methods.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"

namespace coaster::test {

class RandomCommands {
 public:
  explicit RandomCommands(std::uint32_t seed) : bits_(seed) {}

  std::uint32_t below(std::uint32_t n) { return bits_() % n; }
  double uniform(double low, double high) { return low + (high - low) * (bits_() / 4294967296.0); }

  // Returns a command of the kind at that index of the list, with every field set.
  edit::Command of_kind(std::size_t kind);

 private:
  template <class C>
  edit::Command made() {
    C command;
    C::fields(command, [&](std::string_view, auto& value) { fill(value); });
    return command;
  }
  world::EntityName name() { return {static_cast<world::EntityKind>(below(4)), 1 + below(9)}; }
  double number() { return uniform(-1, 1) * std::exp2(uniform(-20, 12)); }
  void fill(edit::Target& v) { v.name = below(9) ? name() : world::EntityName{}; }
  void fill(edit::HandleTarget& v) {
    v = {{world::EntityKind::knot, 1 + below(9)}, below(2) ? edit::HandleEnd::in : edit::HandleEnd::out};
  }
  void fill(edit::Knots& v) {
    const std::uint32_t which = below(6);
    if (which < 2) v = which == 0 ? edit::Knots::Which::all : edit::Knots::Which::selected;
    else if (which == 2)
      v.which = edit::Knots::Which::range,
      v.names = {{world::EntityKind::knot, 1 + below(9)}, {world::EntityKind::knot, 1 + below(9)}};
    else
      for (std::uint32_t i = below(4); i > 0; --i) v.names.push_back({world::EntityKind::knot, 1 + below(9)});
  }
  void fill(edit::Sections& v) {
    if (below(6) == 0) v.which = edit::Knots::Which::all;
    else
      for (std::uint32_t i = below(4); i > 0; --i) v.names.push_back({world::EntityKind::section, 1 + below(9)});
  }
  void fill(edit::KnotsOrSections& v) { fill(static_cast<edit::Knots&>(v)); }
  void fill(edit::Phrase& v) {
    constexpr std::array<std::string_view, 5> kPhrases{"height", "place", "roll", "exact_length == 80", "a \"b\" c"};
    v.text = kPhrases[below(static_cast<std::uint32_t>(kPhrases.size()))];
  }
  void fill(edit::CameraChange& v) {
    v = {glm::vec3(), 0.0f, 0.0f, 0.0f};
    fill(*v.target), fill(*v.yaw_deg), fill(*v.pitch_deg), fill(*v.distance);
    if (below(2)) v.target.reset();
    if (below(2)) v.yaw_deg.reset();
  }
  void fill(exchange::ImportOptions& v) {
    fill(v.up.emplace()), fill(v.scale.emplace()), fill(v.smooth.emplace()), fill(v.bank.emplace()), fill(v.origin);
    if (below(2)) v.up.reset(), v.bank.reset();
    if (below(2)) v.scale.reset(), v.smooth.reset();
  }
  void fill(glm::vec3& v) { v = {number(), number(), number()}; }
  void fill(glm::vec2& v) { v = {number(), number()}; }
  void fill(edit::WaterLevel& v) { v.level = below(4) == 0 ? world::kNoWater : number(); }
  void fill(float& v) { v = static_cast<float>(number()); }
  void fill(double& v) { v = number(); }
  void fill(int& v) { v = static_cast<int>(below(2000)) - 1000; }
  void fill(std::int64_t& v) { v = static_cast<std::int64_t>(bits_()) * 1000 - 7; }
  void fill(bool& v) { v = below(2) == 1; }
  void fill(world::Colour& v) { v.rgb = below(3) == 0 ? -1 : static_cast<std::int32_t>(below(0x1000000)); }
  void fill(edit::Flag& v) { v.set = below(2) == 1; }
  void fill(std::string& v) {
    constexpr std::string_view kLetters = "ab \"\\#@'\n.";
    for (std::uint32_t i = below(8); i > 0; --i) v += kLetters[below(kLetters.size())];
  }
  template <base::Named E>
  void fill(E& v) {
    v = static_cast<E>(below(base::count_of<E>()));
  }
  void fill(world::Element& v) {
    world::ElementKind kind{};
    fill(kind);
    v = world::usual_element(kind);
    const world::ElementRow& row = base::row_of(v.kind);
    v.right = row.sided && below(2) == 1;
    for (std::size_t i = 0; i < row.parameters.size(); ++i)
      v.values[i] = row.parameters[i].names.empty() ? number()
                                                    : below(static_cast<std::uint32_t>(row.parameters[i].names.size()));
  }

  std::mt19937 bits_;
};

inline edit::Command RandomCommands::of_kind(std::size_t kind) {
  using Maker = edit::Command (RandomCommands::*)();
  static constexpr auto kMakers = edit::Commands::table([]<class C>() -> Maker { return &RandomCommands::made<C>; });
  return (this->*kMakers[kind])();
}

}  // namespace coaster::test
