#include "state.hpp"

#include <planish/batch/parts.hpp>

#include <fmt/format.h>

namespace planish::batch {

Result<void> for_each_part(const std::filesystem::path& out,
                           const std::function<Result<void>(BatchPart)>& take) {
  const auto record = read_record(out);
  if (!record) return tl::unexpected(record.error());
  if (!record->finished)
    return fail(ErrorCode::cannot_read,
                fmt::format("the batch in {} is not finished: run it again to go on", out.string()),
                out.string());
  auto journal = read_journal(out);
  if (!journal) return tl::unexpected(journal.error());
  for (const std::string& name : record->names) {
    auto parts = journal->parts_of(name);
    if (!parts) return tl::unexpected(parts.error());
    for (Journal::Part& part : *parts)
      if (auto taken = take({part.folder, std::move(part.report), std::move(part.shapes),
                             part_folder(out, part.folder)});
          !taken)
        return taken;
  }
  return {};
}

}  // namespace planish::batch
