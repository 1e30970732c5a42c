#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/cancellable_job.h"
#include "base/scratch_folder.h"
#include "base/tries.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "edit/random_commands.h"
#include "edit/session_fixture.h"
#include "exchange/own/share_link.h"
#include "world/evaluation_settings.h"

namespace coaster::edit {
namespace apply_test {

// A command of the document kinds, mostly on names and places that make sense for a small track.
Command document_command(test::RandomCommands& random) {
  for (;;) {
    Command c = random.of_kind(random.below(Commands::size));
    if (info(c).effect == Effect::document) return c;
  }
}

class Applying : public test::SessionTest {
 protected:
  std::string file(const char* name) const { return (scratch_.path() / name).string(); }
  test::ScratchFolder scratch_;
};

TEST_F(Applying, save_and_load_bring_the_same_document) {
  good("datum 3.25");
  EXPECT_TRUE(dirty(session));
  const std::uint64_t before = hash();
  ASSERT_TRUE(apply(Save{file("a.json")}));
  EXPECT_FALSE(dirty(session));
  EXPECT_EQ(session.file.path, file("a.json"));
  good("new");
  EXPECT_TRUE(session.file.path.empty());
  EXPECT_TRUE(session.document == world::Document{});
  EXPECT_TRUE(session.history.undo.empty());
  EXPECT_EQ(session.motion.carts.size(), 0u);
  ASSERT_TRUE(apply(LoadTrack{file("a.json")}));
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(session.motion.carts.size(), 2u);
  EXPECT_FALSE(dirty(session));
}

// What is derived is built by loops that end early; only the document is used afterwards, for the autosave.
TEST_F(Applying, an_interrupted_command_leaves_the_document_as_it_was) {
  const world::Document before = session.document;
  base::JobProgress job;
  job.cancelled = true;
  for (const char* const line : {"duplicate all", "reverse", "translate all by 1 2 3", "make_all_g2", "close"}) {
    const base::JobScope working(&job);
    EXPECT_FALSE(apply(line)) << line;
    EXPECT_TRUE(session.document == before) << line;
    EXPECT_TRUE(session.history.undo.empty()) << line;
  }
}

// Cancel comes at some question of a loop whether to go on.
struct CancelledLater {
  explicit CancelledLater(int questions) {
    left = questions, job = &progress;
    base::watch_interruption([] {
      if (left-- == 0) job->cancelled = true;
      return false;
    });
  }
  ~CancelledLater() { base::watch_interruption(nullptr); }
  CancelledLater(const CancelledLater&) = delete;
  CancelledLater& operator=(const CancelledLater&) = delete;
  static inline std::atomic<int> left;
  static inline base::JobProgress* job;
  base::JobProgress progress;
};

// What is derived from the document is what a new derivation makes of it.
void expect_settled(const Session& session) {
  sim::DerivedTrack anew;
  sim::derive(session.document, session.settings, {}, anew);
  ASSERT_EQ(session.derived.order, anew.order);
  ASSERT_EQ(session.derived.starts, anew.starts);
  ASSERT_EQ(session.derived.twists, anew.twists);
  for (std::size_t i = 0; i < anew.order.size(); ++i) {
    const sim::SegmentShape &is = session.derived.shape_at(i), &wanted = anew.shape_at(i);
    ASSERT_TRUE(is.key == wanted.key && is.ups == wanted.ups && is.polyline_key == wanted.polyline_key) << i;
  }
}

TEST_F(Applying, a_command_that_is_cancelled_at_any_moment_changes_nothing_or_is_done) {
  int cancelled = 0;
  for (int i = 0; i < test::tries(160); ++i) {
    const auto seed = static_cast<std::uint32_t>(i);
    test::RandomCommands random(seed);
    const Command c = i % 4 == 0 ? random.of_kind(random.below(Commands::size)) : document_command(random);
    if (info(c).effect == Effect::session) continue;
    if (i % 3 == 0) circuit();
    else start_on(test::random_document(seed));
    const std::unique_ptr<Session> done = std::make_unique<Session>(session),
                                   before = std::make_unique<Session>(session);
    const base::Status status = edit::apply(*done, files, c);
    CancelledLater cancel(static_cast<int>(random.below(12)));
    const auto now = [&] {
      const base::JobScope working(&cancel.progress);
      return apply(c);
    }();
    if (status && !now) {
      ++cancelled;
      settle(session);
      EXPECT_TRUE(session.document == before->document) << print(c);
      EXPECT_TRUE(session.motion == before->motion) << print(c);
      EXPECT_TRUE(session.settings == before->settings) << print(c);
      EXPECT_EQ(session.history.undo.size(), before->history.undo.size()) << print(c);
      EXPECT_EQ(session.notices.serial, before->notices.serial) << print(c);
    } else {
      EXPECT_EQ(now.ok(), status.ok()) << print(c);
      EXPECT_TRUE(session.document == done->document) << print(c);
      EXPECT_TRUE(session.motion == done->motion) << print(c);
      EXPECT_TRUE(session.settings == done->settings) << print(c);
    }
    expect_settled(session);
  }
  EXPECT_GT(cancelled, test::tries(12));
}

TEST_F(Applying, a_track_that_is_opened_is_complete_however_late_it_is_cancelled) {
  circuit();
  ASSERT_TRUE(apply(Save{file("a.json")}));
  const std::uint64_t saved = hash();
  int opened = 0;
  for (int questions = 0; questions < 40; ++questions) {
    good("new");
    CancelledLater cancel(questions);
    const auto status = [&] {
      const base::JobScope working(&cancel.progress);
      return apply(LoadTrack{file("a.json")});
    }();
    if (!status) settle(session);
    opened += status.ok();
    EXPECT_EQ(hash(), status ? saved : world::hash(world::Document{})) << questions;
    EXPECT_EQ(session.file.path, status ? file("a.json") : "");
    expect_settled(session);
  }
  EXPECT_GT(opened, 0);
}

TEST_F(Applying, exporting_leaves_the_path_and_what_is_unsaved) {
  ASSERT_TRUE(apply(Save{file("a.json")}));
  good("datum 3.25");
  for (const char* name : {"a.obj", "a.gltf", "a.svg"}) {
    ASSERT_TRUE(apply(Save{file(name)}));
    EXPECT_EQ(session.notices.list.back().text, "Exported " + file(name));
    EXPECT_GT(std::filesystem::file_size(file(name)), 0u);
    EXPECT_TRUE(dirty(session));
    EXPECT_EQ(session.file.path, file("a.json"));
    EXPECT_EQ(apply(LoadTrack{file(name)}).code, base::Code::bad_file);
    EXPECT_NE(session.notices.list.back().text.find("can only be written; expected a file ending in .json"),
              std::string::npos);
  }
  EXPECT_EQ(apply(Save{file("a.nltrack")}).code, base::Code::refused);
  EXPECT_NE(session.notices.list.back().text.find("can only be read; expected a file ending in .json"),
            std::string::npos);
  ASSERT_TRUE(apply(Save{file("a.json")}));
  EXPECT_FALSE(dirty(session));
}

// Changes by another program are lost only if the command requests it.
TEST_F(Applying, a_file_that_another_program_changed_is_not_overwritten) {
  ASSERT_TRUE(apply(Save{file("a.json")}));
  const auto replaced = [&] { return base::Files().read(file("a.json")); };
  const auto change = [&](const char* text) { ASSERT_TRUE(files.write_atomic(file("a.json"), text)); };
  change("theirs");
  good("datum 3.25");
  const world::Document before = session.document;
  std::filesystem::create_symlink(file("a.json"), file("link.json"));
  for (const char* const name : {"a.json", "link.json"}) {
    const base::Status refused = apply(Save{file(name)});
    EXPECT_EQ(refused.code, base::Code::io) << name;
    EXPECT_NE(refused.message.find("changed by another program"), std::string::npos) << refused.message;
    EXPECT_EQ(*replaced(), "theirs");
  }
  EXPECT_TRUE(session.document == before && dirty(session));
  EXPECT_TRUE(apply(Save{file("b.json")})) << "another name";
  EXPECT_TRUE(apply(LoadTrack{file("b.json")}));
  EXPECT_TRUE(apply(Save{file("b.json")})) << "nobody changed this one";
  EXPECT_TRUE(apply(Save{file("b.json")}));

  change("theirs");
  EXPECT_TRUE(apply(Save{file("a.json")})) << "not the document's own file: the window asks before it gets here";
  change("theirs again");
  good("save \"" + file("a.json") + "\" overwrite");
  EXPECT_NE(*replaced(), "theirs again");
  std::filesystem::remove(file("a.json"));
  EXPECT_TRUE(apply(Save{file("a.json")})) << "a deleted file has nothing to lose";
  files.inject(base::IoOperation::fsync, 2);
  good("datum 1");
  EXPECT_FALSE(apply(Save{file("a.json")}));
  EXPECT_TRUE(apply(Save{file("a.json")})) << "what is there is what the failed save wrote";
}

TEST_F(Applying, a_recovered_track_may_replace_the_file_that_it_was_compared_with) {
  ASSERT_TRUE(apply(Save{file("a.json")}));
  good("datum 3.25");
  ASSERT_TRUE(apply(Save{file("autosave.json")}));
  ASSERT_TRUE(apply(RecoverTrack{file("autosave.json"), file("a.json")}));
  EXPECT_TRUE(apply(Save{file("a.json")}));
  ASSERT_TRUE(files.write_atomic(file("a.json"), "no track"));
  ASSERT_TRUE(apply(RecoverTrack{file("autosave.json"), file("a.json")}));
  EXPECT_EQ(apply(Save{file("a.json")}).code, base::Code::io) << "nobody has seen what is there";
}

// Saving an import goes to a new file, never to the imported one; until then it is not saved.
TEST_F(Applying, an_imported_track_has_no_path) {
  ASSERT_TRUE(apply(Save{file("a.json")}));
  ASSERT_TRUE(apply(LoadTrack{COASTER_SOURCE_DIR "/tests/tracks/ring.nltrack"}));
  EXPECT_TRUE(session.file.path.empty());
  EXPECT_EQ(session.document.name, "ring");
  EXPECT_TRUE(dirty(session));
}

// A link holds everything, but it is no file: the next save needs a name.
TEST_F(Applying, a_track_of_a_link_has_no_path_and_the_view_of_the_link) {
  ASSERT_TRUE(apply(Save{file("a.json")}));
  exchange::SharedView view;
  const std::string link = "https://example.org/" + exchange::print_link(session.document, view);
  const std::size_t knots = session.document.track.knots.size();
  good("new");
  ASSERT_TRUE(apply(LoadTrack{link}));
  EXPECT_EQ(session.document.track.knots.size(), knots);
  EXPECT_TRUE(session.file.path.empty());
  EXPECT_FALSE(dirty(session));
}

TEST_F(Applying, files_that_fail_leave_everything_as_it_was) {
  const world::Document before = session.document;
  EXPECT_EQ(apply(LoadTrack{file("none.json")}).code, base::Code::bad_file);
  EXPECT_EQ(session.notices.list.back().kind, NoticeKind::error);
  files.inject(base::IoOperation::fsync, 1);
  EXPECT_EQ(apply(Save{file("a.json")}).code, base::Code::io);
  EXPECT_TRUE(session.file.path.empty());
  refused(Save{""}, "expected a file");
  refused(Save{file("a.txt")}, "ending in .json");
  EXPECT_TRUE(session.document == before);
}

TEST_F(Applying, loading_a_track_over_the_budget_lowers_the_resolution) {
  ASSERT_TRUE(apply(Save{file("a.json")}));
  good("new");
  good("resolution 1000");
  good("vertex_budget 1000");
  ASSERT_TRUE(apply(LoadTrack{file("a.json")}));
  EXPECT_EQ(session.settings.evaluation->steps, 249);
  EXPECT_NE(session.notices.list.back().text.find("limit"), std::string::npos);
  EXPECT_EQ(session.derived.vertices, 1000);
}

TEST_F(Applying, undoing_everything_returns_to_the_first_document_and_redoing_to_the_last) {
  for (int seed = 0; seed < test::tries(3); ++seed) {
    good("new");
    session.document = test::sample_document();
    ASSERT_TRUE(apply(SetDatum{7.75}));
    session.history = {};
    const world::Document first = session.document;
    test::RandomCommands random(static_cast<std::uint32_t>(seed));
    int applied = 0;
    for (int i = 0; i < 200; ++i) {
      const Command c = document_command(random);
      const world::Document before = session.document;
      const base::Status status = apply(c);
      applied += status.ok();
      ASSERT_TRUE(status || session.document == before) << print(c);
      ASSERT_EQ(world::broken_invariant(session.document), std::nullopt) << print(c);
      ASSERT_EQ(session.derived.order, session.document.track.segments);
    }
    EXPECT_GT(applied, 30);
    const world::Document last = session.document;
    const std::size_t depth = session.history.undo.size();
    while (!session.history.undo.empty()) good("undo");
    EXPECT_TRUE(session.document == first);
    EXPECT_EQ(hash(), world::hash(first));
    EXPECT_EQ(session.history.redo.size(), depth);
    while (!session.history.redo.empty()) good("redo");
    EXPECT_TRUE(session.document == last);
  }
}

// Expensive commands are rarer and smaller: whole rides of up to 900 s (banking, a new timetable after each edit),
// steps of up to an hour. All still occur: in 100 sessions of 60 commands each of them is run some ten times.
bool too_costly(Command& command, test::RandomCommands& random) {
  if (RideStep* const step = command.as<RideStep>())
    step->ticks = std::min(step->ticks, 1 + static_cast<int>(random.below(120)));
  const auto* const row = command.as<Set<&world::Settings::integrator>>();
  const bool timetable = row && base::row_of(row->to).kind == sim::IntegratorKind::timetable;
  return (command.is<AutoBank>() || timetable) && random.below(8) != 0;
}

// Numbers of commands that did not come from text may be anything; no kind of command may take them.
TEST_F(Applying, no_command_takes_a_number_that_is_not_finite) {
  int numbers = 0;
  const auto spoiled = [&]<class C>() {
    for (int field = 0, fields = 1; field < fields; ++field)
      for (const double bad : {std::nan(""), HUGE_VAL}) {
        C command;
        fields = 0;
        const auto spoil = [&](auto& number) {
          if (fields++ == field) number = static_cast<std::remove_reference_t<decltype(number)>>(bad), ++numbers;
        };
        C::fields(command, [&]<class T>(std::string_view, T& value) {
          if constexpr (std::is_floating_point_v<T>) spoil(value);
          else if constexpr (std::is_same_v<T, glm::vec3>) spoil(value.x), spoil(value.y), spoil(value.z);
          else if constexpr (std::is_same_v<T, world::Element>) spoil(value.values[0]);
          else if constexpr (std::is_same_v<T, HandleTarget>) value.knot = {world::EntityKind::knot, 1};
          else if constexpr (std::is_same_v<T, Target>) {
            if constexpr (requires { command.segment; }) value.name = {world::EntityKind::segment, 1};
            else if constexpr (requires { command.cart; }) value.name = {world::EntityKind::cart, 1};
            else if constexpr (requires { command.section; }) value.name = {world::EntityKind::section, 1};
            else value.name = {world::EntityKind::knot, 1};
          }
        });
        if (fields == 0) break;
        const world::Document before = session.document;
        const base::Status status = apply(command);
        EXPECT_NE(status.message.find("finite"), std::string::npos) << C::kInfo.name << ": " << status.message;
        EXPECT_TRUE(session.document == before) << C::kInfo.name;
      }
    return 0;
  };
  (void)Commands::table(spoiled);
  EXPECT_GT(numbers, 100);
}

// A command derives each segment of the track once; only sections that it plans again are derived as they are planned.
TEST_F(Applying, a_command_derives_the_track_at_most_once) {
  int derived = 0;
  for (int i = 0; i < test::tries(72); ++i) {
    const auto seed = static_cast<std::uint32_t>(i);
    test::RandomCommands random(seed);
    if (i % 3 == 0) circuit();
    else start_on(test::random_document(seed));
    for (int k = 0; k < 40; ++k) {
      Command c = random.of_kind(random.below(Commands::size));
      if (info(c).effect == Effect::session || too_costly(c, random)) continue;
      const auto most = [&] { return session.document.track.segments.size(); };
      const std::size_t before = most();
      session.evaluated = {};
      (void)apply(c);
      std::size_t planned = 0;
      for (const auto& section : session.document.entities.pool<world::Section>().items())
        if (section.kind == world::SectionKind::force) planned = most();
      const auto rebuilds = static_cast<std::size_t>(session.evaluated.rebuilds);
      ASSERT_LE(rebuilds, std::max(before, most()) + planned) << print(c) << " on " << before << " segments";
      derived += session.evaluated.rebuilds > 0;
    }
  }
  EXPECT_GT(derived, test::tries(200));
}

// Whole sessions of any commands, files excepted, with the ride going on: nothing breaks, and the same
// commands give the same state.
RC_GTEST_PROP(apply, any_session_keeps_every_invariant_and_repeats_to_the_bit, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  const auto run = [&] {
    base::Files files;
    Session session = make_session({});
    session.document = test::random_document(seed);
    sim::derive(session.document, session.settings, {}, session.derived);
    RC_ASSERT(apply(session, files, SetDatum{1.5}).ok());
    test::RandomCommands random(seed);
    for (int i = 0; i < 60; ++i) {
      Command c = random.of_kind(random.below(Commands::size));
      if (info(c).effect == Effect::session || too_costly(c, random)) continue;
      apply(session, files, c);
      advance(session, static_cast<int>(random.below(8)));
      RC_ASSERT(world::broken_invariant(session.document) == std::nullopt);
      const world::Entity selected = session.settings.selected;
      RC_ASSERT(!selected.valid() || session.document.entities.alive(selected));
      RC_ASSERT(session.motion.carts.size() == session.document.entities.pool<world::Train>().size());
      for (const world::TrainMotion& cart : session.motion.carts.items()) {
        RC_ASSERT(session.derived.segments.contains(cart.segment));
        RC_ASSERT(std::isfinite(cart.s) && std::isfinite(cart.speed));
        RC_ASSERT(cart.s >= 0 && cart.s <= session.derived.shape(cart.segment).arc.length() + 1e-9);
      }
    }
    return std::pair(world::hash(session.document), world::hash(session.document, session.motion));
  };
  RC_ASSERT(run() == run());
}

TEST_F(Applying, a_drag_on_a_track_of_5000_segments_rebuilds_two) {
  world::Document d;
  for (int i = 0; i <= 5000; ++i)
    world::append_knot(d, test::skew_knot({i * 7.3f, 5 + 3 * std::sin(i * 0.7f), 11 * std::cos(i * 0.3f)},
                                          {1, 0.1f, 0.2f}, 2.3f, 2.3f));
  world::add_cart(d, d.track.segments[17], 0.3);
  session.document = d;
  good("resolution 8");
  good("ride.start");
  good("gesture.begin");
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(apply(MoveKnot{{{world::EntityKind::knot, 2500}}, {18'240.0f, 5 + i * 0.01f, 3.3f}}));
    ASSERT_EQ(session.derived.rebuilds, 2);
  }
  good("gesture.end");
}

}  // namespace apply_test
}  // namespace coaster::edit
