#include "csv_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace planish::pack {
namespace {

TEST(CsvNumber, HasNoZerosThatSayNothing) {
  EXPECT_EQ(csv_number(2.0), "2");
  EXPECT_EQ(csv_number(0.5), "0.5");
  EXPECT_EQ(csv_number(1000.0), "1000");
  EXPECT_EQ(csv_number(0.0), "0");
  EXPECT_EQ(csv_number(-0.0001), "0") << "no minus before it";
  EXPECT_EQ(csv_number(-1.25), "-1.25");
  EXPECT_EQ(csv_number(std::optional<double>()), "");
  EXPECT_EQ(csv_number(std::optional(0.1)), "0.1");
}

RC_GTEST_PROP(CsvNumber, IsReadBackToAThousandth, (int thousandths)) {
  const double value = thousandths / 1000.0;
  const std::string text = csv_number(value);
  RC_ASSERT(std::abs(std::stod(text) - value) < 1e-9 * std::max(1.0, std::abs(value)));
  RC_ASSERT(text.find('.') == std::string::npos || text.back() != '0');
}

}  // namespace
}  // namespace planish::pack
