#pragma once

#include "journal.hpp"

#include <planish/batch/batch.hpp>
#include <planish/batch/parts.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace planish::batch {

/// What a run of a batch was about, kept with its results so that shards of one batch are known.
struct RunRecord {
  Shard shard = {};
  std::size_t inputs = 0;  ///< of all shards
  std::string work = {};   ///< hash of their names and copies, the options and the version
  bool finished = false;
  std::vector<std::string> names = {};     ///< of the inputs of this shard, once it is finished
  std::map<std::string, int> copies = {};  ///< by name, where more than one
  PassedOver passed_over = {};             ///< of all shards

  int copies_of(const std::string& name) const {
    const auto found = copies.find(name);
    return found == copies.end() ? 1 : found->second;
  }
};

/// The folder of a batch's results while it is written: nobody else writes to it.
class State {
 public:
  /// Errors: `cannot_write`, also if another batch writes there; `cannot_read`.
  static Result<State> open(const std::filesystem::path& out);
  State(State&& other) noexcept;
  State& operator=(State&&) = delete;
  ~State();

  const std::filesystem::path& out() const { return out_; }
  Journal& journal() { return *journal_; }
  Result<void> record(const RunRecord& record) const;

  /// Writes the files of an input's parts in place of those that an earlier run left of it. Error:
  /// `cannot_write`.
  Result<void> store(const std::vector<PartDone>& parts,
                     const std::vector<PartRecord>& before) const;
  std::filesystem::path folder_of(const std::string& part) const;

 private:
  State() = default;
  std::filesystem::path out_;
  int lock_ = -1;
  std::unique_ptr<Journal> journal_;
};

/// As results have it too.
nlohmann::ordered_json passed_over_json(const PassedOver& passed);

/// Where the files of a part are.
std::filesystem::path part_folder(const std::filesystem::path& out, const std::string& part);
/// What was recorded there. Error: `cannot_read`.
Result<RunRecord> read_record(const std::filesystem::path& out);
/// The journal there. Error: `cannot_read`.
Result<Journal> read_journal(const std::filesystem::path& out);

/// 32 hexadecimal digits.
std::string hash_of(const std::string& text);

}  // namespace planish::batch
