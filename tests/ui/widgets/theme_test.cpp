#include "ui/widgets/theme.h"
#include "world/appearance_settings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coaster::ui {
namespace theme_test {

// Contrast by WCAG 2.1, with the curve of sRGB itself: an oracle apart from the program's gamma 2.2.
double luminance(std::uint32_t rgb) {
  const auto linear = [&](int shift) {
    const double c = ((rgb >> shift) & 0xffu) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(16) + 0.7152 * linear(8) + 0.0722 * linear(0);
}
double contrast(std::uint32_t a, std::uint32_t b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

class themes : public testing::TestWithParam<world::Theme> {};

TEST_P(themes, texts_can_be_read_on_every_ground) {
  const ThemeColours& p = palette_of(GetParam());
  const bool high = GetParam() == world::Theme::high_contrast;
  for (const std::uint32_t ground : {p.background, p.raised, p.field, p.plot}) {
    EXPECT_GE(contrast(p.text, ground), high ? 15 : 7) << std::hex << ground;
    EXPECT_GE(contrast(p.dim, ground), high ? 10 : 3.8) << std::hex << ground;
    for (const std::uint32_t tint : {p.warning, p.error, p.good, p.axis[0], p.axis[1], p.axis[2]})
      EXPECT_GE(contrast(tint, ground), high ? 7 : 2.9) << std::hex << tint << " on " << ground;
  }
}

INSTANTIATE_TEST_SUITE_P(all, themes,
                         testing::Values(world::Theme::dark, world::Theme::light, world::Theme::high_contrast),
                         [](const auto& of) { return std::string(base::name_of(of.param)); });

TEST(themes, what_is_disabled_is_about_half_as_strong) {
  ImGuiContext* const context = ImGui::CreateContext();
  for (const world::Theme theme : {world::Theme::dark, world::Theme::light, world::Theme::high_contrast}) {
    apply_theme(palette_of(theme), 1);
    EXPECT_GT(ImGui::GetStyle().DisabledAlpha, 0.35f);
    EXPECT_LT(ImGui::GetStyle().DisabledAlpha, 0.65f);
  }
  ImGui::DestroyContext(context);
}

TEST(ink, colours_of_data_can_be_told_from_the_ground_of_light_plots_and_stay_as_they_are_on_dark_ones) {
  ImGuiContext* const context = ImGui::CreateContext();
  for (const world::Theme theme : {world::Theme::dark, world::Theme::light, world::Theme::high_contrast}) {
    apply_theme(palette_of(theme), 1);
    for (const std::uint32_t rgb : {0xFFFFFFu, 0x4C9AFFu, 0xF2B84Bu, 0x7FD1B9u, 0xE5736Bu, 0xB39DDBu, 0xD8DEE9u,
                                    0x9CCC65u, 0xFF9EC4u, 0x8D9DB6u, 0xD4A373u, 0xFF8A1Fu}) {
      EXPECT_GE(contrast(ink(rgb), palette().plot), 3) << std::hex << rgb;
      EXPECT_TRUE(palette().light || ink(rgb) == rgb);
    }
  }
  ImGui::DestroyContext(context);
}

}  // namespace theme_test
}  // namespace coaster::ui
