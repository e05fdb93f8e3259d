#include "refusals.hpp"
#include "state.hpp"

#include <planish/batch/parts.hpp>

#include <fmt/format.h>

#include <set>

namespace planish::batch {
namespace {

Result<RunRecord> finished_record(const std::filesystem::path& out) {
  auto record = read_record(out);
  if (record && !record->finished)
    return fail(refuse::batch_unfinished, {{"folder", out.string()}}, out.string());
  return record;
}

}  // namespace

Result<PassedOver> passed_over_by(const std::filesystem::path& out) {
  auto record = finished_record(out);
  if (!record) return pass_on(record);
  return std::move(record->passed_over);
}

Result<void> for_each_part(const std::filesystem::path& out,
                           const std::function<Result<void>(BatchPart)>& take) {
  const auto record = finished_record(out);
  if (!record) return pass_on(record);
  auto journal = read_journal(out);
  if (!journal) return pass_on(journal);
  for (const std::string& name : record->names) {
    auto parts = journal->parts_of(name);
    if (!parts) return pass_on(parts);
    for (PartRecord& part : *parts) {
      const auto folder = part_folder(out, part.folder);
      if (auto taken = take({std::move(part), folder, record->copies_of(name)}); !taken)
        return taken;
    }
  }
  return {};
}

Result<std::vector<int>> unused_rows(const std::filesystem::path& out,
                                     const shop::PartMaterials& list) {
  std::set<int> used;
  const auto taken = for_each_part(out, [&](const BatchPart& part) -> Result<void> {
    const std::filesystem::path input(part.record.input);
    const auto* row = list.find(
        {part.record.body, input.stem().string(), input.filename().string()}, part.record.colour);
    if (row) used.insert(row->line);
    return {};
  });
  if (!taken) return pass_on(taken);
  std::vector<int> unused;
  for (const shop::PartMaterial& row : list.rows())
    if (!used.contains(row.line)) unused.push_back(row.line);
  return unused;
}

}  // namespace planish::batch
