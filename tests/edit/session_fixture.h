// A session on a track for tests of commands, with short functions to apply commands by their text.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "edit/commands/codec.h"
#include "edit/perform/apply.h"
#include "edit/session/session.h"
#include "exchange/own/track_file.h"
#include "world/sample_documents.h"

namespace coaster::test {

inline edit::Command command_of(const std::string& line) {
  std::vector<base::Token> tokens;
  base::TextError error;
  EXPECT_TRUE(base::tokenise(line, tokens, error)) << line;
  const auto parsed = edit::parse(tokens, error);
  EXPECT_TRUE(parsed) << line << ": " << error.message;
  return parsed ? *parsed : edit::Command{};
}

class SessionTest : public testing::Test {
 protected:
  // Starts on `document` as if it had been loaded.
  explicit SessionTest(const world::Document& document = sample_document()) : session(edit::make_session({})) {
    start_on(document);
  }
  void start_on(const world::Document& document) {
    session.history = {};
    session.settings = {};
    session.motion = {};
    session.document = document;
    session.file.saved_hash = world::hash(document);
    sim::derive(session.document, session.settings, {}, session.derived);
    sim::reset(session.document, session.derived, session.motion);
  }

  static edit::Command command(const std::string& line) { return command_of(line); }
  base::Status apply(const edit::Command& c, edit::ClosingSearch* search = nullptr) {
    return edit::apply(session, files, c, search);
  }
  base::Status apply(const std::string& line, edit::ClosingSearch* search = nullptr) {
    return apply(command(line), search);
  }
  void good(const std::string& line) {
    const base::Status status = apply(line);
    EXPECT_TRUE(status) << line << ": " << status.message;
    EXPECT_EQ(world::broken_invariant(session.document), std::nullopt) << line;
  }
  // Builds a circuit: a station, a lift, a drop, a loop, a camelback, a turn home and brakes.
  void circuit() {
    start_on(world::Document{});
    for (const char* const line :
         {"element straight length 30 equipment station", "element climb height 25 equipment lift",
          "element dive height 22", "element loop left height 15", "element camelback height 10 speed 19",
          "element curve left radius 30 angle 180 bank 50", "element straight length 40 equipment brake speed 8",
          "complete 1"})
      good(line);
  }
  // Expects that the command is refused with a notice, and that nothing else has changed.
  void refused(const edit::Command& c, std::string_view part) {
    const world::Document document = session.document;
    const world::Settings settings = session.settings;
    const world::Motion motion = session.motion;
    const std::size_t undo = session.history.undo.size(), redo = session.history.redo.size();
    const std::uint64_t serial = session.notices.serial;
    const base::Status status = apply(c);
    EXPECT_EQ(status.code, base::Code::refused);
    EXPECT_NE(status.message.find(part), std::string::npos) << status.message;
    EXPECT_TRUE(session.document == document && session.settings == settings && session.motion == motion);
    EXPECT_EQ(session.history.undo.size(), undo);
    EXPECT_EQ(session.history.redo.size(), redo);
    EXPECT_EQ(session.notices.serial, serial + 1);
    EXPECT_EQ(session.notices.list.back().kind, edit::NoticeKind::error);
  }
  void refused(const std::string& line, std::string_view part) { refused(command(line), part); }
  // Expects that the command is applied with a warning about a limit.
  void clamped(const std::string& line, std::string_view part) {
    const std::uint64_t serial = session.notices.serial;
    good(line);
    ASSERT_GT(session.notices.serial, serial) << line;
    const edit::Notice& notice = session.notices.list.back();
    EXPECT_EQ(notice.kind, edit::NoticeKind::warning) << line;
    EXPECT_NE(notice.text.find("limit"), std::string::npos) << notice.text;
    EXPECT_NE(notice.text.find(part), std::string::npos) << notice.text;
  }

  const world::Knot& knot(std::uint32_t number) const {
    return world::knot(session.document, world::find(session.document, {world::EntityKind::knot, number}));
  }
  world::Entity entity(const char* name) const { return world::find(session.document, *world::parse_name(name)); }
  std::uint64_t hash() const { return world::hash(session.document); }

  edit::Session session;
  base::Files files;
};

}  // namespace coaster::test
