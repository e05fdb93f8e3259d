#include "support/real_parts.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/unfold.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

// Real parts that are drawn closed: a refusal names a rip where rips lead to a pattern, and
// otherwise says at once what no rip changes.

namespace planish::test {
namespace {

namespace fs = std::filesystem;

struct ClosedPart {
  std::string id;
  std::size_t rips = 0;    ///< that open it; 0: none do
  std::string after = {};  ///< the reason if none do
  std::string body = {};
};

const std::vector<ClosedPart> kClosedParts{
    {"sm031_voron_Lift-Off-Tophat-Hinges", 5},
    {"asm020_voron_Lift-Off-Tophat-Hinges", 5, "", "2"},
    {"tube002_FreeCAD-librar_Extended-retangular-bend", 0, "covers itself"},
    {"neg027_occt-import-js_MAINBODY-BACK", 0, "No rips along its edges"},
    {"neg039_Original-Prusa_psu-cover-DELTA", 0, "No rips along its edges"},
    {"sharp012_FreeCAD-librar_SAE380-80-2", 0, "No rips along its edges"},
    {"cc001_FreeCAD-librar_cup", 0, "curved in two directions"},
    {"tube028_zynthian-hw_RS-234", 0, "curved in two directions"},
    {"cc004", 0, "beyond the sheet"},
    {"neg008", 0, "one skin only"},
    {"neg028", 0, "curved in two directions"},
    {"neg056", 0, "curved in two directions"},
    {"neg087", 0, "mm thick"},
    {"asm032", 0, "beyond the sheet", "4"},
};

/// The file whose name begins so.
fs::path file_of_part(const std::string& id) {
  if (fs::exists(real_parts_folder()))
    for (const auto& entry : fs::directory_iterator(real_parts_folder()))
      if (entry.path().filename().string().starts_with(id)) return entry.path();
  return {};
}

/// Rips what each refusal names, until there is a pattern or a refusal that names none.
void follow(const ClosedPart& part, const fs::path& file) {
  job::Request request;
  request.input = file;
  request.body = part.body;
  for (std::size_t done = 0; done <= part.rips; ++done) {
    const auto report = job::unfold(request);
    if (report) {
      EXPECT_EQ(done, part.rips);
      EXPECT_GT(report->flat.area, 0.0);
      return;
    }
    const Error& refusal = report.error();
    ASSERT_TRUE(report.error().shown) << refusal.message;
    std::smatch named;
    const bool names = refusal.code == code::closed_loop &&
                       std::regex_search(refusal.where, named, std::regex("^edge (\\d+) "));
    if (part.rips == 0) {
      EXPECT_FALSE(names) << refusal.message;
      EXPECT_TRUE(refusal.remedies.empty()) << refusal.message;
      EXPECT_NE(refusal.message.find(part.after), std::string::npos) << refusal.message;
      return;
    }
    ASSERT_TRUE(names) << refusal.message;
    ASSERT_EQ(refusal.remedies.size(), 1u);
    EXPECT_EQ(refusal.remedies[0].option, "rip_edges");
    request.rip_edges.push_back(std::stoi(named[1]));
  }
  ADD_FAILURE() << "more rips were named than open the part";
}

TEST(RipsOfParts, LeadToAPatternOrAreNotNamed) {
  int present = 0;
  for (const ClosedPart& part : kClosedParts) {
    const fs::path file = file_of_part(part.id);
    if (file.empty()) continue;
    SCOPED_TRACE(part.id);
    follow(part, file);
    ++present;
  }
  if (present == 0) GTEST_SKIP() << kNoRealParts;
}

}  // namespace
}  // namespace planish::test
