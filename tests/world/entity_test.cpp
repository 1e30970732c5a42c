#include "world/entity.h"

#include <gtest/gtest.h>

namespace coaster::world {

TEST(entity, names_print_and_parse_back) {
  for (const EntityKind kind : {EntityKind::knot, EntityKind::segment, EntityKind::cart, EntityKind::section})
    for (const std::uint32_t number : {1u, 7u, 10u, 4294967295u})
      EXPECT_EQ(parse_name(to_text(EntityName{kind, number})), (EntityName{kind, number}));
  EXPECT_EQ(to_text(EntityName{EntityKind::cart, 12}), "c12");
  EXPECT_EQ(to_text(EntityName{EntityKind::section, 3}), "q3");
}

TEST(entity, other_texts_are_no_names) {
  for (const char* text :
       {"", "k", "3", "k0", "k03", "K3", "x3", "k-1", "k+1", "k3 ", " k3", "k3.in", "k4294967296", "k1e3", "@k3"})
    EXPECT_FALSE(parse_name(text)) << text;
}

}  // namespace coaster::world
