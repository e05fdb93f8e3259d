#include "results.hpp"

#include "identical.hpp"
#include "page.hpp"
#include "summary_csv.hpp"

#include <planish/io/flat_writers.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

// The results of a batch, written from its journal in one pass that holds one input at a time: a
// line, a row of the table and a row of the page for each part. Parts come in the order of their
// names, whatever order they were made in, so the bytes follow from inputs and options alone. The
// first of identical parts in that order names the others. A file has its name only once it is
// whole.

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// A file written piece by piece, under its name only once it is whole.
class Growing {
 public:
  explicit Growing(fs::path target)
      : target_(std::move(target)),
        draft_(target_.string() + ".part"),
        stream_(draft_, std::ios::binary) {}
  Growing(const Growing&) = delete;
  Growing& operator=(const Growing&) = delete;
  ~Growing() {
    std::error_code none;
    if (stream_.is_open()) fs::remove(draft_, none);
  }

  void add(const std::string& text) { stream_ << text; }

  Result<void> finish() {
    stream_.flush();
    const bool whole = stream_.good();
    const std::string why = std::strerror(errno);
    stream_.close();
    std::error_code failed;
    if (whole) fs::rename(draft_, target_, failed);
    if (whole && !failed) return {};
    std::error_code none;
    fs::remove(draft_, none);
    return cannot_write(target_, failed ? failed.message() : why);
  }

 private:
  fs::path target_, draft_;
  std::ofstream stream_;
};

/// The results while they are written, part by part.
class Writing {
 public:
  explicit Writing(State& state)
      : state_(state),
        identical_(state.journal()),
        lines_(state.out() / "parts.jsonl"),
        table_(state.out() / "summary.csv") {
    result_.out = state.out();
    table_.add(csv_titles());
  }

  Result<void> add(const std::string& name, int copies) {
    const auto parts = state_.journal().parts_of(name);
    if (!parts) return pass_on(parts);
    ++result_.inputs;
    for (std::size_t i = 0; i < parts->size(); ++i)
      if (auto added = add(name, i, wanted((*parts)[i], copies)); !added) return added;
    return {};
  }

  Result<BatchResult> finish(const PassedOver& passed) {
    result_.passed_over = passed;
    result_.distinct = identical_.count();
    for (Growing* file : {&lines_, &table_})
      if (auto done = file->finish(); !done) return pass_on(done);
    if (auto done = write_file(state_.out() / "summary.json", summary()); !done)
      return pass_on(done);
    if (auto done = write_file(state_.out() / "index.html", page_.text(passed)); !done)
      return pass_on(done);
    return result_;
  }

 private:
  /// A part as often as its input is wanted.
  static PartRecord wanted(PartRecord part, int copies) {
    if (copies != 1) part.quantity = part.quantity.value_or(1) * copies;
    return part;
  }

  Result<void> add(const std::string& name, std::size_t at, const PartRecord& part) {
    const auto distinct = identical_.number_of(name, at, part.shapes);
    if (!distinct) return pass_on(distinct);
    lines_.add(part.report + "\n");
    std::string same_as;
    if (*distinct && **distinct == firsts_.size())
      firsts_.push_back(part.folder);
    else if (*distinct)
      same_as = firsts_[**distinct];
    table_.add(csv_of(part, same_as));
    page_.add(part, *distinct);
    count(part);
    return {};
  }

  void count(const PartRecord& part) {
    ++result_.parts;
    if (part.status == "ok") ++result_.ok;
    if (part.status == "warning") ++result_.warnings;
    if (part.status == "refused") ++result_.refused;
    if (part.reason.empty()) return;
    ++reasons_[part.reason];
    count_refused(result_.refused_for, {part.reason, part.message, part.folder});
  }

  std::string summary() const {
    Json json{{"format", "planish/batch"},
              {"version", 1},
              {"inputs", result_.inputs},
              {"parts", result_.parts},
              {"ok", result_.ok},
              {"warnings", result_.warnings},
              {"refused", result_.refused},
              {"distinct", result_.distinct},
              {"passed_over", passed_over_json(result_.passed_over)},
              {"reasons", Json::object()}};
    for (const auto& [reason, number] : reasons_)
      json["reasons"][reason] = number;
    return json.dump(2) + "\n";
  }

  State& state_;
  IdenticalParts identical_;
  Growing lines_, table_;
  Page page_;
  std::vector<std::string> firsts_;  ///< folders of the first of identical parts
  std::map<std::string, int> reasons_;
  BatchResult result_;
};

}  // namespace

void count_refused(std::vector<RefusedFor>& all, const RefusedFor& one) {
  const auto same = std::ranges::find_if(all, [&](const RefusedFor& other) {
    return other.code == one.code && other.message == one.message;
  });
  if (same != all.end())
    ++same->count;
  else
    all.push_back(one);
}

Result<BatchResult> write_results(const RunRecord& record, State& state) {
  Writing writing(state);
  for (const std::string& name : record.names)
    if (auto added = writing.add(name, record.copies_of(name)); !added) return pass_on(added);
  return writing.finish(record.passed_over);
}

}  // namespace planish::batch
