#include <planish/base/assert.hpp>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(AssertDeathTest, NamesTheConditionAndItsPlaceAndStops) {
  const auto check = [](int count) { PLANISH_ASSERT(count < 3); };
  check(2);
  EXPECT_EXIT(check(3), testing::KilledBySignal(SIGABRT),
              "planish: assertion failed: count < 3 \\(.*assert_test\\.cpp:[0-9]+\\)");
}

TEST(AssertDeathTest, NamesTheRowAndTheRuleThatItBreaks) {
  EXPECT_EXIT(rule_broken(std::string_view("face 3, loop 0!").substr(0, 14), "loops are closed"),
              testing::KilledBySignal(SIGABRT),
              "planish: rule broken at face 3, loop 0: loops are closed\n");
}

}  // namespace
}  // namespace planish
