#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/batch/codes.hpp>
#include <planish/batch/inputs.hpp>
#include <planish/brep/step_archive.hpp>
#include <planish/schema/text_file.hpp>
#include <planish/shop/part_materials.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <system_error>

// The files that the words of a command line mean: files, folders, and lists that may name lists.
// Results are sorted and stored by an input's name, its path below the folder or list that led to
// it, so no two may be equal; a file that is named twice counts once. The lists under way are kept,
// so that a list which leads to itself is found. The output may not lie below a folder that is
// read. A folder is gone through by hand, so one below it that cannot be read costs only itself.

namespace planish::batch {
namespace {

namespace fs = std::filesystem;

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

/// How often everything that a word means is wanted, and who says so.
struct Wanted {
  int copies = 1;
  std::string said_by = {};
};

/// A line of a list, "part.step x20".
struct ListLine {
  std::string word;
  std::string times = {};  ///< "20"; empty: the line does not say
};

std::string trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t first = std::min(text.find_first_not_of(kBlanks), text.size());
  return std::string(text.substr(first, text.find_last_not_of(kBlanks) + 1 - first));
}

/// The quantity that the last word of a line is: "20" of "x20" and "×20".
std::string times_in(std::string word) {
  constexpr std::string_view kSign = "×";
  if (word.starts_with(kSign)) word.replace(0, kSign.size(), "x");
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto counts = [&](char c) { return is_digit(c) || c == '.' || c == ','; };
  const bool times = word.size() > 1 && (word[0] == 'x' || word[0] == 'X') && is_digit(word[1]) &&
                     std::all_of(word.begin() + 1, word.end(), counts);
  return times ? word.substr(1) : "";
}

/// A name, in quotes if wanted, and the quantity behind it.
ListLine counted_line(std::string text) {
  ListLine line;
  const std::size_t blank = text.find_last_of(" \t");
  if (blank != std::string::npos) line.times = times_in(text.substr(blank + 1));
  if (!line.times.empty()) text = trimmed(text.substr(0, blank));
  const bool quoted = text.size() > 2 && text.front() == '"' && text.back() == '"';
  line.word = quoted ? text.substr(1, text.size() - 2) : text;
  return line;
}

std::string without_comment(const std::string& text) {
  for (std::size_t at = 1; at < text.size(); ++at)
    if (text[at] == '#' && (text[at - 1] == ' ' || text[at - 1] == '\t'))
      return trimmed(text.substr(0, at));
  return text;
}

/// Reads a line. Names may hold blanks, "#", and what looks like a quantity: what `is_file` knows
/// is taken whole.
ListLine line_of(const std::string& text, const std::function<bool(const std::string&)>& is_file) {
  ListLine line;
  for (const std::string& one : {text, without_comment(text)}) {
    if (is_file(one)) return {one};
    line = counted_line(one);
    if (is_file(line.word)) break;
  }
  return line;
}

/// The lines of a text, in whichever way they end.
std::vector<std::string> lines_of(std::string_view text) {
  const char end = text.find('\n') == std::string_view::npos ? '\r' : '\n';
  std::vector<std::string> lines;
  for (text = without_byte_order_mark(text); !text.empty();) {
    const std::size_t length = std::min(text.find(end), text.size());
    lines.push_back(trimmed(text.substr(0, length)));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return lines;
}

std::optional<int> copies_in(const std::string& times) {
  int copies = 0;
  const char* end = times.data() + times.size();
  const auto [stop, error] = std::from_chars(times.data(), end, copies);
  if (error != std::errc() || stop != end || copies < 1 || copies > shop::kMostPieces)
    return std::nullopt;
  return copies;
}

/// Collects the inputs of one command line.
class Collecting {
 public:
  Collecting(const fs::path& out, const job::Catalogue& catalogue)
      : out_(fs::weakly_canonical(out)), catalogue_(catalogue) {}

  /// The reason why a word cannot be taken.
  std::optional<Error> add(const std::string& word, const fs::path& beside,
                           const Wanted& wanted = {}) {
    if (word.starts_with('@')) return add_list(beside / word.substr(1), wanted);
    const fs::path path = beside / word;
    std::error_code none;
    if (fs::is_directory(path, none)) return add_folder(path, wanted);
    if (!is_file(path)) return no_file(path, beside);
    // In a list of many folders the names of files alone may be the same.
    const fs::path below = path.lexically_normal().lexically_relative(beside.lexically_normal());
    const bool is_below = !beside.empty() && !below.empty() && *below.begin() != "..";
    take_all(path, is_below ? below.generic_string() : path.filename().string(), wanted);
    return std::nullopt;
  }

  Result<Inputs> finish() {
    std::ranges::stable_sort(inputs_, {}, &Input::name);
    Inputs found;
    std::map<fs::path, std::size_t> taken;
    for (Input& input : inputs_) {
      const auto [before, fresh] = taken.emplace(fs::absolute(input.file).lexically_normal(),
                                                 found.files.size());
      if (!fresh) {
        const Input& first = found.files[before->second];
        if (first.said_by != input.said_by || first.copies != input.copies)
          return counted_twice(first, input);
        continue;
      }
      if (!found.files.empty() && found.files.back().name == input.name)
        return fail(refuse::same_input_name, {{"name", input.name},
                                              {"first", found.files.back().file.string()},
                                              {"second", input.file.string()}});
      found.files.push_back(std::move(input));
    }
    std::ranges::sort(passed_, {}, &PassedFile::name);
    found.passed_over.count = passed_.size();
    if (found.files.empty()) return tl::unexpected(nothing());
    passed_.resize(std::min(passed_.size(), kMostPassed));
    found.passed_over.files = std::move(passed_);
    return found;
  }

 private:
  static bool is_file(const fs::path& path) {
    std::error_code none;
    return fs::is_regular_file(path, none) || is_in_archive(path);
  }

  /// In a list, the line may have meant a quantity.
  static Error no_file(const fs::path& path, const fs::path& beside) {
    const auto& refusal = beside.empty() ? refuse::no_file_or_folder : refuse::no_listed_file;
    const std::string file = path.lexically_normal().string();
    return error_of(refusal, {{"file", file}}, file);
  }

  /// Takes a file, or all STEP files of an archive that holds several.
  void take_all(const fs::path& file, const std::string& name, const Wanted& wanted) {
    const auto packed = step_files_in(file);
    if (!packed || packed->size() < 2) return take(file, name, wanted);
    for (const fs::path& one : *packed)
      take(one, name + "/" + one.lexically_relative(file).generic_string(), wanted);
  }

  void take(const fs::path& file, std::string name, const Wanted& wanted) {
    inputs_.push_back({file, std::move(name), wanted.copies, wanted.said_by});
  }

  void pass_over(const std::string& name, ErrorCode code, std::string why) {
    passed_.push_back({name, std::string(code_name(code)), std::move(why)});
  }

  static tl::unexpected<Error> counted_twice(const Input& first, const Input& second) {
    const auto said = [](const Input& one) {
      return one.said_by.empty() ? std::string("another word, which gives no quantity")
                                 : one.said_by;
    };
    return fail(refuse::counted_twice,
                {{"file", first.file.string()}, {"first", said(first)}, {"second", said(second)}},
                first.file.string());
  }

  /// Why there is no input.
  Error nothing() const {
    if (unread_) return *unread_;
    if (passed_.empty()) return error_of(refuse::nothing_to_do, {});
    return error_of(refuse::all_passed_over,
                    {{"count", passed_.size()}, {"first", passed_.front().name}});
  }

  /// Reads a line of a list.
  std::optional<Error> add_line(const std::string& text, const fs::path& list, int number,
                                const Wanted& wanted) {
    const fs::path beside = list.has_parent_path() ? list.parent_path() : ".";
    std::error_code none;
    const ListLine line = line_of(
        text, [&](const std::string& name) { return fs::exists(beside / name, none); });
    Wanted mine = wanted;
    if (!line.times.empty()) {
      const auto copies = copies_in(line.times);
      if (!copies || *copies > shop::kMostPieces / wanted.copies)
        return error_of(refuse::bad_copies,
                        {{"times", shortened(line.times)}, {"most", shop::kMostPieces}}, "");
      mine.copies *= *copies;
      mine.said_by = fmt::format("{}, line {}", list.string(), number);
    }
    return add(line.word, beside, mine);
  }

  std::optional<Error> add_list(const fs::path& list, const Wanted& wanted) {
    std::error_code none;
    const fs::path whole = fs::weakly_canonical(list, none);
    if (std::ranges::find(lists_, whole) != lists_.end())
      return error_of(refuse::list_in_itself, {{"file", list.string()}}, list.string());
    const auto text = schema::read_text(list, "list");
    if (!text) return text.error();
    if (text->find('\0') != std::string::npos)
      return error_of(refuse::list_not_utf8, {{"file", list.string()}}, list.string());
    lists_.push_back(whole);
    int number = 0;
    for (const std::string& line : lines_of(*text)) {
      ++number;
      if (line.empty() || line.starts_with('#')) continue;
      auto error = add_line(line, list, number, wanted);
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

  std::optional<Error> add_folder(const fs::path& folder, const Wanted& wanted) {
    std::error_code none;
    const fs::path whole = fs::weakly_canonical(folder, none);
    const auto [end, rest] = std::ranges::mismatch(whole, out_);
    if (end == whole.end())
      return error_of(refuse::output_in_input,
                      {{"output", out_.string()}, {"folder", folder.string()}}, "output");
    std::vector<fs::path> folders{folder};
    while (!folders.empty()) {
      const fs::path one = std::move(folders.back());
      folders.pop_back();
      std::error_code failed;
      auto entry = fs::directory_iterator(one, failed);
      for (; !failed && entry != fs::directory_iterator(); entry.increment(failed)) {
        if (is_hidden(entry->path())) continue;
        const std::string name = entry->path().lexically_relative(folder).generic_string();
        if (entry->is_directory(none) && !entry->is_symlink(none))
          folders.push_back(entry->path());
        else
          add_found(*entry, name, wanted);
      }
      if (failed) {
        const std::string below = one.lexically_relative(folder).generic_string();
        pass_over(below == "." ? folder.generic_string() : below, code::cannot_read,
                  fmt::format("cannot be read ({})", failed.message()));
        unread_ = schema::cannot_read("folder", one, failed.message());
      }
    }
    return std::nullopt;
  }

  /// What is in a folder, but no folder itself.
  void add_found(const fs::directory_entry& entry, const std::string& name, const Wanted& wanted) {
    std::error_code failed;
    const bool file = entry.is_regular_file(failed);
    if (!file && entry.is_directory(failed))
      return pass_over(name, code::no_input, "a link to a folder");
    if (!file && !entry.exists(failed)) return pass_over(name, code::no_input, "a link to nothing");
    if (file && is_input(entry.path())) return take_all(entry.path(), name, wanted);
    pass_over(name, code::no_input, "no file that planish reads");
  }

  bool is_input(const fs::path& file) const {
    if (has_step_name(file)) return true;
    const std::string suffix = lower_case(file.extension().string());
    if (suffix == ".stpz" || suffix == ".gz" || suffix == ".zip") {
      const auto packed = step_files_in(file);
      return packed && !packed->empty();
    }
    if (suffix != ".json") return false;
    const auto input = job::read_input_file(file, "input file");
    return input && catalogue_.maker_for(input->name, input->content);
  }

  fs::path out_;
  const job::Catalogue& catalogue_;
  std::vector<Input> inputs_;
  std::vector<PassedFile> passed_;
  std::optional<Error> unread_;  ///< of the last folder that cannot be read
  std::vector<fs::path> lists_;  ///< being read, each named by the one before
};

}  // namespace

Result<Inputs> inputs_of(const std::vector<std::string>& words, const fs::path& out,
                         const job::Catalogue& catalogue) {
  Collecting collecting(out, catalogue);
  for (const std::string& word : words)
    if (auto error = collecting.add(word, {})) return tl::unexpected(std::move(*error));
  return collecting.finish();
}

}  // namespace planish::batch
