// What sentences call a section.
#include "world/sections.h"

#include <gtest/gtest.h>

#include "world/element_rows.h"

namespace coaster::world {
namespace {

TEST(section_words, name_a_section_inside_a_sentence) {
  const auto element = [](ElementKind kind) { return Section{"", SectionKind::element, usual_element(kind)}; };
  EXPECT_EQ(words_of(Section{}), "the hand-shaped section");
  EXPECT_EQ(words_of(Section{"Way out"}), "\"Way out\"");
  EXPECT_EQ(words_of(element(ElementKind::loop)), "the loop");
  EXPECT_EQ(words_of(element(ElementKind::immelmann)), "the Immelmann");
  EXPECT_EQ(words_of(element(ElementKind::s_bend)), "the S-bend");
  EXPECT_EQ(words_of(element(ElementKind::zero_g_roll)), "the zero-g roll");
  EXPECT_EQ(words_of(Section{"", SectionKind::complete}), "the closing section");
  EXPECT_EQ(words_of(Section{"", SectionKind::force}), "the force section");
}

}  // namespace
}  // namespace coaster::world
