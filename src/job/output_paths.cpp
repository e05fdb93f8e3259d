#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/job/output_paths.hpp>

#include <fmt/format.h>

#include <set>

namespace planish::job {

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

fs::path name_of_piece(const fs::path& path, int piece, int pieces) {
  if (pieces == 1) return path;
  return path.parent_path() /
         fmt::format("{}-{}{}", path.stem().string(), piece + 1, path.extension().string());
}

}  // namespace planish::job
