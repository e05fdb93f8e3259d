#include "work/json_text.hpp"

#include <gtest/gtest.h>

namespace planish::studio {
namespace {

TEST(WithoutIndents, KeepsWhatItSays) {
  const Json json{{"name", "two  spaces,\na line break and a \"quote\""},
                  {"empty", Json::object()},
                  {"rows", {{1.5, -2}, {nullptr, true}}}};
  for (const int indent : {-1, 0, 2, 7}) {
    const std::string text = without_indents(json_text(json, indent) + "\n");
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_EQ(Json::parse(text), json);
    EXPECT_LE(text.size(), json_text(json).size() + 10);  // a space behind each colon
  }
  EXPECT_EQ(without_indents(""), "");
  EXPECT_EQ(without_indents("\n  "), "");
}

}  // namespace
}  // namespace planish::studio
