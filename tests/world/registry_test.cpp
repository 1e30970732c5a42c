#include "world/registry.h"

#include <gtest/gtest.h>

#include <string>

namespace coaster::world {
namespace registry_test {

using Sample = Registry<int, std::string>;

TEST(registry, a_destroyed_entity_stays_dead_when_its_slot_is_used_again) {
  Sample r;
  const Entity first = r.create();
  r.put(first, 7);
  r.destroy(first);
  const Entity second = r.create();
  EXPECT_EQ(second.index, first.index);
  EXPECT_FALSE(r.alive(first));
  EXPECT_TRUE(r.alive(second));
  EXPECT_EQ(r.find<int>(first), nullptr);
  EXPECT_EQ(r.find<int>(second), nullptr);
}

TEST(registry, erasing_keeps_all_other_components) {
  Sample r;
  std::vector<Entity> entities;
  for (int i = 0; i < 9; ++i) entities.push_back(r.create()), r.put(entities.back(), i * 3);
  r.destroy(entities[4]);
  r.destroy(entities[8]);
  for (int i = 0; i < 9; ++i) {
    if (i == 4 || i == 8) continue;
    EXPECT_EQ(r.get<int>(entities[static_cast<std::size_t>(i)]), i * 3);
  }
  EXPECT_EQ(r.size(), 7u);
}

TEST(registry, a_pool_can_be_cut_down_to_another_ones_entities) {
  Pool<int> numbers;
  Pool<char> letters;
  for (std::uint32_t i = 0; i < 7; ++i) {
    numbers.put({i, 0}, static_cast<int>(i));
    if (i % 3 != 0) letters.put({i, i == 4 ? 1u : 0u}, 'a');  // of a later entity in the same slot
  }
  numbers.keep_those_of(letters);
  EXPECT_EQ(numbers.size(), 3u);
  for (const std::uint32_t i : {1u, 2u, 5u}) EXPECT_EQ(numbers.get({i, 0}), static_cast<int>(i));
}

TEST(registry, a_copy_is_a_snapshot) {
  Sample r;
  const Entity e = r.create();
  r.put(e, std::string("before"));
  const Sample snapshot = r;
  EXPECT_TRUE(r == snapshot);
  r.get<std::string>(e) = "after";
  EXPECT_FALSE(r == snapshot);
  EXPECT_EQ(snapshot.get<std::string>(e), "before");
}

TEST(registry, dense_order_does_not_count_for_equality) {
  Sample a, b;
  const Entity a0 = a.create(), a1 = a.create(), b0 = b.create(), b1 = b.create();
  a.put(a0, 1), a.put(a1, 2);
  b.put(b1, 2), b.put(b0, 1);
  EXPECT_TRUE(a == b);
}

}  // namespace registry_test
}  // namespace coaster::world
