#include "support/real_parts.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/unfold.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <set>

// Real parts made by others, listed in tests/corpus/parts.jsonl. Every part unfolds, or is refused
// for its reason; what differs from the parts' labels is named, with its cause, in
// corpus_exceptions.json. Parts that are absent are counted and left out.

namespace planish::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kSource = fs::path(PLANISH_SOURCE_DIR) / "tests/job";
const fs::path kParts = real_parts_folder();

Json read_json(const fs::path& path) {
  std::ifstream stream(path);
  return Json::parse(stream);
}

std::vector<Json> listed_parts() {
  std::vector<Json> rows;
  std::ifstream stream(kSource / "../corpus/parts.jsonl");
  for (std::string line; std::getline(stream, line);)
    rows.push_back(Json::parse(line));
  return rows;
}

fs::path file_of(const Json& row) { return kParts / (row["id"].get<std::string>() + ".step"); }

job::Request request_for(const fs::path& part) {
  job::Request request;
  request.input = part;
  return request;
}

/// None of the parts runs through itself, and all could be tested for it.
void expect_no_self_intersection(const job::Report& report) {
  for (const Finding& finding : report.findings) {
    EXPECT_NE(finding.code, "self_intersection") << finding.message;
    EXPECT_NE(finding.code, "folded_solid") << finding.message;
  }
}

class Corpus : public ::testing::Test {
 protected:
  void SetUp() override {
    listed_ = listed_parts();
    std::copy_if(listed_.begin(), listed_.end(), std::back_inserter(present_),
                 [](const Json& row) { return fs::exists(file_of(row)); });
    if (present_.empty()) GTEST_SKIP() << kNoRealParts;
    if (present_.size() < listed_.size())
      std::cout << present_.size() << " of " << listed_.size() << " real parts are in " << kParts
                << "\n";
    exceptions_ = read_json(kSource / "corpus_exceptions.json");
    folder_ = fs::temp_directory_path() / ("planish-corpus-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Json exception_for(const std::string& id) const { return exceptions_.value(id, Json::object()); }

  void check_pattern(const Json& row, const job::UnfoldReport& report) {
    const std::string id = row["id"];
    const Json exception = exception_for(id);
    const double off = std::abs(*report.certificate.volume_ratio - 1.0);
    const bool strict = row["class"] == "sheet_metal" || row["class"] == "flat_plate";
    if (exception.contains("volume_within")) {
      EXPECT_LE(off, exception["volume_within"].get<double>()) << exception["cause"];
    } else if (strict) {
      EXPECT_LE(off, 1e-3) << "volume ratio " << *report.certificate.volume_ratio;
    }
    if (strict && !row["thickness"].is_null()) {
      EXPECT_NEAR(report.summary.thickness, row["thickness"].get<double>(),
                  0.02 * row["thickness"].get<double>());
    }
    const OpeningCount& openings = report.certificate.openings;
    EXPECT_TRUE(openings.solid) << "the genus of the solid is not known";
    EXPECT_EQ(openings.lost().value_or(0), -exception.value("closed_by_tabs", 0))
        << "solid " << openings.solid.value_or(-1) << ", pattern " << openings.pattern
        << ", features " << openings.features << ", loops " << openings.loops;
    expect_no_self_intersection(report);
    EXPECT_LE(report.certificate.length_error, 0.01);
    EXPECT_LE(report.certificate.refold_deviation, 0.02);
    write_dxf(id, report.flat);
  }

  /// Products that were made: a shop calls about few of them.
  void count_warnings(const Json& row, const job::UnfoldReport& report) {
    if (row["class"] != "sheet_metal" && row["class"] != "flat_plate") return;
    ++made_;
    const bool warned = std::ranges::any_of(report.findings, [](const Finding& finding) {
      return finding.severity == Severity::warning && !finding.places.empty();
    });
    if (warned) ++warned_;
  }

  void write_dxf(const std::string& id, const FlatPattern& flat) {
    const auto text = dxf_text(flat);
    ASSERT_TRUE(text) << text.error().message;
    const fs::path path = folder_ / (id + ".dxf");
    ASSERT_TRUE(write_file(path, *text));
    std::ofstream(folder_ / "list.tsv", std::ios::app)
        << path.string() << '\t' << std::setprecision(17) << flat.area << "\t1e-4\t"
        << length(flat.slits) << '\n';
  }

  void check_refusal(const Json& row, const Error& refusal) {
    const Json exception = exception_for(row["id"]);
    static const std::map<std::string, std::set<std::string>> kCodes{
        {"tube", {"closed_loop", "doubly_curved", "thickness_not_constant"}},
        {"closed_corner", {"closed_loop", "doubly_curved"}},
        {"not_sheet",
         {"not_a_sheet", "thickness_not_constant", "doubly_curved", "closed_loop", "overlap"}}};
    const std::string code(code_name(refusal.code));
    EXPECT_FALSE(refusal.message.empty());
    EXPECT_EQ(exit_status(refusal.code), 4) << code << ": " << refusal.message;
    if (exception.contains("refused"))
      EXPECT_EQ(code, exception["refused"]) << refusal.message;
    else if (const auto codes = kCodes.find(row["class"]); codes != kCodes.end())
      EXPECT_TRUE(codes->second.count(code)) << code << ": " << refusal.message;
    else
      ADD_FAILURE() << "refused without a named cause: " << code << ": " << refusal.message;
  }

  void check_part(const Json& row) {
    const std::string id = row["id"];
    const auto report = job::unfold(request_for(file_of(row)));
    const Json exception = exception_for(id);
    const bool must_refuse = row["class"] == "tube" || row["class"] == "closed_corner" ||
                             row["class"] == "not_sheet";
    if (!report) {
      check_refusal(row, report.error());
    } else {
      EXPECT_TRUE(!must_refuse || exception.value("unfolds", false))
          << "unfolded, but is labelled " << row["class"];
      EXPECT_FALSE(exception.contains("refused")) << "unfolds now: take it off the list";
      check_pattern(row, *report);
      count_warnings(row, *report);
    }
  }

  std::vector<Json> listed_, present_;
  Json exceptions_;
  fs::path folder_;
  int made_ = 0, warned_ = 0;
};

TEST_F(Corpus, EveryBodyUnfoldsOrIsRefusedForItsReasonAndEveryDxfReadsBack) {
  int parts = 0;
  for (const Json& row : present_) {
    if (row["class"] == "assembly") continue;
    SCOPED_TRACE(row["id"].get<std::string>());
    check_part(row);
    ++parts;
  }
  if (present_.size() == listed_.size()) {
    EXPECT_GT(parts, 150);
    EXPECT_LE(4 * warned_, made_) << warned_ << " of " << made_ << " carry a warning of a rule";
  }
  const std::string check = "/usr/bin/python3 '" + (kSource / "../../tools/check_dxf.py").string() +
                            "' --list '" + (folder_ / "list.tsv").string() + "' > '" +
                            (folder_ / "dxf.json").string() + "'";
  EXPECT_EQ(std::system(check.c_str()), 0)
      << read_json(folder_ / "dxf.json").dump(1).substr(0, 4000);
}

TEST_F(Corpus, AssembliesComeApartAndHoldTheSheetsThatTheyAreKnownToHold) {
  for (const Json& row : present_) {
    if (row["class"] != "assembly") continue;
    SCOPED_TRACE(row["id"].get<std::string>());
    const auto bodies = job::unfold_all(request_for(file_of(row)));
    ASSERT_TRUE(bodies) << bodies.error().message;
    EXPECT_GE(bodies->size(), 1u);
    for (const auto& body : *bodies) {
      ASSERT_TRUE(body || body.error().shown);
      expect_no_self_intersection(body ? *body : *body.error().shown);
      if (!body) {
        EXPECT_NE(body.error().code, code::internal) << body.error().message;
        EXPECT_FALSE(body.error().message.empty());
      }
    }
    for (const Json& known : listed_) {
      const bool member = known["class"] == "sheet_metal" &&
                          known["repository"] == row["repository"] && known["path"] == row["path"];
      if (!member || exception_for(known["id"]).contains("refused")) continue;
      const bool found = std::ranges::any_of(*bodies, [&](const auto& body) {
        return body && std::abs(body->summary.volume - known["volume"].get<double>()) <
                           1e-3 * body->summary.volume;
      });
      EXPECT_TRUE(found) << "the sheet " << known["id"] << " did not unfold out of the assembly";
    }
  }
}

}  // namespace
}  // namespace planish::test
