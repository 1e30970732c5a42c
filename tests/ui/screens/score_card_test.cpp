#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/widgets.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"
#include "world/sections.h"

namespace coaster::ui {
namespace score_card_test {

class ScoreCardTest : public Stage {
 protected:
  void end_a_ride() {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::show_card>{true}));
    ASSERT_TRUE(edit::apply(session_, files_, edit::RideStart{}));
    edit::advance(session_, 120 * 120);
    ASSERT_TRUE(session_.game.result);
    frames(3);
  }
};

TEST_F(ScoreCardTest, the_card_shows_the_simulated_numbers_and_closes_by_key) {
  resize(1280, 720);
  EXPECT_EQ(find("Score/Top speed"), nullptr);
  end_a_ride();
  ASSERT_NE(find("Score/Top speed"), nullptr);
  EXPECT_EQ(find("Score/Top speed")->value,
            fixed(edit::SessionFindings(session_).ratings().top_speed.value, 1) + " m/s");
  EXPECT_EQ(find("Score/Length"), nullptr);
  click("Score/Details");
  frames(2);
  ASSERT_NE(find("Score/Length"), nullptr);
  EXPECT_EQ(find("Score/Length")->value, fixed(session_.derived.length, 1) + " m");
  click("Score/Details");
  frames(2);
  EXPECT_EQ(find("Score/Length"), nullptr);
  key(platform::Key::escape);
  frame();
  EXPECT_EQ(find("Score/Top speed"), nullptr);
  EXPECT_FALSE(session_.game.show_result);
}

// The numbers are of a whole ride, also where the ride itself was not one.
TEST_F(ScoreCardTest, details_say_so_when_track_or_train_changed_during_the_ride) {
  resize(1280, 720);
  end_a_ride();
  click("Score/Details");
  for (const bool whole : {true, false}) {
    session_.game.result->whole = whole;
    frames(2);
    ASSERT_NE(find("Score/Nausea"), nullptr);
    ASSERT_EQ(find("Score/Note") == nullptr, whole);
  }
  EXPECT_NE(find("Score/Note")->value.find("changed during the ride"), std::string::npos);
  const sim::Ratings& r = session_.game.result->ratings;
  EXPECT_EQ(find("Score/Highest drop")->value, fixed(r.highest_drop, 1) + " m");
  EXPECT_EQ(find("Score/Lateral g")->value, fixed(r.side_most.value, 2) + " g");
  EXPECT_EQ(find("Score/Inversions")->value, std::to_string(r.inversions));
  EXPECT_EQ(find("Score/Intensity")->value, fixed(r.intensity, 1));
  EXPECT_EQ(find("Score/Nausea")->value, fixed(r.nausea, 1));
}

TEST_F(ScoreCardTest, the_card_stays_within_the_viewport_and_gives_way_where_there_is_none) {
  end_a_ride();
  for (const glm::ivec2 size : {glm::ivec2{1280, 720}, {1920, 1080}, {900, 500}}) {
    resize(size.x, size.y);
    frames(3);
    const view::Viewport scene = last_.view.viewport;
    for (const Widget& widget : host_->widgets()) {
      if (!widget.path.starts_with("Score/") || !widget.visible) continue;
      EXPECT_GE(widget.x, scene.x) << widget.path;
      EXPECT_LE(widget.x + widget.width, scene.x + scene.width) << widget.path;
    }
  }
  resize(320, 200);
  frames(3);
  EXPECT_EQ(find("Score/Top speed"), nullptr) << "there is no room";
}

TEST_F(ScoreCardTest, the_card_is_a_strip_at_the_foot_and_leaves_a_lesson_free) {
  for (const glm::ivec2 size : {glm::ivec2{1280, 720}, {1920, 1080}}) {
    resize(size.x, size.y);
    end_a_ride();
    const view::Viewport scene = last_.view.viewport;
    float top = scene.y + scene.height;
    for (const Widget& widget : host_->widgets())
      if (widget.path.starts_with("Score/")) top = std::min(top, widget.y);
    EXPECT_GT(top, scene.y + scene.height - 170);
    EXPECT_GT(top, scene.y + 0.6f * scene.height) << "a lesson is at the top, and the track in the middle";
  }
}

TEST_F(ScoreCardTest, notices_and_the_hint_of_a_transform_are_above_the_card) {
  resize(1280, 720);
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetLosses{0.5f, 0}));
  end_a_ride();
  select(world::EntityKind::knot, 2);
  key(platform::Key::g);
  edit::notify(session_, edit::NoticeKind::warning, std::string(200, 'w') + " on several lines");
  frames(3);
  float top = static_cast<float>(height_);
  for (const Widget& widget : host_->widgets())
    if (widget.path.starts_with("Score/")) top = std::min(top, widget.y);
  ASSERT_LT(top, static_cast<float>(height_));
  // Both are drawn behind all windows, and nothing else is here.
  const ImVector<ImDrawVert>& drawn = ImGui::GetBackgroundDrawList()->VtxBuffer;
  ASSERT_GT(drawn.Size, 4 * 200);
  for (const ImDrawVert& vertex : drawn) {
    ASSERT_LE(vertex.pos.y, top);
    ASSERT_GE(vertex.pos.y, last_.view.viewport.y);
  }
}

TEST_F(ScoreCardTest, a_climb_without_a_lift_gets_one_by_a_click) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}));
  for (const world::ElementKind kind : {world::ElementKind::straight, world::ElementKind::climb})
    ASSERT_TRUE(edit::apply(session_, files_, edit::PlaceElement{world::usual_element(kind)}));
  end_a_ride();
  ASSERT_EQ(session_.game.result->end, edit::RideEnd::failed);
  EXPECT_NE(find("Score/Reason")->value.find("or a lift would take it over"), std::string::npos);
  EXPECT_TRUE(climb_without_lift(session_));
  session_.game.challenge.emplace();
  EXPECT_FALSE(climb_without_lift(session_)) << "a challenge is solved by its player";
  session_.game.challenge.reset();
  click("Score/Add a lift");
  frames(2);
  EXPECT_EQ(find("Score/Add a lift"), nullptr) << "it has one";
  const std::vector<world::SectionRun> runs = world::sections_of(session_.document);
  for (std::size_t i = 0; i < session_.document.track.segments.size(); ++i) {
    const auto* const on = session_.document.entities.find<world::Equipment>(session_.document.track.segments[i]);
    EXPECT_EQ(on && on->kind == world::EquipmentKind::lift, i >= runs[1].first) << i;
  }
  click("Score/Ride again");
  edit::advance(session_, 120 * 120);
  frames(3);
  EXPECT_EQ(session_.game.result->end, edit::RideEnd::open_end) << session_.game.result->reason;
}

TEST_F(ScoreCardTest, a_lift_is_offered_for_placed_climbs_alone) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetLosses{0.5f, 0}));
  end_a_ride();
  ASSERT_EQ(session_.game.result->end, edit::RideEnd::failed);
  EXPECT_EQ(find("Score/Add a lift"), nullptr) << "drawn by hand";
  session_.game.result->below_top = true;
  EXPECT_FALSE(climb_without_lift(session_));
}

TEST_F(ScoreCardTest, the_next_challenge_is_offered_once_this_one_is_passed) {
  const std::filesystem::path folder = std::filesystem::path(COASTER_SOURCE_DIR) / "challenges";
  ASSERT_TRUE(edit::apply(session_, files_, edit::StartChallenge{(folder / "01_first_hill.json").string()}));
  end_a_ride();
  session_.game.result->verdict = edit::ChallengeVerdict{};  // nobody judges here
  frames(2);
  EXPECT_EQ(find("Score/Next challenge"), nullptr);
  session_.game.result->verdict->medal = 2;
  frames(2);
  ASSERT_NE(find("Score/Next challenge"), nullptr);
  commands_.clear();
  session_.file.saved_hash = edit::SessionFindings(session_).document_hash();
  click("Score/Next challenge");
  frames(2);
  ASSERT_EQ(all<edit::StartChallenge>().size(), 1u);
  EXPECT_EQ(std::filesystem::path(all<edit::StartChallenge>()[0].path).filename(), "02_smooth_joints.json");
  session_.game.challenge->path = (folder / "08_tired_train.json").string();
  frames(2);
  EXPECT_EQ(find("Score/Next challenge"), nullptr) << "it is the last";
}

TEST_F(ScoreCardTest, where_it_failed_is_selected_and_looked_at) {
  resize(1280, 720);
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetLosses{0.5f, 0}));
  end_a_ride();
  ASSERT_EQ(session_.game.result->end, edit::RideEnd::failed) << "that much friction holds it on the slope";
  const auto place = failed_place(session_);
  ASSERT_TRUE(place);
  key(platform::Key::j);
  frames(2);
  const sim::TrackPlace at = sim::place_at(session_.derived, *place);
  EXPECT_EQ(session_.settings.selected, session_.derived.order[at.index]);
  const glm::dvec3 target(session_.settings.camera.target),
      there =
          curve::point(world::cubic_of(session_.document, session_.settings.selected), session_.settings.selected_t);
  EXPECT_LT(glm::length(target - there), 1e-3);
  EXPECT_FALSE(card_shows(session_)) << "the card would lie over it";
}

TEST(medals, titles_go_from_none_to_gold) {
  EXPECT_EQ(medal_title(0), "No medal");
  EXPECT_EQ(medal_title(1), "Bronze");
  EXPECT_EQ(medal_title(3), "Gold");
}

}  // namespace score_card_test
}  // namespace coaster::ui
