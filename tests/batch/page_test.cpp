#include "page.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace planish::batch {
namespace {

PartRecord row_named(const std::string& folder, const std::string& status) {
  PartRecord row;
  row.folder = folder;
  row.status = status;
  return row;
}

/// The data that a page shows.
nlohmann::json data_in(const std::string& page) {
  const std::size_t start = page.find("{\"all\":");
  const std::size_t end = page.find("</script>", start);
  EXPECT_NE(start, std::string::npos);
  return nlohmann::json::parse(page.substr(start, page.rfind('}', end) + 1 - start));
}

TEST(BatchPage, ShowsWhatWasMadeBeforeWhatWasRefused) {
  Page page;
  page.add(row_named("a", "ok"), 0);
  page.add(row_named("b", "refused"), std::nullopt);
  page.add(row_named("c", "warning"), 2);
  page.add(row_named("d", "ok"), 0);
  const auto data = data_in(page.text({}));
  EXPECT_EQ(data["all"], 4);
  EXPECT_EQ(data["copies"], nlohmann::json({2, 0, 1}));
  ASSERT_EQ(data["parts"].size(), 4u);
  std::string order;
  for (const auto& part : data["parts"])
    order += part["name"].get<std::string>();
  EXPECT_EQ(order, "adcb");
  EXPECT_EQ(data["ok"], 2);
  EXPECT_EQ(data["warnings"], 1);
  EXPECT_EQ(data["refused"], 1);
  EXPECT_TRUE(data["parts"][3]["same"].is_null());
  EXPECT_EQ(data["parts"][2]["same"], 2);
}

TEST(BatchPage, HasNumbersAndTexts) {
  PartRecord row = row_named("p/a b", "warning");
  row.quantity = 3;
  row.thickness = 0.5;
  row.length = 10.5;
  row.width = 4.0;
  row.bends = 2;
  row.openings = 1;
  row.material = "S235";
  row.findings = {{"warning", "hem", "the hem is short"}, {"info", "x", "y"}};
  Page page;
  page.add(row, 0);
  auto part = data_in(page.text({}))["parts"][0];
  EXPECT_EQ(part["folder"], "parts/p/a%20b");
  EXPECT_EQ(part["quantity"], 3);
  EXPECT_EQ(part["thickness"], 0.5);
  EXPECT_EQ(part["length"], 10.5);
  EXPECT_EQ(part["width"], 4);
  EXPECT_EQ(part["bends"], 2);
  EXPECT_EQ(part["openings"], 1);
  EXPECT_EQ(part["material"], "S235");
  EXPECT_EQ(part["messages"], nlohmann::json({"The hem is short."})) << "in words";
  row.message = "why";
  row.thickness.reset();
  Page other;
  other.add(row, 0);
  part = data_in(other.text({}))["parts"][0];
  EXPECT_EQ(part["messages"], nlohmann::json({"why"}));
  EXPECT_TRUE(part["thickness"].is_null());
}

TEST(BatchPage, LetsNoNameEndItsScriptOrItsAddress) {
  Page page;
  page.add(row_named("a</script><b>\"'%?#ü", "ok"), 0);
  const std::string text = page.text({});
  const auto part = data_in(text)["parts"][0];
  EXPECT_EQ(part["name"], "a</script><b>\"'%?#ü");
  EXPECT_EQ(part["folder"], "parts/a%3C/script%3E%3Cb%3E%22%27%25%3F%23%C3%BC");
  EXPECT_EQ(text.find("a</script>"), std::string::npos);
}

TEST(BatchPage, TellsWhatWasPassedOver) {
  const PassedOver passed{2, {{"</script>.pdf", "no_input", "no part"}, {"b", "cannot_read", "?"}}};
  const std::string text = Page().text(passed);
  EXPECT_EQ(text.find("</script>.pdf"), std::string::npos);
  const auto told = data_in(text)["passedOver"];
  EXPECT_EQ(told["count"], 2);
  EXPECT_EQ(told["files"][0]["file"], "</script>.pdf");
  EXPECT_EQ(told["files"][0]["why"], "no part");
}

TEST(BatchPage, ShowsNoMoreThanABrowserBears) {
  Page page;
  for (int i = 0; i < 50'000; ++i)
    page.add(row_named("w", "warning"), 0);
  page.add(row_named("r", "refused"), std::nullopt);
  page.add(row_named("o", "ok"), 0);
  const auto data = data_in(page.text({}));
  EXPECT_EQ(data["all"], 50'002);
  EXPECT_EQ(data["parts"].size(), 50'000u);
  EXPECT_EQ(data["parts"].back()["name"], "r");
  EXPECT_EQ(data["copies"][0], 50'001);
}

}  // namespace
}  // namespace planish::batch
