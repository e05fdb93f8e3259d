#pragma once

#include <planish/base/result.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace planish::job {

/// `bad_option` when `output` is one of `inputs`, under whatever name.
Result<void> spare_inputs(const std::filesystem::path& output,
                          const std::vector<std::filesystem::path>& inputs);

/// `cannot_write` if the folder of the file does not exist: reported before the work rather than
/// after it.
Result<void> folder_exists(const std::filesystem::path& file);

/// `bad_option` for two outputs with one name, of which only the last would remain.
Result<void> all_different(const std::vector<std::filesystem::path>& outputs);

/// What files made of an input are called: "part" for part.step, part.step.gz and part.stp.zip.
std::string stem_of_input(const std::filesystem::path& input);

/// Whether a body has no name, or one that programs give to any: "SOLID", "Body 2".
bool is_nameless(std::string_view body);
/// Whether the name of a body says no more than that of its file, which may hold it.
bool says_nothing(std::string_view body, std::string_view file);

/// net.dxf; for several pieces net-1.dxf, net-2.dxf, …; `piece` counts from 0.
std::filesystem::path name_of_piece(const std::filesystem::path& path, int piece, int pieces);

}  // namespace planish::job
