// Commands on the members of the document: name, start speed, datum (edit/perform/track.cpp).
#include <limits>

#include "edit/commands/commands_document.h"
#include "edit/session_fixture.h"

namespace coaster::edit {
namespace perform_document_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class DocumentMembers : public test::SessionTest {};

TEST_F(DocumentMembers, names_are_utf_8_without_control_characters) {
  good("name \"Ünï — 東京 😀\"");
  EXPECT_EQ(session.document.name, "Ünï — 東京 😀");
  for (const char* bad : {"\xff", "a\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80",
                          "\xe0\x80\x80", "a\tb", "\x7f"})
    refused(SetTrackName{bad}, "UTF-8");
  refused(SetTrackName{std::string(201, 'x')}, "limit of 200 bytes");
  EXPECT_TRUE(apply(SetTrackName{std::string(200, 'x')}));
}

// The status bar shows the last notice.
TEST_F(DocumentMembers, a_new_track_has_no_notices_of_the_former_one) {
  clamped("start_speed 151", "limit of 150 m/s");
  const std::uint64_t serial = session.notices.serial;
  good("new");
  EXPECT_TRUE(session.notices.list.empty());
  clamped("start_speed 151", "limit of 150 m/s");
  EXPECT_GT(session.notices.list.back().serial, serial) << "numbers go on";
  good("new");
  EXPECT_FALSE(session.notices.list.empty()) << "there was no track: these are of the program's start";
}

TEST_F(DocumentMembers, start_speed_and_datum_are_clamped) {
  good("start_speed -12.5");
  EXPECT_EQ(session.document.start_speed, -12.5);
  clamped("start_speed 151", "limit of 150 m/s");
  clamped("start_speed -1e9", "limit of -150 m/s");
  clamped("datum 1e6", "limit of 100000 m");
  refused(SetStartSpeed{kNan}, "finite");
  refused(SetDatum{kNan}, "finite");
}

}  // namespace perform_document_test
}  // namespace coaster::edit
