#include "results.hpp"

#include "rows.hpp"

#include <planish/io/flat_writers.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstring>
#include <fstream>

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

  void add(const std::string& text) { stream_ << text; }

  Result<void> finish() {
    stream_.close();
    std::error_code failed;
    if (stream_) fs::rename(draft_, target_, failed);
    if (stream_ && !failed) return {};
    const std::string why = failed ? failed.message() : std::strerror(errno);
    fs::remove(draft_, failed);
    return fail(ErrorCode::cannot_write, fmt::format("cannot write {}: {}", target_.string(), why),
                target_.string());
  }

 private:
  fs::path target_, draft_;
  std::ofstream stream_;
};

void count(BatchResult& result, const Row& row) {
  ++result.parts;
  if (row.status == "ok") ++result.ok;
  if (row.status == "warning") ++result.warnings;
  if (row.status == "refused") ++result.refused;
}

std::string summary_json(const BatchResult& result, const std::map<std::string, int>& reasons) {
  Json json{{"format", "planish/batch"}, {"version", 1},
            {"inputs", result.inputs},   {"parts", result.parts},
            {"ok", result.ok},           {"warnings", result.warnings},
            {"refused", result.refused}, {"reasons", Json::object()}};
  for (const auto& [reason, number] : reasons)
    json["reasons"][reason] = number;
  return json.dump(2) + "\n";
}

}  // namespace

Result<BatchResult> write_results(const std::vector<Input>& inputs, const fs::path& out,
                                  Journal& journal) {
  BatchResult result{.inputs = inputs.size()};
  Growing lines(out / "parts.jsonl"), table(out / "summary.csv");
  table.add(csv_titles());
  std::vector<Row> rows;
  std::map<std::string, int> reasons;
  for (const Input& input : inputs) {
    auto parts = journal.parts_of(input.name);
    if (!parts) return tl::unexpected(parts.error());
    for (const Journal::Part& part : *parts) {
      lines.add(part.report + "\n");
      Row row = row_of(part.folder, part.report);
      table.add(csv_of(row));
      count(result, row);
      if (!row.reason.empty()) ++reasons[row.reason];
      rows.push_back(std::move(row));
    }
  }
  for (Growing* file : {&lines, &table})
    if (auto done = file->finish(); !done) return tl::unexpected(done.error());
  if (auto done = write_file(out / "summary.json", summary_json(result, reasons)); !done)
    return tl::unexpected(done.error());
  if (auto done = write_file(out / "index.html", page_of(rows)); !done)
    return tl::unexpected(done.error());
  return result;
}

}  // namespace planish::batch
