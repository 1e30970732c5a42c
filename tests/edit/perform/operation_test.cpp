// Losses by number and by named set.
#include "edit/commands/commands_operation.h"
#include "edit/session_fixture.h"

namespace coaster::edit {
namespace perform_operation_test {

class Losses : public test::SessionTest {
 protected:
  const world::Losses& now() const { return session.document.resistance; }
};

TEST_F(Losses, a_set_replaces_both_numbers_in_one_step_of_undo) {
  good("losses rolling 0.5 drag 0.01");
  good("losses.set openfvd");
  EXPECT_EQ(now(), (world::Losses{0.03f, 2e-5f}));
  good("losses.set kexedit");
  EXPECT_EQ(now(), (world::Losses{0.021f, 2e-5f}));
  good("losses.set frictionless");
  EXPECT_EQ(now(), world::Losses{});
  for (const world::Losses before : {world::Losses{0.021f, 2e-5f}, {0.03f, 2e-5f}, {0.5f, 0.01f}}) {
    good("undo");
    EXPECT_EQ(now(), before);
  }
}

TEST_F(Losses, a_set_is_written_by_its_name_and_no_other_word_is_one) {
  EXPECT_EQ(print(Command{SetLossSet{world::LossSet::kexedit}}), "losses.set kexedit");
  std::vector<base::Token> tokens;
  base::TextError error;
  ASSERT_TRUE(base::tokenise("losses.set own", tokens, error));
  EXPECT_FALSE(parse(tokens, error).ok());
  EXPECT_NE(error.message.find("expected frictionless|openfvd|kexedit"), std::string::npos) << error.message;
}

}  // namespace perform_operation_test
}  // namespace coaster::edit
