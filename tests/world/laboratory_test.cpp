#include "world/laboratory.h"
#include "world/layers.h"

#include <set>

#include <gtest/gtest.h>

namespace coaster::world {
namespace laboratory_test {

template <class Rows>
void expect_names(const Rows& rows, std::size_t count) {
  std::set<std::string_view> names;
  for (const auto& row : rows) EXPECT_TRUE(names.insert(row.name).second) << row.name;
  EXPECT_EQ(names.size(), count);
  EXPECT_EQ(names.count(""), 0u);
}

TEST(laboratory, every_layer_colouring_and_page_has_a_row_of_its_own) {
  expect_names(kLayers, static_cast<std::size_t>(Layer::legend) + 1);
  expect_names(kColourings, static_cast<std::size_t>(Colouring::error) + 1);
  expect_names(kLabPages, static_cast<std::size_t>(LabPage::riders) + 1);
  EXPECT_EQ(kLayers[static_cast<std::size_t>(Layer::rounding)].name, "rounding");
  EXPECT_EQ(kColourings[static_cast<std::size_t>(Colouring::lateral)].name, "lateral");
  EXPECT_EQ(kLabPages[static_cast<std::size_t>(LabPage::joints)].name, "joints");
}

TEST(laboratory, a_layer_is_shown_and_hidden_without_the_others) {
  for (std::size_t i = 0; i < std::size(kLayers); ++i)
    for (const bool on : {true, false}) {
      const Layers before;
      Layers after = before;
      after.set(static_cast<Layer>(i), on);
      for (std::size_t k = 0; k < std::size(kLayers); ++k) {
        const auto layer = static_cast<Layer>(k);
        EXPECT_EQ(after.has(layer), k == i ? on : before.has(layer)) << i << " " << k;
      }
    }
}

}  // namespace laboratory_test
}  // namespace coaster::world
