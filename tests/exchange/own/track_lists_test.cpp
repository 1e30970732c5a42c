// The lists of a track file: read while the file is parsed if their order allows it, otherwise after it.
#include <string>

#include <gtest/gtest.h>

#include "exchange/bad_file.h"
#include "exchange/own/track_file.h"
#include "world/document.h"

namespace coaster::exchange {
namespace track_lists_test {

std::string knot(const std::string& id, const std::string& x) {
  return R"({"id":")" + id + R"(","position":[)" + x +
         R"(,2,3],"tangent":[1,0,0],"up":[0,1,0],"in":5,"out":5,"joint":"smooth"})";
}
std::string knots(const std::string& between = "") {
  return R"("knots":[)" + knot("k1", "1") + "," + between + knot("k2", "9") + "]";
}
std::string segments(const std::string& before = "") {
  return R"("segments":[)" + before + R"({"id":"s1","from":"k1","to":"k2","turns":0}])";
}
constexpr const char* kHead =
    R"("format":"coaster-track","version":2,"name":"n","closed":false,"start_speed":1,"datum":0)";
constexpr const char* kCarts = R"("carts":[{"id":"c1","segment":"s1","fraction":0}])";
std::string joined(const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
  return "{" + a + "," + b + "," + c + "," + d + "}";
}
void expect_error(const std::string& text, std::string_view expected) {
  test::expect_bad_file(parse_track(text, "t.json"), "t.json", expected);
}

TEST(track_lists, may_come_in_any_order) {
  const auto usual = parse_track(joined(kHead, knots(), segments(), kCarts), "t.json");
  ASSERT_TRUE(usual) << usual.status().message;
  for (const std::string& text :
       {joined(kHead, segments(), knots(), kCarts), joined(segments(), kCarts, knots(), kHead),
        joined(knots(), kHead, kCarts, segments())}) {
    const auto other = parse_track(text, "t.json");
    ASSERT_TRUE(other) << other.status().message;
    EXPECT_EQ(world::hash(other->document), world::hash(usual->document));
  }
}

// The order of the checks: head, lists, knots, number of segments, segments.
TEST(track_lists, have_the_same_first_error_in_any_order) {
  const std::string wrong_segment = segments(R"({"id":"s9","from":"k7","to":"k2","turns":0},)");
  for (const bool knots_first : {true, false}) {
    const auto track = [&](const std::string& head, const std::string& some_knots, const std::string& some_segments) {
      return knots_first ? joined(head, some_knots, some_segments, kCarts)
                         : joined(some_segments, some_knots, kCarts, head);
    };
    expect_error(track(kHead, knots("5,"), segments()), "knots[1]: expected an object, found 5");
    expect_error(track(kHead, knots("null,"), segments()), "knots[1]: expected an object, found null");
    expect_error(track(kHead, knots(R"({"id":"k1"},)"), wrong_segment), "knots[1].id: \"k1\" is already used");
    expect_error(track(kHead, knots(), wrong_segment), "segments: expected 1 for 2 knots");
    expect_error(track(kHead, knots(), R"("segments":[{"id":"s1","from":"k2","to":"k2","turns":0}])"),
                 "segments[0].from");
    expect_error(track(kHead, knots(), R"("segments":[null])"), "segments[0]: expected an object, found null");
    expect_error(track(R"("format":"other")", knots("{},"), wrong_segment), "format: expected");
  }
}

TEST(track_lists, are_checked_only_in_text_that_is_json) {
  const auto broken = parse_track(joined(kHead, knots("{},"), segments(), R"("carts":[)"), "t.json");
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.status().message.find("knots"), std::string::npos) << broken.status().message;
}

}  // namespace track_lists_test
}  // namespace coaster::exchange
