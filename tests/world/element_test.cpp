#include "world/element.h"

#include <set>

#include <gtest/gtest.h>

#include "world/element_rows.h"

namespace coaster::world {
namespace element_test {

TEST(element, rows_stand_in_the_order_of_their_kinds_and_usual_values_are_within_limits) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < elements().size(); ++i) {
    const auto kind = static_cast<ElementKind>(i);
    const ElementRow& row = base::row_of(kind);
    EXPECT_EQ(&row, &elements()[i]);
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    ASSERT_LE(row.parameters.size(), kMaxElementParameters);
    const Element usual = usual_element(kind);
    EXPECT_EQ(usual.kind, kind);
    EXPECT_FALSE(usual.right);
    std::set<std::string_view> parameters;
    for (std::size_t k = 0; k < kMaxElementParameters; ++k) {
      if (k >= row.parameters.size()) {
        EXPECT_EQ(usual.values[k], 0) << row.name;
        continue;
      }
      const ElementParameter& parameter = row.parameters[k];
      EXPECT_TRUE(parameters.insert(parameter.name).second) << row.name << " " << parameter.name;
      EXPECT_LT(parameter.low, parameter.high);
      EXPECT_GE(usual.values[k], parameter.low);
      EXPECT_LE(usual.values[k], parameter.high);
      EXPECT_EQ(value_of(usual, parameter.name), parameter.usual) << row.name << " " << parameter.name;
    }
  }
  EXPECT_EQ(base::row_of(ElementKind::corkscrew).name, "corkscrew");
  EXPECT_EQ(base::row_of(ElementKind::brake_run).name, "brake_run");
}

TEST(element, a_value_is_the_one_of_its_name) {
  Element e = usual_element(ElementKind::helix);
  for (std::size_t i = 0; i < kMaxElementParameters; ++i) e.values[i] = 100.5 + static_cast<double>(i);
  const auto parameters = base::row_of(e.kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    EXPECT_EQ(value_of(e, parameters[i].name), 100.5 + static_cast<double>(i));
}

TEST(element, values_of_the_equipment_count_where_there_is_some) {
  Element climb = usual_element(ElementKind::climb);
  const auto parameters = base::row_of(climb.kind).parameters;
  for (const ElementParameter& p : parameters) EXPECT_EQ(counts(climb, p), p.name != "speed") << p.name;
  climb.values[3] = 2;  // a lift
  for (const ElementParameter& p : parameters) EXPECT_TRUE(counts(climb, p)) << p.name;
  const Element curve = usual_element(ElementKind::curve);  // has a speed and no equipment
  for (const ElementParameter& p : base::row_of(curve.kind).parameters) EXPECT_TRUE(counts(curve, p)) << p.name;
}

}  // namespace element_test
}  // namespace coaster::world
