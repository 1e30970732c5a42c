#include "world/loss_presets.h"

#include <gtest/gtest.h>

namespace coaster::world {
namespace loss_presets_test {

TEST(losses, sets_are_the_numbers_of_the_programs_they_are_named_after) {
  ASSERT_EQ(base::names_of<LossSet>(), (std::vector<std::string>{"frictionless", "openfvd", "kexedit"}));
  EXPECT_EQ(base::row_of(LossSet::frictionless).losses, (Losses{}));
  EXPECT_EQ(base::row_of(LossSet::openfvd).losses, (Losses{0.03f, 0.00002f}));
  EXPECT_EQ(base::row_of(LossSet::kexedit).losses, (Losses{0.021f, 0.00002f}));
}

TEST(losses, a_set_is_known_by_both_its_numbers) {
  for (const LossRow& row : kLossSets) EXPECT_EQ(base::name_of(loss_set_of(row.losses).value()), row.name);
  for (const Losses own : {Losses{0.03f, 0}, {0, 2e-5f}, {0.021f, 3e-5f}, {0.02f, 2e-5f}})
    EXPECT_EQ(loss_set_of(own), std::nullopt);
}

}  // namespace loss_presets_test
}  // namespace coaster::world
