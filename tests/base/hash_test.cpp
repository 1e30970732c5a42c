#include "base/hash.h"

#include <gtest/gtest.h>

namespace coaster::base {
namespace hash_test {

TEST(hash, equal_values_hash_equal_and_minus_zero_counts_as_zero) {
  Hasher a, b, c;
  a.add(0.0f), a.add(glm::vec3(1, -0.0f, 3));
  b.add(-0.0f), b.add(glm::vec3(1, 0, 3));
  c.add(0.0f), c.add(glm::vec3(1, 3, 0));
  EXPECT_EQ(a.digest(), b.digest());
  EXPECT_NE(a.digest(), c.digest());
}

TEST(hash, the_numbers_are_fixed) {
  // XXH64 with seed 0 of no bytes, from the algorithm's specification.
  EXPECT_EQ(hex16(Hasher().digest()), "ef46db3751d8e999");
  Hasher text;
  text.bytes("abc", 3);
  EXPECT_EQ(hex16(text.digest()), "44bc2cf5ad770999");
}

TEST(hash, texts_do_not_run_into_each_other) {
  Hasher a, b;
  a.add(std::string_view("ab")), a.add(std::string_view("c"));
  b.add(std::string_view("a")), b.add(std::string_view("bc"));
  EXPECT_NE(a.digest(), b.digest());
}

}  // namespace hash_test
}  // namespace coaster::base
