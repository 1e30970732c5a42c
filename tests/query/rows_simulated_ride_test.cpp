// The queries of the ride's design.
#include "edit/session_fixture.h"
#include "query/context.h"
#include "query/query.h"

namespace coaster::query {
namespace rows_simulated_ride_test {

class SimulatedRideRows : public test::SessionTest {
 protected:
  std::string words(std::string_view name) {
    return to_text(*find_query(name)->evaluate({session, stats, "", ""}, {}));
  }
  FrameStats stats;
};

TEST_F(SimulatedRideRows, losses_have_the_name_of_their_set_or_are_own) {
  EXPECT_EQ(words("losses"), "frictionless");
  good("losses rolling 0.03 drag 0.00002");
  EXPECT_EQ(words("losses"), "openfvd");
  good("losses rolling 0.03 drag 0.00003");
  EXPECT_EQ(words("losses"), "own");
  good("losses.set kexedit");
  EXPECT_EQ(words("losses"), "kexedit");
}

}  // namespace rows_simulated_ride_test
}  // namespace coaster::query
