// The encoder of movies outside a page.
#include "platform/system.h"

#include <gtest/gtest.h>

namespace coaster::platform {
namespace encoder_test {

TEST(encoder, only_a_page_has_one) {
  EXPECT_FALSE(BrowserEncoder::in_page());
  const auto started = BrowserEncoder::start(30);
  ASSERT_FALSE(started.ok());
  EXPECT_EQ(started.status().code, base::Code::refused);
}

}  // namespace encoder_test
}  // namespace coaster::platform
