#include "output_files.hpp"

#include <planish/base/text.hpp>
#include <planish/io/flat_writers.hpp>

#include <fmt/format.h>
#include <unistd.h>

namespace planish::cli {

namespace fs = std::filesystem;

std::string suffix_of(const fs::path& path) { return lower_case(path.extension().string()); }

bool is_folder(const std::string& output) {
  std::error_code ignored;
  return (!output.empty() && output.back() == '/') || fs::is_directory(output, ignored);
}

const job::Artifact* by_suffix(const std::vector<const job::Artifact*>& artifacts,
                               const fs::path& path) {
  const std::string suffix = suffix_of(path) == ".stp" ? ".step" : suffix_of(path);
  for (const job::Artifact* artifact : artifacts)
    if (artifact->suffix == suffix) return artifact;
  return nullptr;
}

std::string stem_of(const fs::path& input) {
  return input == "-" ? "stdin" : job::stem_of_input(input);
}

std::vector<fs::path> files_named(const std::vector<std::string>& values) {
  std::vector<fs::path> files;
  for (const std::string& value : values) {
    if (!value.empty() && value != "-") files.emplace_back(value);
  }
  return files;
}

Result<void> check_output(const fs::path& output, const std::string& input) {
  if (input != "-")
    if (auto spared = spare_inputs(output, {input}); !spared) return spared;
  if (auto exists = folder_exists(output); !exists) return exists;
  return check_writable(output);
}

Result<void> check_folder(const fs::path& folder) {
  std::error_code ignored;
  fs::path there = fs::absolute(folder, ignored);
  while (!fs::exists(there, ignored) && there.has_relative_path())
    there = there.parent_path();
  const char* why = !fs::is_directory(there, ignored)        ? "is not a folder"
                    : access(there.c_str(), W_OK | X_OK) < 0 ? "may not be written"
                                                             : nullptr;
  if (!why) return {};
  return cannot_write(folder, fmt::format("{} {}", there.string(), why));
}

std::optional<Error> write_all(const std::vector<OutputFile>& files,
                               const std::vector<fs::path>& inputs,
                               const std::function<Result<void>()>& before_they_appear) {
  for (const OutputFile& file : files) {
    // File names made from bodies are not known when the command line is checked.
    if (auto spared = spare_inputs(file.path, inputs); !spared) return spared.error();
  }
  if (auto written = write_files(files, before_they_appear); !written) return written.error();
  return std::nullopt;
}

void append_names(std::vector<std::string>& names, const std::vector<OutputFile>& files) {
  for (const OutputFile& file : files)
    names.push_back(file.path.string());
}

}  // namespace planish::cli
