#include "state.hpp"

#include "refusals.hpp"

#include <planish/io/flat_writers.hpp>
#include <planish/schema/text_file.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <utility>

// The folder of a batch, and what the program keeps in it: a lock, the record of the run, the
// journal. The operating system holds the lock for the process, so one that was killed leaves none.
// The files that a part had before are removed, new ones are written whole, and folders left empty
// go.

namespace planish::batch {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr auto kState = ".planish-batch";
constexpr auto kParts = "parts";
constexpr auto kJournal = "journal.jsonl";
constexpr auto kRecord = "run.json";
constexpr auto kLock = "lock";

/// Removes what a run that was killed was about to write.
void remove_drafts(const fs::path& folder) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".planish-") && name.ends_with(".part")) fs::remove(entry.path(), none);
  }
}

PassedOver passed_over_in(const Json& json) {
  PassedOver passed{json.at("count"), {}};
  for (const Json& file : json.at("files"))
    passed.files.push_back({file.at("file"), file.at("reason"), file.at("why")});
  return passed;
}

}  // namespace

Json passed_over_json(const PassedOver& passed) {
  Json files = Json::array();
  for (const PassedFile& file : passed.files)
    files.push_back({{"file", file.name}, {"reason", file.reason}, {"why", file.why}});
  return {{"count", passed.count}, {"files", std::move(files)}};
}

Result<State> State::open(const fs::path& out) {
  if (auto made = make_folder(out / kState); !made) return pass_on(made);
  State state;
  state.out_ = out;
  constexpr auto kForAll = 0666;
  state.lock_ = ::open((out / kState / kLock).c_str(), O_CREAT | O_RDWR | O_CLOEXEC, kForAll);
  // File systems that know no locks are taken as they are.
  if (state.lock_ >= 0 && flock(state.lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return fail(refuse::folder_taken, {{"folder", out.string()}}, out.string());
  auto journal = Journal::open(out / kState / kJournal);
  if (!journal) return pass_on(journal);
  state.journal_ = std::make_unique<Journal>(std::move(*journal));
  return state;
}

State::State(State&& other) noexcept
    : out_(std::move(other.out_)),
      lock_(std::exchange(other.lock_, -1)),
      journal_(std::move(other.journal_)) {}

State::~State() {
  if (lock_ >= 0) close(lock_);
}

Result<void> State::record(const RunRecord& record) const {
  const Json json{{"shard", {record.shard.number, record.shard.of}},
                  {"inputs", record.inputs},
                  {"work", record.work},
                  {"finished", record.finished},
                  {"names", record.names},
                  {"copies", record.copies},
                  {"passed_over", passed_over_json(record.passed_over)}};
  return write_file(out_ / kState / kRecord,
                    json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

fs::path State::folder_of(const std::string& part) const { return part_folder(out_, part); }

Result<void> State::store(const std::vector<PartDone>& parts,
                          const std::vector<PartRecord>& before) const {
  std::error_code none;
  for (const PartRecord& part : before)
    for (const std::string& file : part.files)
      fs::remove(folder_of(part.folder) / file, none);
  for (const PartDone& part : parts) {
    if (part.files.empty()) continue;
    const fs::path folder = folder_of(part.record.folder);
    if (auto made = make_folder(folder); !made) return made;
    remove_drafts(folder);
    for (const PartFile& file : part.files)
      if (auto written = write_file(folder / file.name, file.bytes); !written) return written;
  }
  // What is left empty of before.
  for (const PartRecord& part : before)
    for (fs::path folder = part.folder; !folder.empty(); folder = folder.parent_path())
      if (!fs::remove(folder_of(folder.string()), none)) break;
  return {};
}

fs::path part_folder(const fs::path& out, const std::string& part) { return out / kParts / part; }

bool is_batch(const fs::path& out) {
  std::error_code none;
  return fs::is_regular_file(out / kState / kJournal, none);
}

Result<RunRecord> read_record(const fs::path& out) {
  const fs::path file = out / kState / kRecord;
  const auto text = schema::read_text(file, "record of a batch");
  if (!text) return pass_on(text);
  const Json json = Json::parse(*text, nullptr, false);
  try {
    return RunRecord{
        {json.at("shard").at(0), json.at("shard").at(1)},
        json.at("inputs"),
        json.at("work"),
        json.at("finished"),
        json.at("names"),
        json.value("copies", std::map<std::string, int>()),
        json.contains("passed_over") ? passed_over_in(json.at("passed_over")) : PassedOver()};
  } catch (const Json::exception&) {
    return fail(refuse::record_damaged, {{"file", file.string()}}, file.string());
  }
}

Result<Journal> read_journal(const fs::path& out) { return Journal::read(out / kState / kJournal); }

Error interruption() { return error_of(refuse::interrupted, {}); }

std::string hash_of(const std::string& text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace planish::batch
