// Kind and paint of the coaster.
#include <algorithm>

#include "edit/commands/commands_document.h"
#include "edit/session_fixture.h"
#include "exchange/own/share_link.h"
#include "exchange/own/track_file.h"
#include "sim/solids/coaster_form.h"
#include "world/sections.h"

namespace coaster::edit {
namespace perform_coaster_test {

class Coaster : public test::SessionTest {
 protected:
  Coaster() : SessionTest(world::Document{}) {}
  const world::Document& document() const { return session.document; }
  const world::Section& section(std::uint32_t number) const {
    return world::section(document(), world::find(document(), {world::EntityKind::section, number}));
  }
};

TEST_F(Coaster, usual_heartline_and_losses_follow_the_kind_and_others_stay) {
  good("kind inverted");
  EXPECT_EQ(document().heartline, -1.2);
  EXPECT_EQ(document().resistance, base::row_of(world::CoasterKind::inverted).losses);
  good("kind wooden");
  EXPECT_EQ(document().heartline, 1.1);
  good("kind steel");
  EXPECT_EQ(document().resistance, world::Losses{}) << "as the new track had it";
  good("heartline 0.4");
  good("losses rolling 0.5 drag 0.01");
  good("kind inverted");
  EXPECT_EQ(document().heartline, 0.4);
  EXPECT_EQ(document().resistance, (world::Losses{0.5f, 0.01f}));
  good("undo");
  EXPECT_EQ(document().kind, world::CoasterKind::steel);
}

TEST_F(Coaster, a_kind_has_its_own_room_and_force_limits) {
  good("element straight length 20");
  const auto train = [&] { return sim::form_of(session.derived.made.kind).train; };
  EXPECT_EQ(train().lift, 0.45);
  const double steel = force_limits(session).curves[0].front().g;
  good("kind inverted");
  EXPECT_LT(train().lift, 0) << "the train hangs below the rails";
  good("kind kiddie");
  EXPECT_NEAR(force_limits(session).curves[0].front().g, 0.6 * steel, 1e-12);
}

TEST_F(Coaster, an_inverted_track_near_the_ground_is_warned_of_and_a_new_one_begins_high_enough) {
  good("element straight length 20");
  EXPECT_EQ(world::knot(document(), document().track.knots[0]).position.y, 2);
  good("kind inverted");
  EXPECT_TRUE(std::ranges::any_of(session.notices.list, [](const Notice& notice) {
    return notice.kind == NoticeKind::warning && notice.text.find("2 knots are lower") != std::string::npos;
  }));
  start_on(world::Document{});
  good("kind inverted");
  good("element straight length 20");
  EXPECT_NEAR(world::knot(document(), document().track.knots[0]).position.y, 4.6, 1e-6);
}

TEST_F(Coaster, paint_is_a_palette_or_single_colours) {
  good("paint teal");
  EXPECT_EQ(world::palette_of(document().paint), world::Palette::teal);
  good("paint.colour rails to \"#010203\"");
  EXPECT_EQ(document().paint.rails, world::Colour{0x010203});
  EXPECT_FALSE(world::palette_of(document().paint));
  good("paint.colour rails to own");
  EXPECT_FALSE(document().paint.rails.own());
  good("paint own");
  EXPECT_EQ(document().paint, world::Paint{});
  EXPECT_EQ(print(Command{PaintTrackPart{world::PaintPart::train, {0xff8800}}}), "paint.colour train to \"#ff8800\"");
}

TEST_F(Coaster, sections_keep_their_paint_when_they_are_changed_or_divided) {
  good("element straight length 20");
  good("element curve left radius 20 angle 90");
  good("section.paint @q2 to candy");
  const world::Colour candy = base::row_of(world::Palette::candy).paint.rails;
  EXPECT_EQ(section(2).paint.rails, candy);
  EXPECT_FALSE(section(2).paint.train.own()) << "trains have one paint for the whole track";
  EXPECT_EQ(section(1).paint, world::Paint{});
  good("section.change @q2 to curve left radius 30 angle 45");
  EXPECT_EQ(section(2).paint.rails, candy);
  good("section.title @q2 to \"Bend\"");
  EXPECT_EQ(section(2).paint.rails, candy);
  good("undo");
  good("move @k3 to 30 5 20");
  EXPECT_EQ(section(2).paint.rails, candy) << "shaped by hand";
  refused("section.paint.colour @q2 of train to \"#112233\"", "trains have one paint");
}

TEST_F(Coaster, files_and_links_hold_kind_and_paint_and_plain_tracks_stay_of_the_old_version) {
  good("element straight length 20");
  EXPECT_EQ(exchange::version_of(document()), 3);
  good("section.paint @q1 to ice");
  EXPECT_EQ(exchange::version_of(document()), 4);
  good("kind mine");
  good("paint.colour supports to \"#000000\"");
  const std::string text = exchange::print_track(document());
  EXPECT_NE(text.find("\"version\": 4"), std::string::npos);
  EXPECT_NE(text.find("\"kind\": \"mine\",\n  \"paint_supports\": \"#000000\""), std::string::npos) << text;
  for (const base::Result<exchange::LoadedTrack>& again :
       {exchange::parse_track(text, "a.json"), exchange::parse_link(exchange::print_link(document(), {}))}) {
    ASSERT_TRUE(again) << again.status().message;
    EXPECT_EQ(world::hash(again->document), world::hash(document()));
    EXPECT_EQ(again->document.kind, world::CoasterKind::mine);
  }
  std::string wrong = text;
  wrong.replace(wrong.find("#000000"), 7, "#00000g");
  const auto refused = exchange::parse_track(wrong, "a.json");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.status().message,
            "a.json: error: paint_supports: expected a colour such as \"#d9452f\", or \"own\", found \"#00000g\"");
  good("kind steel"), good("paint own"), good("section.paint all to own");
  EXPECT_EQ(exchange::version_of(document()), 3);
}

}  // namespace perform_coaster_test
}  // namespace coaster::edit
