#include "exchange/formats.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/portable_math.h"
#include "base/scratch_folder.h"
#include "exchange/nolimits/nl2_csv.h"
#include "sim/shape/roll.h"
#include "sim/tracks.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace formats_test {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

TEST(formats, a_path_has_the_format_of_its_ending_in_either_case) {
  for (const TrackFormat& format : formats()) {
    const std::string ending(format.ending);
    EXPECT_EQ(format_of("some.folder/a" + ending), &format);
    EXPECT_EQ(format_of("a.b" + upper(ending)), &format);
    EXPECT_EQ(format_of("a" + ending + "x"), nullptr);
    EXPECT_TRUE(format.parse || format.print) << ending;
  }
  EXPECT_EQ(format_of("json"), nullptr);
  EXPECT_EQ(format_of(".json/track"), nullptr);
}

TEST(formats, messages_name_every_ending_once) {
  const std::string read = known_endings(FormatUse::read), write = known_endings(FormatUse::write);
  for (const TrackFormat& format : formats()) {
    EXPECT_EQ(read.find(format.ending) != std::string::npos, format.parse != nullptr) << format.ending;
    EXPECT_EQ(write.find(format.ending) != std::string::npos, format.print != nullptr) << format.ending;
  }
  EXPECT_EQ(std::count(read.begin(), read.end(), '.'),
            std::count_if(formats().begin(), formats().end(), [](const TrackFormat& f) { return f.parse != nullptr; }));
}

// A terminal that shows the file is controlled by nothing in a name: no escape, no DEL, no C1 control in either form,
// no mark that turns the direction of text.
TEST(formats, no_export_controls_a_terminal) {
  const test::ScratchFolder scratch;
  base::Files files;
  world::Document document = test::ring_document(6, 20.5f, 3.1f);
  document.name =
      "a\x1b]0;title\x07"
      "b\x7f"
      "c\xc2\x9b"
      "31md\xe2\x80\xae"
      "e\xd8\x9c"
      "f\xe2\x81\xa6"
      "g\xe2\x80\xa8h\x9b";
  int written = 0;
  for (const TrackFormat& format : formats()) {
    if (!format.print) continue;
    const std::filesystem::path path = scratch.path() / ("a" + std::string(format.ending));
    ASSERT_TRUE(save_track(files, path, document)) << format.ending;
    const std::string bytes = files.read(path)->data();
    ++written;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const auto byte = static_cast<unsigned char>(bytes[i]);
      const bool line_end = byte == '\n' || byte == '\t' || (byte == '\r' && bytes[i + 1] == '\n');
      EXPECT_TRUE(line_end || (byte >= 0x20 && byte != 0x7f)) << format.ending << " at " << i;
    }
    for (const char* const mark : {"\xc2\x9b", "\xe2\x80\xae", "\xd8\x9c", "\xe2\x81\xa6", "\xe2\x80\xa8", "h\x9b"})
      EXPECT_EQ(bytes.find(mark), std::string::npos) << format.ending;
    if (format.whole && format.parse) {
      document.name = "a\x7f\xc2\x9b\xe2\x80\xae";
      ASSERT_TRUE(save_track(files, path, document));
      const auto back = load_track(files, path);
      ASSERT_TRUE(back.ok()) << back.status().message;
    }
  }
  EXPECT_GE(written, 6);
}

TEST(formats, archives_and_utf_16_are_named_with_what_to_do) {
  const test::ScratchFolder scratch;
  const std::filesystem::path& folder = scratch.path();
  base::Files files;
  const auto error = [&](const std::string& name, const std::string& bytes) {
    EXPECT_TRUE(files.write_atomic(folder / name, bytes).ok());
    const auto loaded = load_track(files, folder / name);
    EXPECT_EQ(loaded.status().code, base::Code::bad_file) << name;
    return loaded.status().message.substr(std::min((folder / name).string().size(), loaded.status().message.size()));
  };
  EXPECT_EQ(error("a.json", "PK\x03\x04..."),
            ": error: expected the format coaster track, found a zip archive: unpack it first");
  EXPECT_EQ(error("a.nltrack", "\x1f\x8b\x08..."),
            ": error: expected the format NoLimits 1 track, found a gzip archive: unpack it first");
  const std::string utf_16 =
      ": error: expected the format NoLimits 2 track spline, found UTF-16 text: save it as UTF-8";
  EXPECT_EQ(error("a.csv", std::string("\xff\xfeN\0o\0", 6)), utf_16);
  EXPECT_EQ(error("a.csv", std::string("\xfe\xff\0N\0o", 6)), utf_16);
  EXPECT_EQ(error("a.csv", std::string("N\0o\0", 4)), utf_16);
  EXPECT_EQ(error("a.csv", std::string("\0N\0o", 4)), utf_16);
}

// The shape that comes back is within a centimetre at the knots, where one whole format keeps every bit.
TEST(formats, what_a_format_prints_and_reads_is_the_same_track) {
  const world::Document sample = test::sample_document();
  for (const TrackFormat& format : formats()) {
    if (!format.parse || !format.print) continue;
    if (format.check) {
      ASSERT_TRUE(format.check(sample).ok()) << format.ending;
    }
    const std::string bytes = format.print(sample);
    const auto loaded = format.parse(bytes, "a" + std::string(format.ending));
    ASSERT_TRUE(loaded) << format.ending << ": " << loaded.status().message;
    const world::Document& d = loaded->document;
    EXPECT_EQ(world::broken_invariant(d), std::nullopt) << format.ending;
    ASSERT_FALSE(d.track.knots.empty());
    for (const world::Entity k : d.track.knots) {
      const float spin = world::knot(d, k).spin;
      EXPECT_TRUE(spin == 0 || std::abs(spin) >= sim::kLeastSpin) << format.ending << ": a spin of " << spin;
    }
    for (const bool last : {false, true}) {
      const auto end_of = [&](const world::Document& of) {
        return glm::dvec3(world::knot(of, last ? of.track.knots.back() : of.track.knots.front()).position);
      };
      EXPECT_LT(glm::distance(end_of(d), end_of(sample)), 0.01) << format.ending;
    }
    if (format.whole) {
      EXPECT_EQ(world::hash(d), world::hash(sample)) << format.ending;
    }
  }
}

TEST(formats, a_file_over_the_limit_of_its_format_is_refused_before_it_is_read) {
  const test::ScratchFolder scratch;
  base::Files files;
  const std::filesystem::path large = scratch.path() / "large.nl2elem";
  ASSERT_TRUE(files.write_atomic(large, std::string(5u << 20, ' ')));
  const auto loaded = load_track(files, large);
  EXPECT_EQ(loaded.status().code, base::Code::bad_file);
  EXPECT_NE(loaded.status().message.find("larger than the limit of 4194304 bytes"), std::string::npos)
      << loaded.status().message;
}

TEST(formats, a_track_with_all_knots_at_one_point_is_warned_of) {
  const test::ScratchFolder scratch;
  base::Files files;
  world::Document line = test::straight_document({1, 2, 3}, {41, 2, 3}, 4);
  ASSERT_TRUE(save_track(files, scratch.path() / "line.json", line));
  EXPECT_TRUE(load_track(files, scratch.path() / "line.json")->warnings.empty());
  for (const world::Entity e : line.track.knots) line.entities.get<world::Knot>(e).position = {1, 2, 3};
  ASSERT_TRUE(save_track(files, scratch.path() / "point.json", line));
  const auto point = load_track(files, scratch.path() / "point.json");
  ASSERT_TRUE(point);
  ASSERT_EQ(point->warnings.size(), 1u);
  EXPECT_NE(point->warnings[0].find("all 5 knots are at one point"), std::string::npos) << point->warnings[0];
}

TEST(formats, an_import_gets_a_train_and_a_start_speed_that_completes_its_ride) {
  const test::ScratchFolder scratch;
  base::Files files;
  world::Document circle = test::circle_document(7.5, {3.1, 2.2, -1.7}, {1, 0, 0.3});
  world::add_cart(circle, circle.track.segments[3], 0.2);
  circle.start_speed = 17.25;
  for (const std::string name : {"own.json", "rows.csv", "element.nl2elem"}) {
    const std::filesystem::path path = scratch.path() / name;
    ASSERT_TRUE(save_track(files, path, circle).ok());
    const auto loaded = load_track(files, path);
    ASSERT_TRUE(loaded) << loaded.status().message;
    const bool own = name == "own.json";
    EXPECT_TRUE(world::first_cart(loaded->document).valid()) << name;
    // From the bottom over the top, 15 m higher: 17.2 m/s at the least.
    EXPECT_EQ(loaded->document.start_speed, own ? 17.25 : 19.0) << name;
    const std::string completes = "The train completes the ride with a start speed of 19 m/s.";
    EXPECT_EQ(loaded->note.substr(0, completes.size()), own ? "" : completes) << name;
  }
  const auto ring = load_track(files, std::string(COASTER_SOURCE_DIR) + "/tests/tracks/ring.nltrack");
  ASSERT_TRUE(ring) << ring.status().message;
  EXPECT_TRUE(world::first_cart(ring->document).valid());
  EXPECT_FALSE(ring->note.empty());
  const std::filesystem::path high = scratch.path() / "high.nl2elem";
  ASSERT_TRUE(save_track(files, high, test::straight_document({0, 0, 0}, {90, 1160, 0}, 40)).ok());
  const auto loaded = load_track(files, high);
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_EQ(loaded->warnings,
            (std::vector<std::string>{
                high.string() + ": warning: the track is 1.2 km long and 1160 m high. Positions are in metres: if the "
                                "file has another unit, scale its positions and open it again",
                "No start speed up to 150 m/s completes the ride."}));
}

TEST(formats, an_import_in_millimetres_is_warned_of_and_none_in_metres) {
  const test::ScratchFolder scratch;
  base::Files files;
  const auto warned = [&](const std::string& name, const world::Document& document) {
    EXPECT_TRUE(save_track(files, scratch.path() / name, document).ok());
    const auto loaded = load_track(files, scratch.path() / name);
    EXPECT_TRUE(loaded) << loaded.status().message;
    return loaded && !loaded->warnings.empty() && loaded->warnings[0].find("another unit") != std::string::npos;
  };
  // 21 m and 19 m in millimetres, 590 m high in metres; files of the program are what they are.
  EXPECT_TRUE(warned("long.nl2elem", test::straight_document({-10'000, 2, 3}, {11'000, 2, 3}, 40)));
  EXPECT_FALSE(warned("short.nl2elem", test::straight_document({-10'000, 2, 3}, {9'000, 2, 3}, 40)));
  EXPECT_TRUE(warned("high.nl2elem", test::straight_document({0, -5, 3}, {9'000, 605, 3}, 40)));
  EXPECT_FALSE(warned("low.nl2elem", test::straight_document({0, -5, 3}, {9'000, 585, 3}, 40)));
  EXPECT_FALSE(warned("long.json", test::straight_document({-10'000, 2, 3}, {11'000, 2, 3}, 40)));
}

struct ImportWords : testing::Test {
  test::ScratchFolder scratch;
  base::Files files;
  std::string write(const std::string& name, const std::string& text) {
    EXPECT_TRUE(files.write_atomic(scratch.path() / name, text).ok());
    return (scratch.path() / name).string();
  }
  static glm::dvec3 place(const LoadedTrack& track, std::size_t i) {
    return glm::dvec3(world::knot(track.document, track.document.track.knots.at(i)).position);
  }
};

TEST_F(ImportWords, rows_at_50_km_are_warned_of_asked_about_and_moved_with_the_word_origin) {
  world::Document circle = test::circle_document(40, {3, 12, -7}, {1, 0, 0});
  const std::string near = print_nl2_csv(circle, 0.5);
  std::string far;
  for (std::size_t line = 0, at = 0, end = 0; at < near.size(); at = end + 1, ++line) {
    end = near.find('\n', at);
    const std::string row = near.substr(at, end + 1 - at);
    const std::size_t a = row.find('\t'), b = row.find('\t', a + 1);
    far +=
        line == 0 ? row : row.substr(0, a + 1) + std::to_string(std::stod(row.substr(a + 1)) + 50'000) + row.substr(b);
  }
  const std::string path = write("far.csv", far);
  const auto there = load_track(files, path);
  ASSERT_TRUE(there) << there.status().message;
  ASSERT_FALSE(there->warnings.empty());
  EXPECT_NE(there->warnings.back().find("50 km from the origin"), std::string::npos) << there->warnings.back();
  EXPECT_EQ(question_of(files, path)->proposed, ImportOptions{.origin = true});
  EXPECT_EQ(question_of(files, path)->points, 0u);
  EXPECT_FALSE(question_of(files, write("near.csv", near)));
  const auto moved = load_track(files, path, {.origin = true});
  ASSERT_TRUE(moved) << moved.status().message;
  EXPECT_TRUE(moved->warnings.empty());
  EXPECT_NE(moved->note.find("Moved by (-50003.000, -10.000, 7.000) m to the origin."), std::string::npos)
      << moved->note;
  for (std::size_t i = 0; i < moved->document.track.knots.size(); ++i)
    EXPECT_NEAR(glm::length(place(*moved, i) - glm::dvec3(0, 42, 0)), 40, 0.011);
  EXPECT_NE(load_track(files, path, {.scale = 1}).status().message.find("are only for lists of points"),
            std::string::npos);
}

// The kinds of files whose curve changed: a heartline, rolls that change, rounded rows.
TEST_F(ImportWords, an_import_with_another_curve_than_before_says_so_once) {
  const std::string folder = COASTER_SOURCE_DIR "/tests/tracks/";
  const auto times = [&](const std::string& path) {
    const auto loaded = load_track(files, path);
    EXPECT_TRUE(loaded) << path;
    int count = 0;
    if (loaded)
      for (std::size_t at = 0; (at = loaded->note.find("Earlier versions", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  const std::string rows = *files.read(folder + "hills.csv");
  const std::string rounded = std::regex_replace(rows, std::regex(R"((\.\d{3})\d{3}\b)"), "$1");
  const auto element = [&](const char* track) {
    const std::string path = (scratch.path() / track).replace_extension(".nl2elem").string();
    EXPECT_TRUE(
        save_track(files, path, load_track(files, COASTER_SOURCE_DIR "/tracks/" + std::string(track))->document));
    return path;
  };
  EXPECT_EQ(times(folder + "two_hills_heartline.fvd"), 1);
  EXPECT_EQ(times(folder + "two_hills.fvd"), 0) << "without a heartline the curve is the same";
  EXPECT_EQ(times(write("rounded.csv", rounded)), 1);
  EXPECT_EQ(times(folder + "hills.csv"), 0) << "six decimals";
  EXPECT_EQ(times(element("helix.json")), 1);
  std::string level = *files.read(element("helix.json"));
  level.erase(level.find("<roll>"), level.rfind("</roll>") + 7 - level.find("<roll>"));
  EXPECT_EQ(times(write("level.nl2elem", level)), 0) << "without rolls";
}

TEST_F(ImportWords, a_list_is_asked_about_with_its_proposal) {
  const std::string utm =
      write("utm.xyz", "500000 4000000 30\n500200 4000000 35\n500200 4000100 30\n500000 4000100 30\n");
  const auto question = question_of(files, utm);
  ASSERT_TRUE(question);
  EXPECT_EQ(question->proposed, (ImportOptions{.up = world::Axis::z, .scale = 1, .origin = true}));
  EXPECT_EQ(question->points, 4u);
  EXPECT_EQ(question->size, glm::dvec3(200, 100, 5));
  EXPECT_FALSE(question_of(files, write("bad.xyz", "1 2 3\n4 5\n"))) << "loading it tells the line";
  EXPECT_FALSE(question_of(files, write("own.json", "{}")));
  EXPECT_FALSE(question_of(files, (scratch.path() / "none.xyz").string()));
}

TEST_F(ImportWords, pasted_lines_are_a_list) {
  const auto track = load_track(files, "3\n0 5 0\n60 5 0\n120 9 0\n", {.up = world::Axis::y, .scale = 1});
  ASSERT_TRUE(track) << track.status().message;
  EXPECT_EQ(place(*track, 2), glm::dvec3(120, 9, 0));
  EXPECT_TRUE(is_pasted("1 2 3\n4 5 6"));
  EXPECT_FALSE(is_pasted("1 2 3")) << "one line is a path";
  EXPECT_FALSE(is_pasted("to do:\n1 2 3"));
  EXPECT_EQ(load_track(files, "0 5 0\n60 5\n").status().message.substr(0, 22), "Pasted points:2: error");
}

TEST_F(ImportWords, the_unit_warning_names_the_word_scale) {
  const std::string list = write("mm.xyz", "0 0 0\n400000 0 0\n400000 5 30000\n");
  const auto large = load_track(files, list, {.up = world::Axis::y, .scale = 0.1});
  ASSERT_TRUE(large) << large.status().message;
  ASSERT_FALSE(large->warnings.empty());
  EXPECT_NE(large->warnings[0].find("load it with the word scale"), std::string::npos) << large->warnings[0];
  EXPECT_NE(load_track(files, list)->note.find("0.001 m a unit (proposed)"), std::string::npos);
}

// On a level circle without losses the bank is atan(v^2 / (r g)) everywhere.
TEST_F(ImportWords, auto_bank_cancels_lateral_g_at_the_start_speed) {
  std::string text;
  for (int i = 0; i < 90; ++i)
    text += fmt::format("{:.6f} 5 {:.6f}\n", 30 * std::cos(base::kPi * i / 45), 30 * std::sin(base::kPi * i / 45));
  const std::string path = write("ring.txt", text);
  const auto level = load_track(files, path), banked = load_track(files, path, {.bank = ImportBank::automatic});
  ASSERT_TRUE(level && banked);
  EXPECT_NE(banked->note.find("Banked 90 knots."), std::string::npos) << banked->note;
  const double speed = banked->document.start_speed, bank = std::atan(speed * speed / (30 * 9.81)) * 180 / base::kPi;
  ASSERT_GT(bank, 0.1);
  for (const world::Entity e : level->document.track.knots)
    EXPECT_NEAR(world::roll_deg(world::knot(level->document, e)), 0, 1e-4);
  for (const world::Entity e : banked->document.track.knots)
    EXPECT_NEAR(std::abs(world::roll_deg(world::knot(banked->document, e))), bank, 0.02 * bank);
}

TEST_F(ImportWords, an_obj_names_the_materials_of_the_file_beside_it) {
  const std::filesystem::path path = scratch.path() / "track.obj";
  ASSERT_TRUE(save_track(files, path, test::sample_document()));
  const std::string obj = *files.read(path), mtl = *files.read(scratch.path() / "track.mtl");
  EXPECT_EQ(obj.substr(0, 17), "mtllib track.mtl\n");
  std::size_t used = 0;
  for (std::size_t at = 0; (at = obj.find("\nusemtl ", at)) != std::string::npos; ++used) {
    at += 8;
    const std::string name = obj.substr(at, obj.find('\n', at) - at);
    EXPECT_NE(mtl.find("newmtl " + name + "\nKd "), std::string::npos) << name;
  }
  EXPECT_GE(used, 4u);
}

}  // namespace formats_test
}  // namespace coaster::exchange
