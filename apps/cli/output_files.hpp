#pragma once

#include <planish/base/result.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/artifact.hpp>
#include <planish/job/output_paths.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planish::cli {

using job::all_different, job::folder_exists, job::spare_inputs;

/// A name's last suffix in small letters, ".dxf"; "" for none.
std::string suffix_of(const std::filesystem::path& path);

/// The artifact whose files have a name's suffix (.stp is .step); null if there is none.
const job::Artifact* by_suffix(const std::vector<const job::Artifact*>& artifacts,
                               const std::filesystem::path& path);

/// "part" for part.step; "stdin" for standard input.
std::string stem_of(const std::filesystem::path& input);

/// Whether the value of `-o` is a folder: an existing one, or a name that ends in "/".
bool is_folder(const std::string& output);

/// The files among the values of options: neither empty nor "-".
std::vector<std::filesystem::path> files_named(const std::vector<std::string>& values);

/// All that can be said of one output of a command with one input ("-": standard input) before any
/// work.
Result<void> check_output(const std::filesystem::path& output, const std::string& input);

/// `cannot_write` where a folder is not there and cannot be made, or takes no files.
Result<void> check_folder(const std::filesystem::path& folder);

/// Writes all of them or none, none over one of `inputs`; see `write_files`.
std::optional<Error> write_all(const std::vector<OutputFile>& files,
                               const std::vector<std::filesystem::path>& inputs,
                               const std::function<Result<void>()>& before_they_appear);

/// Adds the paths as reports name them.
void append_names(std::vector<std::string>& names, const std::vector<OutputFile>& files);

}  // namespace planish::cli
