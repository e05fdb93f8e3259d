#include "dxf_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish {
namespace {

using namespace io_detail;

std::string written(double value) {
  const DxfWriter writer(DxfVersion::r2000);
  writer.dxfReal(10, value);
  return writer.text();
}

TEST(DxfWriter, WritesRealsThatReadBackWithoutExponent) {
  EXPECT_EQ(written(12.5), " 10\n12.5\n");
  EXPECT_EQ(written(-3.0), " 10\n-3.0\n");
  for (const double value : {0.1, 1e20 / 3.0, -1e-9 / 7.0, std::nextafter(1.0, 2.0)}) {
    const std::string text = written(value).substr(4);
    EXPECT_EQ(text.find('e'), std::string::npos) << text;
    EXPECT_EQ(std::stod(text), value);
  }
}

TEST(DxfWriter, WritesWhatRoundingLeavesAsZero) {
  EXPECT_EQ(written(9e-16), " 10\n0.0\n");
  EXPECT_EQ(written(-9e-16), " 10\n0.0\n");
}

TEST(DxfWriter, PutsCodesInThreeColumnsAndLeavesOutComments) {
  const DxfWriter writer(DxfVersion::r12);
  writer.dxfInt(5, 7);
  writer.dxfHex(330, 255);
  writer.dxfString(999, "dxflib 3.26");
  writer.dxfString(8, std::string("0"));
  EXPECT_EQ(writer.text(), "  5\n7\n330\nFF\n  8\n0\n");
  EXPECT_TRUE(writer.r12());
  EXPECT_FALSE(DxfWriter(DxfVersion::r2000).r12());
}

}  // namespace
}  // namespace planish
