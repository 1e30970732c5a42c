// Tables of names of enumerations.
#include "base/enum_names.h"

#include <gtest/gtest.h>

#include <set>

#include "exchange/challenge_file.h"
#include "sim/ride/ride.h"
#include "sim/shape/frame_methods.h"
#include "world/appearance_settings.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"
#include "world/laboratory.h"
#include "world/layers.h"
#include "world/settings.h"

namespace coaster::base {
namespace enum_names_test {

enum class Colour : std::uint8_t { red, green, blue };
constexpr NameRow kColours[] = {{"red", "Red", "As blood."}, {"green"}, {"blue"}};
constexpr std::span<const NameRow> rows_of(Colour) { return kColours; }

TEST(names, a_value_has_its_row_and_a_name_its_value) {
  EXPECT_EQ(name_of(Colour::green), "green");
  EXPECT_EQ(row_of(Colour::red).help, "As blood.");
  EXPECT_EQ(value_named<Colour>("blue"), Colour::blue);
  EXPECT_EQ(value_named<Colour>("Blue"), std::nullopt);
  EXPECT_EQ(value_named<Colour>(""), std::nullopt);
  static_assert(count_of<Colour>() == 3);
}

TEST(names, the_value_after_the_last_is_the_first) {
  EXPECT_EQ(next_of(Colour::red), Colour::green);
  EXPECT_EQ(next_of(Colour::blue), Colour::red);
}

TEST(names, numbers_from_outside_may_have_no_row) {
  EXPECT_TRUE(has_row(Colour::blue));
  EXPECT_FALSE(has_row(static_cast<Colour>(3)));
  EXPECT_FALSE(has_row(world::IntegratorId{-1}));
  EXPECT_DEATH((void)row_of(static_cast<Colour>(3)), "every value of a named enumeration has its row");
}

TEST(names, alternatives_read_as_a_sentence_does) {
  EXPECT_EQ(alternatives_of<Colour>(), "red, green or blue");
  EXPECT_EQ(alternatives_of<Colour>("\""), "\"red\", \"green\" or \"blue\"");
  EXPECT_EQ(alternatives(std::vector<std::string>{"one"}), "one");
  EXPECT_EQ(alternatives({}), "");
}

template <Named E>
void expect_rows_up_to(E last) {
  EXPECT_EQ(static_cast<std::size_t>(last) + 1, count_of<E>()) << name_of(last);
  std::set<std::string> names;
  for (const std::string& name : names_of<E>()) EXPECT_TRUE(!name.empty() && names.insert(name).second) << name;
}

// The compiler does not count enumerators, so the last one of each enumeration is listed here.
TEST(names, every_enumerator_has_its_row_and_a_name_of_its_own) {
  expect_rows_up_to(world::EntityKind::section);
  expect_rows_up_to(world::JointKind::automatic);
  expect_rows_up_to(world::SpinKind::set);
  expect_rows_up_to(world::SectionKind::force);
  expect_rows_up_to(world::EquipmentKind::block);
  expect_rows_up_to(world::FrameMethod::world_up);
  expect_rows_up_to(world::CameraMode::fly);
  expect_rows_up_to(world::Axis::z);
  expect_rows_up_to(world::SplineSteps::uniform);
  expect_rows_up_to(world::SnapTo::ground);
  expect_rows_up_to(world::Theme::high_contrast);
  expect_rows_up_to(world::Style::blueprint);
  expect_rows_up_to(world::Layer::legend);
  expect_rows_up_to(world::Colouring::error);
  expect_rows_up_to(world::LabPage::riders);
  expect_rows_up_to(world::ElementKind::force_brakes);
  expect_rows_up_to(world::RideState::failed);
  expect_rows_up_to(world::FailureKind::deadlock);
  expect_rows_up_to(exchange::JudgedWhen::build);
  expect_rows_up_to(exchange::RuleList::gold);
}

}  // namespace enum_names_test
}  // namespace coaster::base
