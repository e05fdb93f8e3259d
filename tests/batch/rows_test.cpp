#include "rows.hpp"

#include <planish/sheet/csv.hpp>

#include <gtest/gtest.h>

namespace planish::batch {
namespace {

/// The cells of a row by their titles, as a reader of CSV has them.
std::map<std::string, std::string> cells_of(const Row& row) {
  const auto records = split_csv(csv_titles() + csv_of(row), "summary.csv");
  EXPECT_TRUE(records);
  EXPECT_EQ(records->size(), 2u);
  std::map<std::string, std::string> cells;
  for (std::size_t i = 0; i < (*records)[0].fields.size(); ++i)
    cells[(*records)[0].fields[i]] = (*records)[1].fields.at(i);
  return cells;
}

TEST(Rows, HaveWhatTheReportHas) {
  auto cells = cells_of(row_of("p/door", R"({"input": "p.step", "body": "door, left", "quantity": 3,
      "status": "warning", "reason": null, "units": "inch", "material": "S235",
      "sheet": {"thickness": 0.5, "bends": 2, "mass": 1.25},
      "flat": {"size": [10.5, 4.0], "area": 40.0, "cutting": {"outer": 29.0, "inner": 3.5},
               "openings": 1},
      "verification": {"volume_ratio": 0.999},
      "checks": [{"code": "hem", "severity": "info"}, {"code": "k_factor", "severity": "warning"},
                 {"code": "overlap", "severity": "error"},
                 {"code": "k_factor", "severity": "warning"}],
      "files": ["p/door.dxf", "p/door.svg"]})"));
  const std::map<std::string, std::string> expected{{"input", "p.step"},
                                                    {"body", "door, left"},
                                                    {"quantity", "3"},
                                                    {"status", "warning"},
                                                    {"reason", ""},
                                                    {"message", ""},
                                                    {"units", "inch"},
                                                    {"thickness", "0.5"},
                                                    {"length", "10.5"},
                                                    {"width", "4.0"},
                                                    {"area", "40.0"},
                                                    {"outer_cutting", "29.0"},
                                                    {"inner_cutting", "3.5"},
                                                    {"openings", "1"},
                                                    {"bends", "2"},
                                                    {"mass", "1.25"},
                                                    {"volume_ratio", "0.999"},
                                                    {"warnings", "3"},
                                                    {"files", "p/door.dxf;p/door.svg"},
                                                    {"same_as", ""},
                                                    {"material", "S235"}};
  EXPECT_EQ(cells, expected);
}

TEST(Rows, AreEmptyWhereNothingIsKnown) {
  const Row row = row_of("p",
                         R"({"status": "refused", "reason": {"code": "overlap", "message": "m"},
                                  "sheet": null, "flat": null})");
  EXPECT_EQ(row.folder, "p");
  EXPECT_EQ(row.reason, "overlap");
  EXPECT_EQ(row.message, "m");
  auto cells = cells_of(row);
  for (const char* empty : {"thickness", "length", "area", "bends", "mass", "files", "body"})
    EXPECT_EQ(cells.at(empty), "") << empty;
  EXPECT_EQ(cells.at("warnings"), "0");
}

TEST(Rows, NameEachFindingOnce) {
  const Row row = row_of("p", R"({"checks": [{"code": "b", "severity": "warning"},
      {"code": "a", "severity": "error"}, {"code": "b", "severity": "warning"},
      {"code": "c", "severity": "info"}]})");
  EXPECT_EQ(row.findings, "a, b");
}

}  // namespace
}  // namespace planish::batch
