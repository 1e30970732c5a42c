#include <cctype>
#include <sstream>
#include <tuple>

#include <gtest/gtest.h>

#include "exchange/export/shape_export.h"
#include "exchange/export/shape_readers.h"

namespace coaster::exchange {
namespace svg_print_test {

// The numbers of the attribute or path data that follow `key` behind `from`.
std::vector<double> numbers_after(const std::string& text, const std::string& key, std::size_t from) {
  const std::size_t start = text.find(key, from) + key.size();
  std::string part = text.substr(start, text.find_first_of("\")", start) - start);
  for (char& c : part)
    if (std::isalpha(static_cast<unsigned char>(c)) && c != 'e') c = ' ';
  std::istringstream words(part);
  std::vector<double> out;
  for (double number = 0; words >> number;) out.push_back(number);
  return out;
}

TEST(Svg, draws_the_cubics_themselves_within_the_sheet) {
  const world::Document d = test::closed_document();
  const std::string text = print_svg(d);
  const auto sheet = numbers_after(text, "viewBox=\"", 0);
  ASSERT_EQ(sheet.size(), 4u);
  for (const auto& [id, row, sign] : {std::tuple{"plan", 2, 1.0f}, {"elevation", 1, -1.0f}}) {
    const std::size_t group = text.find(std::string("<g id=\"") + id + "\"");
    ASSERT_NE(group, std::string::npos);
    const auto moved = numbers_after(text, "translate(", group), path = numbers_after(text, "<path d=\"", group);
    ASSERT_EQ(moved.size(), 2u);
    std::vector<glm::vec3> wanted{world::cubic_of(d, d.track.segments[0]).p0};
    for (const world::Entity s : d.track.segments) {
      const curve::Cubic c = world::cubic_of(d, s);
      wanted.insert(wanted.end(), {c.p1, c.p2, c.p3});
    }
    ASSERT_EQ(path.size(), 2 * wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(static_cast<float>(path[2 * i]), wanted[i].x);
      EXPECT_EQ(static_cast<float>(path[2 * i + 1]), sign * wanted[i][row]);
      EXPECT_GT(path[2 * i] + moved[0], 0);
      EXPECT_LT(path[2 * i] + moved[0], sheet[2]);
      EXPECT_GT(path[2 * i + 1] + moved[1], 0);
      EXPECT_LT(path[2 * i + 1] + moved[1], sheet[3]);
    }
    // The bar has the length given in the text next to it: the number after the last blank before " m<".
    const std::size_t bar = text.find(std::string("<path id=\"") + id + "-bar\"");
    const auto numbers = numbers_after(text, " d=\"", bar);
    const std::size_t end = text.find(" m</text>", bar), start = text.rfind('>', end) + 1;
    ASSERT_EQ(numbers.size(), 3u);
    EXPECT_EQ(std::stod(text.substr(start, end - start)), numbers[2]);
    EXPECT_GT(numbers[2], 1);
  }
}

TEST(Svg, names_cannot_break_the_file) {
  world::Document d;
  d.name = "<b>&\n";
  EXPECT_NE(print_svg(d).find("<title>&lt;b&gt;&amp; </title>"), std::string::npos);
}

}  // namespace svg_print_test
}  // namespace coaster::exchange
