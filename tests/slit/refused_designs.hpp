#pragma once

#include "sample_sheets.hpp"
#include "support/error_data.hpp"

#include <planish/slit/codes.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace planish::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The refusal of a design, with its code, its place in the file and what its message says.
inline void expect_refused(const SlitDesign& design, ErrorCode code, const std::string& where,
                           const std::string& in_message = "") {
  const auto session = SlitSession::start(design);
  ASSERT_FALSE(session) << "started, but " << code_name(code) << " was due at " << where;
  EXPECT_EQ(code_name(session.error().code), code_name(code)) << session.error().message;
  EXPECT_EQ(session.error().where, where) << session.error().message;
  EXPECT_NE(session.error().message.find(in_message), std::string::npos) << session.error().message;
  EXPECT_TRUE(is_told(session.error())) << session.error().message;
  EXPECT_FALSE(pointers_in(session.error()).empty()) << session.error().message;
}

template <typename Change>
void expect_chair_refused(const Change& change, ErrorCode code, const std::string& where,
                          const std::string& in_message = "") {
  SlitDesign design = chair();
  change(design);
  expect_refused(design, code, where, in_message);
}

}  // namespace planish::test
