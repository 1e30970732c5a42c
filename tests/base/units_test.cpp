#include "base/units.h"

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace coaster::base {
namespace units_test {

// The size of a unit by the table of typed units, which is written independently: 1 ft = 0.3048 m.
double typed_size(std::string_view unit) {
  for (const Unit& row : units())
    if (row.name == unit) return row.size;
  ADD_FAILURE() << unit << " cannot be typed";
  return 1;
}

TEST(units, factors_agree_with_the_units_that_can_be_typed) {
  for (const char* metric : {"m", "cm", "mm", "m/s", "m/s\u00B2", "\u00B0/m"})
    for (const UnitSystem to : {UnitSystem::m_s, UnitSystem::kmh, UnitSystem::feet}) {
      const ShownUnit shown = shown_in(to, metric);
      EXPECT_NEAR(shown.factor, typed_size(metric) / typed_size(shown.name), 1e-15 * shown.factor) << shown.name;
    }
  EXPECT_DOUBLE_EQ(shown_in(UnitSystem::feet, "1/m").factor * shown_in(UnitSystem::feet, "m").factor, 1);
  EXPECT_DOUBLE_EQ(shown_in(UnitSystem::feet, "m\u00B2").factor, std::pow(shown_in(UnitSystem::feet, "m").factor, 2));
}

TEST(units, the_first_system_and_other_units_stay_as_they_are) {
  for (const char* unit : {"m", "m/s", "mm", "1/m", "g", "s", "kg", "%", ""})
    for (const UnitSystem to : {UnitSystem::m_s, UnitSystem::kmh, UnitSystem::feet}) {
      const bool metric = std::string_view(unit).find('m') != std::string_view::npos;
      if (metric && to != UnitSystem::m_s) continue;
      EXPECT_EQ(shown_in(to, unit).name, unit);
      EXPECT_EQ(shown_in(to, unit).factor, 1);
      EXPECT_EQ(shown_in(to, unit).more_decimals, 0);
    }
}

TEST(units, angles_and_areas_get_their_signs_in_every_system) {
  for (const UnitSystem to : {UnitSystem::m_s, UnitSystem::kmh, UnitSystem::feet}) {
    EXPECT_EQ(shown_in(to, "deg").name, "\u00B0");
    EXPECT_EQ(shown_in(to, "deg/s").name, "\u00B0/s");
    EXPECT_EQ(shown_in(to, "deg/s^2").name, "\u00B0/s\u00B2");
    EXPECT_EQ(shown_in(to, "m^2").name, shown_in(to, "m\u00B2").name);
    EXPECT_EQ(shown_in(to, "deg/m").name, shown_in(to, "\u00B0/m").name);
    EXPECT_EQ(shown_in(to, "deg/m").factor, shown_in(to, "\u00B0/m").factor) << "0.3048 in feet";
  }
}

TEST(units, what_is_typed_comes_back_as_it_is_written_in_metres) {
  const ShownUnit feet = shown_in(UnitSystem::feet, "m"), kmh = shown_in(UnitSystem::kmh, "m/s");
  EXPECT_EQ(metric_value(33, feet), 10.0584);
  EXPECT_EQ(metric_value(*evaluate("10 m", "ft"), feet), 10);
  EXPECT_EQ(metric_value(*evaluate("90", "km/h"), kmh), 25);
  EXPECT_EQ(metric_value(1.0 / 3, shown_in(UnitSystem::m_s, "m")), 1.0 / 3) << "to the last bit";
  std::mt19937 bits(7);
  for (int i = 0; i < 2000; ++i) {
    const double value = (static_cast<double>(bits() % 2000001) - 1000000) / 1000;
    EXPECT_EQ(metric_value(value * feet.factor, feet), value);
  }
}

TEST(units, lengths_and_speeds_of_a_sentence_are_rewritten) {
  const std::pair<const char*, const char*> cases[]{
      {"Rolled back 2 m.", "Rolled back 6.56 ft."},
      {"0 to 20 m/s", "0 to 44.7 mph"},
      {"Position (m)", "Position (ft)"},
      {"Worst error (mm) at steps", "Worst error (in) at steps"},
      {"61.4 m, 4 spans, fit error 9 mm", "201.4 ft, 4 spans, fit error 0.354 in"},
      {"-1.50 m, 3..12 m and 2 g", "-4.92 ft, 9.84..39.4 ft and 2 g"},
      {"0 m", "0 ft"},
      {"k29 m3 2m 5 min 5 metres 4 m/s3", "k29 m3 2m 5 min 5 metres 4 m/s3"},
      {"1.0.2 m", "1.0.2 m"},
      {"Saved \"loop 30 m.json\", 30 m", "Saved \"loop 30 m.json\", 98.4 ft"},
      {"an open \"quote 5 m", "an open \"quote 5 m"},
      {"3 knots and 2 m", "3 knots and 6.56 ft"},
      {"100000 m", "328084 ft"},
      {"", ""}};
  for (const auto& [text, wanted] : cases) {
    EXPECT_EQ(in_units(text, UnitSystem::feet), wanted);
    EXPECT_EQ(in_units(text, UnitSystem::m_s), text);
  }
  EXPECT_EQ(in_units("20 m at 25 m/s, 1.5 m/s\u00B2", UnitSystem::kmh), "20 m at 90 km/h, 1.5 m/s\u00B2");
}

TEST(units, a_rewritten_number_is_within_half_its_last_digit) {
  std::mt19937 bits(11);
  for (int i = 0; i < 5000; ++i) {
    const double metres = static_cast<double>(bits() % 100000) / std::pow(10.0, bits() % 4);
    const std::string text = std::to_string(metres), shown = in_units(text + " m", UnitSystem::feet);
    ASSERT_TRUE(shown.ends_with(" ft")) << shown;
    const double feet = std::stod(shown), wanted = std::stod(text) / 0.3048;
    EXPECT_NEAR(feet, wanted, 0.5e-6 + 1e-12 * wanted) << text;
  }
}

}  // namespace units_test
}  // namespace coaster::base
