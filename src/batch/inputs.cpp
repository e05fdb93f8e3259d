#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/batch/inputs.hpp>
#include <planish/schema/text_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <system_error>

// The files that the words of a command line mean: files, folders, and lists that may name lists.
// Results are sorted and stored by an input's name, its path below the folder or list that led to
// it, so no two may be equal; a file that is named twice counts once. The lists under way are kept,
// so that a list which leads to itself is found. The output may not lie below a folder that is
// read.

namespace planish::batch {
namespace {

namespace fs = std::filesystem;

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

/// Collects the inputs of one command line.
class Collecting {
 public:
  Collecting(const fs::path& out, const job::Catalogue& catalogue)
      : out_(fs::weakly_canonical(out)), catalogue_(catalogue) {}

  /// The reason why a word cannot be taken.
  std::optional<Error> add(const std::string& word, const fs::path& beside) {
    if (word.starts_with('@')) return add_list(beside / word.substr(1));
    const fs::path path = beside / word;
    std::error_code none;
    if (fs::is_directory(path, none)) return add_folder(path);
    if (!fs::is_regular_file(path, none))
      return error_of(refuse::no_file_or_folder, {{"file", path.string()}}, path.string());
    // In a list of many folders the names of files alone may be the same.
    const fs::path below = path.lexically_normal().lexically_relative(beside.lexically_normal());
    const bool is_below = !beside.empty() && !below.empty() && *below.begin() != "..";
    inputs_.push_back({path, is_below ? below.generic_string() : path.filename().string()});
    return std::nullopt;
  }

  Result<std::vector<Input>> finish() {
    std::ranges::sort(inputs_, {}, &Input::name);
    std::vector<Input> inputs;
    std::set<fs::path> taken;
    for (Input& input : inputs_) {
      const bool fresh = taken.insert(fs::absolute(input.file).lexically_normal()).second;
      if (!fresh) continue;
      if (!inputs.empty() && inputs.back().name == input.name)
        return fail(refuse::same_input_name, {{"name", input.name},
                                              {"first", inputs.back().file.string()},
                                              {"second", input.file.string()}});
      inputs.push_back(std::move(input));
    }
    if (inputs.empty()) return fail(refuse::nothing_to_do);
    return inputs;
  }

 private:
  std::optional<Error> add_list(const fs::path& list) {
    std::error_code none;
    const fs::path whole = fs::weakly_canonical(list, none);
    if (std::ranges::find(lists_, whole) != lists_.end())
      return error_of(refuse::list_in_itself, {{"file", list.string()}}, list.string());
    const auto text = schema::read_text(list, "list");
    if (!text) return text.error();
    lists_.push_back(whole);
    std::istringstream lines(*text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())))
        line.pop_back();
      ++number;
      if (line.empty() || line.starts_with('#')) continue;
      auto error = add(line, list.has_parent_path() ? list.parent_path() : ".");
      if (!error) continue;
      if (!line.starts_with('@')) {
        error->message = continued(std::move(error->message));
        error->places.push_back(place::line(number));
        say_before(*error, fmt::format("{}, line {}: ", list.string(), number));
      }
      return error;
    }
    lists_.pop_back();
    return std::nullopt;
  }

  std::optional<Error> add_folder(const fs::path& folder) {
    std::error_code failed;
    const fs::path whole = fs::weakly_canonical(folder, failed);
    const auto [end, rest] = std::ranges::mismatch(whole, out_);
    if (end == whole.end())
      return error_of(refuse::output_in_input,
                      {{"output", out_.string()}, {"folder", folder.string()}}, "output");
    auto entry = fs::recursive_directory_iterator(folder, failed);
    for (; !failed && entry != fs::recursive_directory_iterator(); entry.increment(failed)) {
      if (is_hidden(entry->path())) {
        entry.disable_recursion_pending();
        continue;
      }
      std::error_code none;
      if (entry->is_regular_file(none) && is_input(entry->path()))
        inputs_.push_back(
            {entry->path(), entry->path().lexically_relative(folder).generic_string()});
    }
    if (!failed) return std::nullopt;
    return schema::cannot_read("folder", folder, failed.message());
  }

  bool is_input(const fs::path& file) const {
    const std::string name = lower_case(file.filename().string());
    for (const char* suffix :
         {".step", ".stp", ".stpz", ".step.gz", ".stp.gz", ".step.zip", ".stp.zip"})
      if (name.ends_with(suffix)) return true;
    if (!name.ends_with(".json")) return false;
    const auto input = job::read_input_file(file, "input file");
    return input && catalogue_.maker_for(input->name, input->content);
  }

  fs::path out_;
  const job::Catalogue& catalogue_;
  std::vector<Input> inputs_;
  std::vector<fs::path> lists_;  ///< being read, each named by the one before
};

}  // namespace

Result<std::vector<Input>> inputs_of(const std::vector<std::string>& words, const fs::path& out,
                                     const job::Catalogue& catalogue) {
  Collecting collecting(out, catalogue);
  for (const std::string& word : words)
    if (auto error = collecting.add(word, {})) return tl::unexpected(std::move(*error));
  return collecting.finish();
}

}  // namespace planish::batch
