#include "job/sample_reports.hpp"

#include <planish/job/outputs.hpp>
#include <planish/sheet/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::job {
namespace {

using test::sample_report;
using ::testing::ElementsAre;

UnfoldReport named(const std::string& body, double thickness) {
  UnfoldReport report = sample_report();
  report.body = body;
  report.summary.thickness = thickness;
  return report;
}

TEST(SafeName, KeepsLettersDigitsAndAFewSigns) {
  EXPECT_EQ(safe_name("Door_2-left.v1"), "Door_2-left.v1");
  EXPECT_EQ(safe_name("Träger Ø8"), "Träger_Ø8");
  EXPECT_EQ(safe_name("板金"), "板金");
}

TEST(SafeName, LeavesNothingThatAFileSystemOrShellMinds) {
  EXPECT_EQ(safe_name("a/b\\c:d*e?f\"g<h>i|j"), "a_b_c_d_e_f_g_h_i_j");
  EXPECT_EQ(safe_name("../../etc/passwd"), "_.._etc_passwd");
  EXPECT_EQ(safe_name("-rf"), "rf");
  EXPECT_EQ(safe_name(".hidden"), "hidden");
  EXPECT_EQ(safe_name("name. "), "name");
  EXPECT_EQ(safe_name("new\nline\tand\033[31m"), "new_line_and_31m");
  EXPECT_EQ(safe_name("\u202Egpj.exe"), "_gpj.exe");
  EXPECT_EQ(safe_name("tr\xE4ger"), "tr_ger");
  EXPECT_EQ(safe_name(""), "body");
  EXPECT_EQ(safe_name("///"), "body");
}

TEST(SafeName, CutsLongNamesBetweenLetters) {
  std::string name;
  for (int i = 0; i < 80; ++i)
    name += "é";
  const std::string safe = safe_name(name);
  EXPECT_EQ(safe.size(), 100u);
  EXPECT_EQ(safe, name.substr(0, 100));
}

TEST(Stems, HoldNameAndThickness) {
  EXPECT_THAT(stems({named("door", 2.0), named("door", 1.5), named("lid", 0.978)}),
              ElementsAre("door_t2", "door_t1.5", "lid_t0.978"));
}

TEST(Stems, DifferAlsoWhereCapitalsCountAsSmallLetters) {
  EXPECT_THAT(
      stems({named("door", 2.0), named("Door", 2.0), named("do/or", 2.0), named("do?or", 2.0)}),
      ElementsAre("door_t2", "Door_t2-2", "do_or_t2", "do_or_t2-2"));
}

TEST(Stems, SkipBodiesWithoutPattern) {
  UnfoldReport refused = named("door", 2.0);
  refused.refusal = Error{code::overlap, "covers itself", ""};
  EXPECT_THAT(stems({refused, named("door", 2.0)}), ElementsAre("", "door_t2"));
}

}  // namespace
}  // namespace planish::job
