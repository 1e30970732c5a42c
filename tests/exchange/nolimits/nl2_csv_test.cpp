#include "exchange/nolimits/nl2_csv.h"

#include <gtest/gtest.h>

#include <random>

#include <fmt/format.h>

#include "base/as_job.h"
#include "base/text.h"
#include "curve/frames.h"
#include "exchange/nolimits/nl2_header.h"

namespace coaster::exchange {
namespace nl2_csv_test {

using test::kNl2Header;

// Straight along X: Left is Up x Front.
std::string row(int number, double x,
                const std::string& rest =
                    "1.000000\t-0.000000\t0.000000\t0.000000\t0.000000\t-1.000000\t0.000000\t1.000000\t0.000000") {
  return std::to_string(number) + "\t" + std::to_string(x) + "\t12.345678\t-9.876543\t" + rest + "\n";
}
std::string rows(int count) {
  std::string text(kNl2Header);
  for (int i = 0; i < count; ++i) text += row(i + 1, 3.25 + 0.5 * i);
  return text;
}
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}
void expect_error(const std::string& text, const std::string& expected) {
  const auto loaded = parse_nl2_csv(text, "t.csv");
  ASSERT_FALSE(loaded.ok()) << expected;
  EXPECT_EQ(loaded.status().code, base::Code::bad_file);
  EXPECT_EQ(loaded.status().message, expected);
}

TEST(nl2_csv, two_rows_are_a_straight_with_a_cart_on_it) {
  const auto loaded = parse_nl2_csv(rows(2), "dir/t.csv");
  ASSERT_TRUE(loaded.ok()) << loaded.status().message;
  const world::Document& d = loaded->document;
  EXPECT_EQ(d.name, "t");
  ASSERT_EQ(d.track.knots.size(), 2u);
  EXPECT_EQ(world::knot(d, d.track.knots[1]).position, glm::vec3(3.75f, 12.345678f, -9.876543f));
  EXPECT_EQ(world::knot(d, d.track.knots[0]).up, glm::vec3(0, 1, 0));
  EXPECT_TRUE(world::first_cart(d).valid());
  EXPECT_EQ(world::broken_invariant(d), std::nullopt);
  ASSERT_TRUE(loaded->import.has_value());
  EXPECT_EQ(loaded->import->knots, 2);
}

TEST(nl2_csv, line_ends_marks_blank_lines_comments_headers_and_quotes_make_no_difference) {
  const std::string text = rows(5);
  const std::uint64_t expected = world::hash(parse_nl2_csv(text, "t.csv")->document);
  std::string bare = text.substr(0, text.size() - 1), crlf = replaced(text, "\n", "\r\n");
  for (const std::string& same :
       {bare, crlf, crlf.substr(0, crlf.size() - 2), crlf.substr(0, crlf.size() - 1), "\xef\xbb\xbf" + text,
        text + "\n \r\n\n", "\n \n" + text, replaced(text, "\n", "\r"), replaced(text, "\n", "\t\n"),
        replaced(text, "\"", ""), replaced(text, "\"PosX\"", " \"posx\" "), replaced(text, "\"No.\"", "no"),
        replaced(text, "\t12", "\t 12"), replaced(text, "\t12", "\t+12"),
        "# by hand\n" + replaced(text, "\n", "\n// mark\n\n"), text.substr(text.find('\n') + 1),
        "\xef\xbb\xbf# no header\n" + text.substr(text.find('\n') + 1)}) {
    const auto loaded = parse_nl2_csv(same, "t.csv");
    ASSERT_TRUE(loaded.ok()) << loaded.status().message;
    EXPECT_EQ(world::hash(loaded->document), expected);
  }
}

TEST(nl2_csv, rows_may_count_from_zero) {
  std::string text(kNl2Header);
  for (int i = 0; i < 5; ++i) text += row(i, 3.25 + 0.5 * i);
  const auto loaded = parse_nl2_csv(text, "t.csv");
  ASSERT_TRUE(loaded.ok()) << loaded.status().message;
  EXPECT_TRUE(loaded->document == parse_nl2_csv(rows(5), "t.csv")->document);
}

// Up = Front x Left holds for Left, Up and Front in their places, too.
TEST(nl2_csv, rows_without_a_header_that_have_other_columns_are_refused) {
  const std::string others[] = {"0\t0\t-1\t0\t1\t0\t1\t0\t0", "0\t1\t0\t1\t0\t0\t0\t0\t-1",
                                "0\t0\t-1\t1\t0\t0\t0\t1\t0"};
  for (const std::string& other : others)
    EXPECT_FALSE(parse_nl2_csv(row(1, 0, other) + row(2, 1, other) + row(3, 2, other), "t.csv").ok()) << other;
}

TEST(nl2_csv, errors_name_the_line_what_was_expected_and_what_was_found) {
  const std::string head(kNl2Header), two = rows(2);
  expect_error("", "t.csv:1: error: expected the header \"No.\" \"PosX\" ..., found an empty file");
  expect_error(head, "t.csv:1: error: expected at least 2 rows at different positions, found 0");
  expect_error(rows(1), "t.csv:2: error: expected at least 2 rows at different positions, found 1");
  expect_error(
      replaced(two, "PosY", "PosW"),
      "t.csv:1: error: expected column 3 of the header to be \"PosY\", found \"PosW\": name and order the columns as "
      "NoLimits 2 does");
  expect_error(replaced(two, "\t\"UpZ\"", ""),
               "t.csv:1: error: expected a header of 13 columns, separated by tabs, found 12");
  expect_error(replaced(two, "\"UpZ\"", "\"UpZ\"\t\"Speed\""),
               "t.csv:1: error: expected a header of 13 columns, separated by tabs, found more");
  expect_error(two + "3\t1\t2\n", "t.csv:4: error: expected 13 columns, separated by tabs, found 3");
  expect_error("# by hand\n" + two + "\n// more\n3\t1\n",
               "t.csv:7: error: expected 13 columns, separated by tabs, found 2");
  expect_error(
      "by hand\n" + two,
      "t.csv:1: error: expected column 1 of the header to be \"No.\", found \"by\": name and order the columns "
      "as NoLimits 2 does");
  expect_error("rows\n" + two, "t.csv:1: error: expected a header of 13 columns, separated by tabs, found \"rows\"");
  expect_error(head + row(2, 1), "t.csv:2: error: expected the row's number 1, found \"2\"");
  expect_error(head + row(0, 1) + row(2, 2), "t.csv:3: error: expected the row's number 1, found \"2\"");
  expect_error("1\t2\t3\n" + two,
               "t.csv:1: error: expected column 1 of the header to be \"No.\", found \"1\": name and order the columns "
               "as NoLimits 2 does");
  expect_error(two + row(4, 9), "t.csv:4: error: expected the row's number 3, found \"4\"");
  expect_error(replaced(two, "12.345678", "twelve"),
               "t.csv:2: error: expected a finite number in column PosY, found \"twelve\"");
  for (const std::string bad : {"nan", "inf", "-inf", "1e999", "", "0x10", "1.0.0", "+-1", "++1", "+"})
    expect_error(replaced(two, "12.345678", bad),
                 "t.csv:2: error: expected a finite number in column PosY, found " + base::quoted(bad));
  expect_error(replaced(two, "12.345678", "100000.1"),
               "t.csv:2: error: expected a position within 100000 m in column PosY, found \"100000.1\": load it with "
               "the word origin to move it there");
  const std::string turn = "1\t0\t0\t0\t0\t-1\t";
  expect_error(head + row(1, 1, "1.1\t0\t0\t0\t0\t-1\t0\t1\t0"),
               "t.csv:2: error: expected Front to be a unit vector, found one of length 1.1");
  expect_error(head + row(1, 1, "0\t0\t0\t0\t0\t-1\t0\t1\t0"),
               "t.csv:2: error: expected Front to be a unit vector, found one of length 0");
  expect_error(head + row(1, 1, turn + "0.6\t0.8\t0"),
               "t.csv:2: error: expected Up perpendicular to Front, found a cosine of 0.6 between them");
  expect_error(head + row(1, 1, turn + "0\t-1\t0"),
               "t.csv:2: error: expected Up = Front x Left, found a vector that is 2 off");
  std::string binary(300, '\0');
  EXPECT_FALSE(parse_nl2_csv(binary, "t.csv").ok());
  EXPECT_FALSE(parse_nl2_csv(std::string(100'000, '\t'), "t.csv").ok());
}

TEST(nl2_csv, frames_that_are_a_little_off_are_made_exact) {
  const auto loaded = parse_nl2_csv(std::string(kNl2Header) + row(1, 1, "1.004\t0\t0\t0\t0\t-1\t0.006\t0.996\t0") +
                                        row(2, 1.5, "1\t0\t0\t0\t0\t-1\t0\t1\t0"),
                                    "t.csv");
  ASSERT_TRUE(loaded.ok()) << loaded.status().message;
  EXPECT_EQ(world::broken_invariant(loaded->document), std::nullopt);
  EXPECT_EQ(world::knot(loaded->document, loaded->document.track.knots[0]).up, glm::vec3(0, 1, 0));
}

TEST(nl2_csv, rows_at_the_place_of_the_one_before_are_left_out_with_a_warning) {
  const std::string text = std::string(kNl2Header) + row(1, 1) + row(2, 1) + row(3, 2) + row(4, 3);
  const auto loaded = parse_nl2_csv(text, "t.csv");
  ASSERT_TRUE(loaded.ok()) << loaded.status().message;
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_EQ(loaded->warnings[0], "t.csv:3: warning: the row repeats the previous position; left out");
  expect_error(std::string(kNl2Header) + row(1, 1) + row(2, 1),
               "t.csv:3: error: expected at least 2 rows at different positions, found 1");
}

TEST(nl2_csv, commas_and_semicolons_separate_as_tabs_do) {
  const std::string text = rows(5);
  const std::uint64_t expected = world::hash(parse_nl2_csv(text, "t.csv")->document);
  for (const std::string mark : {",", ";", " , ", "; ", " ", "   "}) {
    const auto loaded = parse_nl2_csv(replaced(text, "\t", mark), "t.csv");
    ASSERT_TRUE(loaded.ok()) << loaded.status().message;
    EXPECT_EQ(world::hash(loaded->document), expected) << mark;
  }
  expect_error(replaced(rows(2), "\t\"PosY\"", ",\"PosY\""),
               "t.csv:1: error: expected a header of 13 columns, separated by tabs, found several separators");
  expect_error(replaced(rows(2), "\t", ";") + "3\t1\t2\n",
               "t.csv:4: error: expected 13 columns, separated by semicolons, found 1");
}

TEST(nl2_csv, decimal_commas_are_read_where_tabs_or_semicolons_separate) {
  const std::string text = rows(5);
  const std::uint64_t expected = world::hash(parse_nl2_csv(text, "t.csv")->document);
  const std::string head(kNl2Header), body = replaced(text.substr(head.size()), ".", ",");
  for (const std::string& file : {head + body, body, replaced(head + body, "\t", ";"), replaced(body, "\t", ";"),
                                  replaced(head + body, "\t", "; ")}) {
    const auto loaded = parse_nl2_csv(file, "t.csv");
    ASSERT_TRUE(loaded.ok()) << loaded.status().message;
    EXPECT_EQ(world::hash(loaded->document), expected);
  }
  const auto message = [](const std::string& file) { return parse_nl2_csv(file, "t.csv").status().message; };
  // Commas as separators, and blanks: a comma may be either there. Both marks in a file: one may group thousands.
  EXPECT_NE(message(replaced(head + body, "\t", ",")).find("expected 13 columns, separated by commas, found more"),
            std::string::npos);
  EXPECT_NE(message(replaced(replaced(head + body, "\t", " "), "\"", "")).find("decimals follow a point, not a comma"),
            std::string::npos);
  EXPECT_NE(message(replaced(head + body, "5,250000", "5.250000")).find("found \"5.250000\": decimals follow a comma"),
            std::string::npos)
      << message(replaced(head + body, "5,250000", "5.250000"));
  EXPECT_FALSE(parse_nl2_csv(replaced(head + body, "12,345678", "1.012,345678"), "t.csv").ok());
  EXPECT_EQ(message(head + body.substr(0, body.size() - 3)),
            "t.csv:6: error: expected a last number with 6 decimals, found \"0,0000\": the file is truncated");
}

std::string rows_at(const std::vector<double>& places, const std::string& rest) {
  std::string text(kNl2Header);
  for (std::size_t i = 0; i < places.size(); ++i) text += row(static_cast<int>(i) + 1, places[i], rest);
  return text;
}
const std::string kAhead = "1\t0\t0\t0\t0\t-1\t0\t1\t0", kBack = "-1\t0\t0\t0\t0\t1\t0\t1\t0";

TEST(nl2_csv, rows_against_front_are_refused_and_single_steps_reported) {
  const std::vector<double> places{1, 1.5, 2, 2.5, 3, 3.5};
  EXPECT_TRUE(parse_nl2_csv(rows_at(places, kAhead), "t.csv")->warnings.empty());
  expect_error(rows_at(places, kBack),
               "t.csv:3: error: expected rows in the direction of Front, found 5 of 5 steps against it: reverse the "
               "order of the rows, or Front and Left");
  const auto loaded = parse_nl2_csv(rows_at({1, 1.5, 2, 1.9, 2.4, 2.9}, kAhead), "t.csv");
  ASSERT_TRUE(loaded.ok()) << loaded.status().message;
  EXPECT_EQ(loaded->warnings,
            std::vector<std::string>{"t.csv:5: warning: the step from the previous row is 180 degrees off Front"});
}

// A level ring of radius 8 m with rows every `turn` radians, and one of them moved by (x, y, z).
std::string ring_with(double turn, int count, int moved, glm::dvec3 by) {
  std::string text(kNl2Header);
  for (int i = 0; i < count; ++i) {
    const double a = i * turn, c = std::cos(a), s = std::sin(a);
    const glm::dvec3 at = glm::dvec3(8 * s, 4, -8 * c) + (i == moved ? by : glm::dvec3(0));
    text += fmt::format("{}\t{:.6f}\t{:.6f}\t{:.6f}\t{:.6f}\t0\t{:.6f}\t{:.6f}\t0\t{:.6f}\t0\t1\t0\n", i + 1, at.x,
                        at.y, at.z, c, s, s, -c);
  }
  return text;
}

TEST(nl2_csv, a_row_beside_the_track_is_reported_and_a_bend_is_not) {
  // One row 0.2 m above the others, which are 0.24 m apart: atan(0.2 / 0.24) = 40 degrees.
  const auto spike = parse_nl2_csv(ring_with(0.03, 40, 20, {0, 0.2, 0}), "t.csv");
  ASSERT_TRUE(spike.ok()) << spike.status().message;
  EXPECT_EQ(spike->warnings,
            (std::vector<std::string>{"t.csv:22: warning: the step from the previous row is 40 degrees off Front",
                                      "t.csv:23: warning: the step from the previous row is 40 degrees off Front"}));
  for (const double turn : {0.03, 0.5, 1.0}) {
    const auto ring = parse_nl2_csv(ring_with(turn, 6, -1, {}), "t.csv");
    ASSERT_TRUE(ring.ok()) << ring.status().message;
    for (const std::string& warning : ring->warnings)
      EXPECT_EQ(warning.find("off Front"), std::string::npos) << warning;
  }
}

TEST(nl2_csv, positions_with_other_axes_than_front_are_refused) {
  const std::string z_up = "0.6\t0\t0.8\t0.8\t0\t-0.6\t0\t1\t0\n";  // steps along (0.6, 0.8, 0): 50 degrees off
  std::string text(kNl2Header);
  for (int i = 0; i < 5; ++i) text += fmt::format("{}\t{}\t{}\t2.5\t{}", i + 1, 0.6 * i, 0.8 * i, z_up);
  expect_error(text,
               "t.csv:3: error: expected steps from row to row along Front, found 4 of 4 steps over 30 degrees off it: "
               "check axes and columns; Y and Z may be swapped in positions alone");
}

TEST(nl2_csv, quoted_numbers_are_read_and_decimal_commas_named) {
  const std::string text = rows(5);
  const std::uint64_t expected = world::hash(parse_nl2_csv(text, "t.csv")->document);
  const std::string body = text.substr(std::string(kNl2Header).size());
  const std::string quoted = replaced(replaced("\"" + body, "\t", "\"\t\""), "\n", "\"\n\"");
  const auto loaded = parse_nl2_csv(std::string(kNl2Header) + quoted.substr(0, quoted.size() - 1), "t.csv");
  ASSERT_TRUE(loaded.ok()) << loaded.status().message;
  EXPECT_EQ(world::hash(loaded->document), expected);
  expect_error(replaced(rows(2), "12.345678", "12,345678"),
               "t.csv:2: error: expected a finite number in column PosY, found \"12,345678\": decimals follow a point, "
               "not a comma");
  expect_error(replaced(rows(2), "12.345678", "1,112.3"),
               "t.csv:2: error: expected a finite number in column PosY, found \"1,112.3\"");
}

TEST(nl2_csv, gaps_and_jumps_of_the_frame_are_reported_with_their_lines) {
  const auto gap = parse_nl2_csv(rows_at({1, 1.5, 2, 3.4, 3.9, 5.41, 5.9}, kAhead), "t.csv");
  ASSERT_TRUE(gap.ok()) << gap.status().message;
  EXPECT_EQ(gap->warnings,
            std::vector<std::string>{"t.csv:7: warning: a gap of 1.510 m from the previous row; the usual spacing is "
                                     "0.500 m"});
  EXPECT_EQ(gap->import->jump_error, 0);
  // Leans by 30 degrees from row 21 on: halfway over a metre, so that the frames there are off.
  std::string text(kNl2Header);
  for (int i = 0; i < 40; ++i)
    text += row(i + 1, 0.05 * i, i < 20 ? kAhead : "1\t0\t0\t0\t0.5\t-0.866025\t0\t0.866025\t0.5");
  const auto jump = parse_nl2_csv(text, "t.csv");
  ASSERT_TRUE(jump.ok()) << jump.status().message;
  EXPECT_EQ(jump->warnings, std::vector<std::string>{"t.csv:22: warning: the frame jumps by 30.00 degrees from the "
                                                     "previous row, over 0.050 m"});
  EXPECT_LE(jump->import->frame_error, 0.5);
  EXPECT_GT(jump->import->jump_error, 5);
  EXPECT_LE(jump->import->jump_error, 30);
}

// 60 rows on a level ring of radius 8 m, evenly spaced but for the step back to the first, `last` times as long.
std::string ring_rows(double last, bool repeated) {
  const double step = 2 * M_PI / (59 + last);
  std::string text(kNl2Header);
  for (int i = 0; i < 60 + (repeated ? 1 : 0); ++i) {
    const double a = i % 60 * step, c = std::cos(a), s = std::sin(a);
    text += fmt::format("{}\t{:.6f}\t4.000000\t{:.6f}\t{:.6f}\t0.0\t{:.6f}\t{:.6f}\t0.0\t{:.6f}\t0.0\t1.0\t0.000000\n",
                        i + 1, 8 * s, -8 * c, c, s, s, -c);
  }
  return text;
}

TEST(nl2_csv, a_last_row_that_repeats_the_first_closes_the_track_however_long_its_step_is) {
  for (const double last : {0.3, 1.0, 1.4, 2.5}) {
    SCOPED_TRACE(last);
    const auto alone = parse_nl2_csv(ring_rows(last, false), "t.csv");
    ASSERT_TRUE(alone.ok()) << alone.status().message;
    EXPECT_EQ(alone->document.track.closed, last <= 1);
    const auto repeated = parse_nl2_csv(ring_rows(last, true), "t.csv");
    ASSERT_TRUE(repeated.ok()) << repeated.status().message;
    EXPECT_TRUE(repeated->document.track.closed);
    EXPECT_TRUE(repeated->warnings.empty());
    EXPECT_LE(repeated->import->max_error, 0.01);
    EXPECT_NEAR(world::exact_length(repeated->document), 16 * M_PI, 0.02);
    EXPECT_TRUE(last > 1 || repeated->document == alone->document);
  }
}

// 200 rows 0.1 m apart on a straight, up to `noise` m to its left or right; Front does not follow.
TEST(nl2_csv, noisy_positions_are_told_with_the_number_of_knots_they_take) {
  const auto loaded = [](double noise) {
    std::mt19937 bits(7);
    std::string text(kNl2Header);
    for (int i = 0; i < 200; ++i) {
      const double aside = noise * (bits() / 2147483648.0 - 1);
      text += fmt::format("{}\t{:.6f}\t4.0\t{:.6f}\t1.0\t0.0\t0.0\t0.0\t0.0\t-1.0\t0.0\t1.0\t0.0\n", i + 1,
                          3.1 + 0.1 * i, 2.7 + aside);
    }
    return parse_nl2_csv(text, "t.csv");
  };
  EXPECT_TRUE(loaded(0.0001)->warnings.empty());
  const auto noisy = loaded(0.005);
  ASSERT_EQ(noisy->warnings.size(), 1u);
  EXPECT_EQ(noisy->warnings[0].find(
                fmt::format("t.csv:2: warning: the rows are noisy: the fit needs {} knots", noisy->import->knots)),
            0u)
      << noisy->warnings[0];
}

TEST(nl2_csv, a_file_that_is_cut_within_a_row_is_refused) {
  const std::string text = rows(4);
  std::size_t whole = 0;
  for (std::size_t length = 0; length < text.size(); ++length) {
    const std::string cut = text.substr(0, length);
    const bool at_row_end =
        (length + 1 < text.size() ? text[length] == '\n' : true) || (length > 0 && text[length - 1] == '\n');
    const auto loaded = parse_nl2_csv(cut, "t.csv");
    const auto row_count =
        static_cast<int>(std::count(cut.begin(), cut.end(), '\n')) - (length > 0 && text[length - 1] == '\n' ? 1 : 0);
    EXPECT_EQ(loaded.ok(), at_row_end && row_count >= 2) << length;
    whole += loaded.ok();
  }
  EXPECT_GT(whole, 2u);
}

TEST(nl2_csv, rows_without_sense_give_a_valid_track_through_all_of_them) {
  std::mt19937 bits(7);
  const auto uniform = [&](double reach) { return reach * (bits() / 2147483648.0 - 1); };
  std::string text(kNl2Header);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 front = glm::normalize(glm::dvec3(uniform(1), uniform(1), uniform(1) + 0.01)),
                     up = curve::perpendicular(front, {uniform(1), uniform(1), 0.3});
    text += std::to_string(i + 1);
    for (const glm::dvec3& v :
         {glm::dvec3(uniform(i % 50 == 0 ? 90'000 : 9), uniform(9), uniform(9)), front, glm::cross(up, front), up})
      for (int axis = 0; axis < 3; ++axis) text += "\t" + std::to_string(v[axis]);
    text += "\n";
  }
  const auto loaded = parse_nl2_csv(text, "t.csv");
  ASSERT_TRUE(loaded.ok()) << loaded.status().message;
  EXPECT_EQ(world::broken_invariant(loaded->document), std::nullopt);
  EXPECT_LE(loaded->import->max_error, 0.01);
  EXPECT_GE(loaded->import->knots, 290);
}

TEST(nl2_csv, a_cancelled_import_is_refused_and_one_that_is_watched_is_the_same) {
  const std::string text = rows(40);
  base::JobProgress progress;
  const auto watched = test::as_job(progress, [&] { return parse_nl2_csv(text, "t.csv"); });
  ASSERT_TRUE(watched.ok());
  EXPECT_TRUE(watched->document == parse_nl2_csv(text, "t.csv")->document);
  EXPECT_EQ(progress.done, 1.0);
  progress.cancelled = true;
  const auto cancelled = test::as_job(progress, [&] { return parse_nl2_csv(text, "t.csv"); });
  EXPECT_EQ(cancelled.status().code, base::Code::refused);
  EXPECT_EQ(cancelled.status().message, "t.csv: the import was cancelled");
}

}  // namespace nl2_csv_test
}  // namespace coaster::exchange
