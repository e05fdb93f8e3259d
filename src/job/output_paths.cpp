#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/job/output_paths.hpp>

#include <fmt/format.h>

#include <set>

namespace planish::job {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// In lower case, without what parts words.
std::string letters_and_digits(std::string_view name) {
  std::string letters = lower_case(name);
  std::erase_if(letters, [](char c) { return c > 0 && !is_digit(c) && (c < 'a' || c > 'z'); });
  return letters;
}

std::string letters_of(std::string_view name) {
  std::string letters = letters_and_digits(name);
  std::erase_if(letters, is_digit);
  return letters;
}

}  // namespace

namespace fs = std::filesystem;

Result<void> spare_inputs(const fs::path& output, const std::vector<fs::path>& inputs) {
  for (const fs::path& input : inputs) {
    std::error_code absent;
    if (fs::equivalent(output, input, absent) && !absent)
      return fail(refuse::output_is_input,
                  {{"output", output.string()}, {"input", input.string()}});
  }
  return {};
}

Result<void> folder_exists(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return {};
  return fail(refuse::no_folder, {{"file", file.string()}, {"folder", folder.string()}},
              file.string());
}

Result<void> all_different(const std::vector<fs::path>& outputs) {
  std::set<fs::path> taken;
  for (const fs::path& path : outputs) {
    std::error_code ignored;
    if (!taken.insert(fs::weakly_canonical(fs::absolute(path, ignored), ignored)).second)
      return fail(refuse::two_outputs, {{"file", path.string()}});
  }
  return {};
}

std::string stem_of_input(const fs::path& input) {
  const std::string suffix = lower_case(input.extension().string());
  const fs::path stem = input.stem();
  return (suffix == ".gz" || suffix == ".zip" ? stem.stem() : stem).string();
}

bool is_nameless(std::string_view body) {
  static const std::set<std::string> kNames{
      "body",           "brep",    "bossextrude", "compound", "compsolid", "component",
      "none",           "extrude", "noname",      "pad",      "part",      "partbody",
      "pocket",         "shell",   "solid",       "unnamed",  "solidbody", "manifoldsolidbrep",
      "fusioncomponent"};
  return body.empty() || kNames.contains(letters_of(body)) ||
         body.starts_with("Open CASCADE STEP translator");
}

bool says_nothing(std::string_view body, std::string_view file) {
  return is_nameless(body) ||
         letters_and_digits(file).find(letters_and_digits(body)) != std::string::npos;
}

fs::path name_of_piece(const fs::path& path, int piece, int pieces) {
  if (pieces == 1) return path;
  return path.parent_path() /
         fmt::format("{}-{}{}", path.stem().string(), piece + 1, path.extension().string());
}

}  // namespace planish::job
