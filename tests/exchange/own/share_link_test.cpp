#include "exchange/own/share_link.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "exchange/formats.h"
#include "world/sample_documents.h"

namespace coaster::exchange {
namespace share_link_test {

SharedView skew_view() {
  SharedView view;
  view.mode = world::CameraMode::fly;
  view.camera = {{13.7f, 2.3f, -41.9f}, 123.4f, -17.3f, 61.7f, 51.9f, world::Projection::side};
  view.fly = {{-7.1f, 3.3f, 0.1f}, -71.3f, 33.7f};
  view.evaluator = *base::value_named<curve::EvaluatorId>("horner");
  view.steps = 37;
  return view;
}

std::string why(std::string_view link) {
  const auto loaded = parse_link(link);
  EXPECT_TRUE(loaded.ok() || loaded.status().code == base::Code::bad_file);
  return loaded ? "no error" : loaded.status().message;
}

// A link of the same text with one part replaced.
std::string with(std::string_view part, std::string_view other) {
  const std::string link = print_link(test::sample_document(), skew_view());
  std::string text = *unpack(link.substr(link.find('.') + 1), base::kMaxFileBytes);
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  if (at != std::string::npos) text.replace(at, part.size(), other);
  return "#coaster=1." + pack(text);
}

TEST(link, every_sample_track_comes_back_with_its_hash_and_view) {
  base::Files files;
  int tracks = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(COASTER_SOURCE_DIR) / "tracks")) {
    if (entry.path().extension() != ".json") continue;  // the lock of a track that is open
    const auto track = load_track(files, entry.path());
    ASSERT_TRUE(track.ok()) << track.status().message;
    const std::string link = "https://example.org/coaster/" + print_link(track->document, skew_view());
    // Those in a park have three times as many knots: shared as files.
    if (track->document.park.plain()) {
      EXPECT_LT(link.size(), kMaxLinkBytes) << entry.path();
    }
    ASSERT_TRUE(is_link(link));
    const auto loaded = load_track(files, link);
    ASSERT_TRUE(loaded.ok()) << loaded.status().message;
    EXPECT_EQ(world::hash(loaded->document), world::hash(track->document)) << entry.path();
    EXPECT_EQ(print_track(loaded->document), print_track(track->document)) << entry.path();
    EXPECT_EQ(loaded->view, skew_view());
    ++tracks;
  }
  EXPECT_GE(tracks, 5);
}

TEST(link, any_address_and_blanks_after_it_do_not_matter) {
  const std::string link = print_link(test::sample_document(), {});
  for (const char* const before : {"", "coaster:", "https://a.example/b/?c=d", "file:///home/x/coaster.html"})
    for (const char* const after : {"", " ", "\r\n"}) EXPECT_EQ(why(before + link + after), "no error") << before;
  EXPECT_EQ(why("<" + link + ">").substr(0, 23), "link: error: character ");
}

TEST(link, paths_are_no_links) {
  for (const char* const path :
       {"", "a.json", "tracks/a#1.json", "#coaster=.x", "#coaster=1", "#coaster=a.b", "coaster=1.AwA"})
    EXPECT_FALSE(is_link(path)) << path;
  EXPECT_TRUE(is_link("#coaster=2.AwA"));
}

TEST(link, every_truncation_is_refused_with_a_line) {
  const std::string link = print_link(test::sample_document(), skew_view());
  for (std::size_t length = 11; length < link.size() - 1; length += 7) {
    const std::string message = why(link.substr(0, length));
    EXPECT_EQ(message, "link: error: it is cut off") << length;
  }
}

TEST(link, damage_is_noticed_wherever_it_is) {
  const std::string link = print_link(test::sample_document(), skew_view());
  const std::size_t first = link.find('.') + 1;
  for (std::size_t i = first; i + 2 < link.size(); i += 3) {
    std::string damaged = link;
    damaged[i] = damaged[i] == 'A' ? 'B' : 'A';
    const auto loaded = parse_link(damaged);
    if (loaded) {  // of the view alone
      EXPECT_EQ(world::hash(loaded->document), world::hash(test::sample_document())) << i;
      continue;
    }
    EXPECT_EQ(loaded.status().code, base::Code::bad_file);
    EXPECT_EQ(loaded.status().message.find('\n'), std::string::npos);
  }
}

TEST(link, another_track_than_the_shared_one_is_refused) {
  EXPECT_EQ(why(with("103.7", "103.8")), "link: error: it is damaged: the track is not the one that was shared");
}

TEST(link, other_versions_are_refused) {
  const std::string link = print_link(test::sample_document(), {});
  EXPECT_EQ(why("#coaster=2" + link.substr(link.find('.'))), "link: error: version 2 is not known to this program (1)");
  EXPECT_EQ(why("#coaster=99999999999999999999.AwA"),
            "link: error: version 999999999999 is not known to this program (1)");
}

TEST(link, each_member_of_the_view_is_checked) {
  EXPECT_EQ(why(with("\"camera\":\"fly\"", "\"camera\":\"bird\"")),
            "link: error: camera: expected orbit, ride, chase or fly, found \"bird\"");
  EXPECT_EQ(why(with("\"resolution\":37", "\"resolution\":1e9")).substr(0, 24), "link: error: resolution:");
  EXPECT_EQ(why(with("\"evaluator\":\"horner\"", "\"evaluator\":7")).substr(0, 23), "link: error: evaluator:");
  EXPECT_EQ(why(with("\"yaw\":", "\"yaw\":1e30,\"x\":")).substr(0, 17), "link: error: yaw:");
  EXPECT_EQ(why(with("\"hash\":", "\"hush\":")).substr(0, 18), "link: error: hash:");
}

TEST(link, what_holds_no_track_is_refused) {
  EXPECT_EQ(why("#coaster=1." + pack("")), "link: error: it holds no track");
  EXPECT_EQ(why("#coaster=1." + pack("{}\n{}")).substr(0, 18), "link: error: hash:");
  EXPECT_EQ(why("tracks/gentle.json"), "link: error: expected an address with #coaster=1. and a packed track");
  EXPECT_EQ(why("#coaster=1." + pack(std::string(base::kMaxFileBytes + 1, ' '))),
            "link: error: it unpacks to more than 67108864 bytes");
}

}  // namespace share_link_test
}  // namespace coaster::exchange
