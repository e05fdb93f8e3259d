#include "refusals.hpp"
#include "results.hpp"

#include <planish/io/flat_writers.hpp>
#include <planish/schema/text_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>

// The shards of a batch become the result that one machine would have made. All must be finished,
// of the same inputs and options, and each number there once; the hash in the record of a run says
// so. Files are linked, or copied where a file system cannot, and lines of the journal are copied
// as they are. Nothing depends on the order of the shards, and a merge that was interrupted can be
// run again.

namespace planish::batch {
namespace {

namespace fs = std::filesystem;

bool is_shard(const fs::path& folder) {
  return folder.filename().string().starts_with("shard-") && is_batch(folder);
}

/// The folders of results that are meant: the shards in each, or else itself.
Result<std::vector<fs::path>> batches_in(const std::vector<fs::path>& folders) {
  std::vector<fs::path> batches;
  for (const fs::path& folder : folders) {
    std::error_code failed;
    const std::size_t before = batches.size();
    auto entry = fs::directory_iterator(folder, failed);
    for (; !failed && entry != fs::directory_iterator(); entry.increment(failed))
      if (is_shard(entry->path())) batches.push_back(entry->path());
    if (failed) return fail(schema::cannot_read("folder", folder, failed.message()));
    if (batches.size() > before) continue;
    if (!is_batch(folder))
      return fail(refuse::no_batch, {{"folder", folder.string()}}, folder.string());
    batches.push_back(folder);
  }
  std::ranges::sort(batches);
  const auto [first, last] = std::ranges::unique(batches);
  batches.erase(first, last);
  return batches;
}

std::string shard_text(const Shard& shard) { return fmt::format("{}/{}", shard.number, shard.of); }

struct Batch {
  fs::path folder;
  RunRecord record;
};

/// These, if they are all shards of one batch.
Result<std::vector<Batch>> all_shards(const std::vector<fs::path>& folders) {
  std::vector<Batch> batches;
  std::set<int> numbers;
  for (const fs::path& folder : folders) {
    auto record = read_record(folder);
    if (!record) return pass_on(record);
    const auto refused = [&](const Refusal& refusal, Facts facts) {
      facts.emplace_back("folder", folder.string());
      return fail(refusal, facts, folder.string());
    };
    const std::string shard = shard_text(record->shard);
    if (!record->finished) return refused(refuse::shard_unfinished, {{"shard", shard}});
    const RunRecord& first = batches.empty() ? *record : batches.front().record;
    if (record->shard.of != first.shard.of || record->work != first.work)
      return refused(refuse::other_batch, {{"other", folders.front().string()}});
    if (!numbers.insert(record->shard.number).second)
      return refused(refuse::shard_twice, {{"shard", shard}});
    batches.push_back({folder, std::move(*record)});
  }
  const int count = batches.front().record.shard.of;
  for (int i = 1; i <= count; ++i)
    if (!numbers.contains(i))
      return fail(refuse::shard_missing, {{"shard", shard_text({i, count})}});
  return batches;
}

/// Puts a part's files of one batch in place in another.
Result<void> take_over(const PartRecord& part, const fs::path& from, const fs::path& to) {
  if (!part.files.empty())
    if (auto made = make_folder(to); !made) return made;
  for (const std::string& file : part.files) {
    std::error_code error, none;
    fs::remove(to / file, none);
    fs::create_hard_link(from / file, to / file, error);
    if (error) fs::copy_file(from / file, to / file, error);
    if (error) return cannot_write(to / file, error.message());
  }
  return {};
}

/// Takes batches into another one.
class Merging {
 public:
  Merging(State& state, const std::vector<Batch>& batches,
          const std::function<void(const BatchProgress&)>& report,
          const std::function<bool()>& cancelled)
      : state_(state), batches_(batches), report_(report), cancelled_(cancelled) {
    for (const Batch& batch : batches)
      progress_.all += batch.record.names.size();
  }

  std::optional<Error> run() {
    for (const Batch& batch : batches_) {
      auto journal = read_journal(batch.folder);
      if (!journal) return journal.error();
      for (const std::string& name : batch.record.names)
        if (auto error = add(batch.folder, *journal, name)) return error;
      if (auto flushed = state_.journal().flush(); !flushed) return flushed.error();
    }
    return std::nullopt;
  }

 private:
  std::optional<Error> add(const fs::path& folder, Journal& journal, const std::string& name) {
    if (cancelled_()) return interruption();
    const auto parts = journal.parts_of(name);
    if (!parts) return parts.error();
    for (const PartRecord& part : *parts)
      if (auto taken = take_over(part, part_folder(folder, part.folder),
                                 state_.folder_of(part.folder));
          !taken)
        return taken.error();
    if (state_.journal().key_of(name) != journal.key_of(name))
      if (auto added = state_.journal().add_from(journal, name); !added) return added.error();
    ++progress_.done;
    progress_.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    if (report_) report_(progress_);
    return std::nullopt;
  }

  using Clock = std::chrono::steady_clock;
  State& state_;
  const std::vector<Batch>& batches_;
  const std::function<void(const BatchProgress&)>& report_;
  const std::function<bool()>& cancelled_;
  Clock::time_point start_ = Clock::now();
  BatchProgress progress_;
};

}  // namespace

Result<BatchResult> merge_batches(const std::vector<fs::path>& folders, const fs::path& out,
                                  const std::function<void(const BatchProgress&)>& report,
                                  const std::function<bool()>& cancelled) {
  const auto found = batches_in(folders);
  if (!found) return pass_on(found);
  for (const fs::path& folder : *found)
    if (std::error_code none; fs::equivalent(folder, out, none))
      return fail(refuse::merged_into_itself, {{"folder", out.string()}}, "output");
  const auto batches = all_shards(*found);
  if (!batches) return pass_on(batches);
  auto state = State::open(out);
  if (!state) return pass_on(state);
  const RunRecord& first = batches->front().record;
  RunRecord record{.shard = {},
                   .inputs = first.inputs,
                   .work = first.work,
                   .copies = first.copies,
                   .passed_over = first.passed_over};
  if (auto written = state->record(record); !written) return pass_on(written);
  Merging merging(*state, *batches, report, cancelled);
  if (auto error = merging.run()) return tl::unexpected(std::move(*error));
  for (const Batch& batch : *batches)
    record.names.insert(record.names.end(), batch.record.names.begin(), batch.record.names.end());
  std::ranges::sort(record.names);
  auto result = write_results(record, *state);
  if (!result) return result;
  record.finished = true;
  if (auto written = state->record(record); !written) return pass_on(written);
  result->left = state->journal().names().size() - record.names.size();
  return result;
}

}  // namespace planish::batch
