// Flat patterns of real parts on sheets, judged by GEOS on their exact contours.
#include "support/nesting_check.hpp"
#include "support/real_parts.hpp"

#include <planish/job/unfold.hpp>
#include <planish/nest/nest.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace planish {
namespace {

/// The flat patterns of every fifth file.
std::vector<FlatPattern> real_patterns() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(test::real_parts_folder()))
    if (entry.path().extension() == ".step" || entry.path().extension() == ".stp")
      files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<FlatPattern> patterns;
  constexpr std::size_t kEach = 5;
  for (std::size_t i = 0; i < files.size(); i += kEach) {
    job::Request request;
    request.input = files[i];
    request.effort = job::Effort::draft;
    const auto bodies = job::unfold_all(request);
    if (!bodies) continue;
    for (const auto& body : *bodies)
      if (body) patterns.push_back(body->flat);
  }
  return patterns;
}

TEST(NestOfRealParts, KeepsGapMarginAndQuantities) {
  if (!std::filesystem::is_directory(test::real_parts_folder())) GTEST_SKIP() << test::kNoRealParts;
  const std::vector<FlatPattern> patterns = real_patterns();
  ASSERT_GE(patterns.size(), 20u);
  std::vector<NestPart> parts;
  for (std::size_t i = 0; i < patterns.size(); ++i)
    parts.push_back({&patterns[i], 1 + static_cast<int>(i % 4)});
  for (const NestOptions& options :
       {NestOptions{}, NestOptions{.length = 2000, .width = 1000, .gap = 3, .grain = true},
        NestOptions{.length = 1000, .width = 500, .gap = 0, .margin = 8}}) {
    const auto nesting = nest(parts, options);
    ASSERT_TRUE(nesting) << nesting.error().message;
    EXPECT_FALSE(nesting->sheets.empty());
    test::expect_sound(*nesting, parts, options);
  }
}

}  // namespace
}  // namespace planish
