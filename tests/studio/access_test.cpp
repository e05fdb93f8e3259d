#include "server/access.hpp"

#include <gtest/gtest.h>

namespace planish::studio {
namespace {

TEST(Tokens, AreLongAndNew) {
  const auto one = random_token(), other = random_token();
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->size(), 32U);
  EXPECT_EQ(one->find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(*one, *other);
}

TEST(Secrets, AreTheSameOnlyWhenAllIs) {
  EXPECT_TRUE(same_secret("abcd", "abcd"));
  for (const char* wrong : {"", "a", "abc", "abcde", "abcdabcd", "abce", "bbcd"})
    EXPECT_FALSE(same_secret(wrong, "abcd")) << wrong;
}

TEST(Access, IsForThisMachinesNames) {
  const Access access(8731, "secret");
  EXPECT_FALSE(access.refusal({{"127.0.0.1:8731"}, {}, {"secret"}}));
  EXPECT_FALSE(access.refusal({{"localhost:8731"}, {"http://localhost:8731"}, {"secret"}}));
  EXPECT_TRUE(access.refusal({{}, {}, {"secret"}}));
  EXPECT_TRUE(access.refusal({{"127.0.0.1:8731", "127.0.0.1:8731"}, {}, {"secret"}}));
  EXPECT_TRUE(access.refusal({{"evil:8731"}, {}, {"secret"}}));
  EXPECT_TRUE(access.refusal({{"127.0.0.1:8731"}, {"http://evil:8731"}, {"secret"}}));
  EXPECT_TRUE(access.refusal({{"127.0.0.1:8731"}, {}, {}}));
  EXPECT_TRUE(access.refusal({{"127.0.0.1:8731"}, {}, {"secret", "secret"}}));
  EXPECT_FALSE(access.host_refusal({{"127.0.0.1:8731"}, {}, {}}));
}

}  // namespace
}  // namespace planish::studio
