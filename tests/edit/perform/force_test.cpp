// Commands of force sections: their keys, and the memory of their steps. No header of its own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "edit/force_fixture.h"

namespace coaster::edit {
namespace force_test {

using test::Forces;
using world::ForceChannel;

// A step's keys are counted: with as much memory as a few steps of 600 keys take, the oldest are dropped.
TEST_F(Forces, keys_count_in_the_memory_of_the_history) {
  drop_and_force();
  constexpr std::size_t kKeys = 150, kBytes = 3 * kKeys * sizeof(world::ForceKey);
  world::ForceProgram many = program();
  many.length = 200;
  for (auto& channel : many.channels)
    for (std::size_t i = 0; i < kKeys; ++i) channel.push_back({1.2 * static_cast<double>(i), 1});
  for (world::ForceKey& key : many.keys(ForceChannel::lateral)) key.value = 0;
  for (world::ForceKey& key : many.keys(ForceChannel::roll)) key.value = 0;
  session.document.entities.get<world::Section>(entity(section.c_str())).force = many;
  const std::size_t before = session.history.bytes;
  key("vertical key 1.01 at 0");
  EXPECT_GE(session.history.bytes - before, kBytes);
  EXPECT_LT(session.history.bytes - before, kBytes + 65'536);
  session.history.limit = session.history.bytes + 3 * kBytes;
  for (const char* const to : {"1.02", "1.03", "1.04", "1.05", "1.06"})
    key(std::string("vertical key ") + to + " at 0");
  EXPECT_GT(session.history.dropped, 0u);
  EXPECT_LE(session.history.bytes, session.history.limit);
}

TEST_F(Forces, bad_values_are_refused_with_a_clear_word) {
  drop_and_force();
  const auto on = [&](const std::string& name, const std::string& rest) { return name + " @" + section + " " + rest; };
  refused(on("force", "vertical key 20 at 10"), "has the value 20 g, expected -10 to 10");
  refused(on("force", "vertical key 2 at 2000"), "expected 0 to 1000");
  SetForceKey nan{Target{*world::parse_name(section)}, false, ForceChannel::lateral, std::nan(""), 10};
  refused(Command{nan}, "has the value nan g");
  std::swap(nan.value, nan.at);
  refused(Command{nan}, "is at nan m");
  key("vertical key 2 at 10");
  refused(on("force", "vertical key 3 at 10.5"), "two keys within 1 m at 10.5 m");
  refused(on("force.move", "vertical at 11 to 12 key 1"), "has no key at 11 m");
  refused(on("force.remove", "lateral at 10"), "has no key at 10 m");
  refused(on("force.length", "to 0"), "the length is 0 m, expected 3 to 1000");
  refused(on("force.length", "to 10000"), "the length is 10000 m");
  refused(on("force.tolerance", "to 0.001"), "the tolerance is 0.001 g");
  refused("force @q1 vertical key 1 at 1", "@q1 is no force section");
  refused("force @q99 vertical key 1 at 1", "there is no section @q99");
  refused("force.add over time length 500", "the length is 500 s");
}

TEST_F(Forces, a_drag_changes_the_keys_that_it_began_with) {
  drop_and_force();
  key("vertical key 2 at 25");
  const world::Document before = session.document;
  good("gesture.begin");
  for (const char* const to : {"26 key 2.2", "28 key 2.6", "30 key 3"})
    good("force.move @" + section + " from_start on vertical at 25 to " + to);
  good("gesture.end");
  EXPECT_EQ(program().keys(ForceChannel::vertical).size(), 1u);
  EXPECT_EQ(program().keys(ForceChannel::vertical)[0].at, 30);
  good("undo");
  EXPECT_TRUE(session.document == before);
}

}  // namespace force_test
}  // namespace coaster::edit
