#include "results.hpp"
#include "state.hpp"
#include "workers.hpp"

#include <planish/batch/codes.hpp>
#include <planish/batch/options.hpp>
#include <planish/batch/parts.hpp>
#include <planish/brep/step_archive.hpp>
#include <planish/job/options.hpp>
#include <planish/schema/text_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <fstream>
#include <iterator>
#include <mutex>
#include <thread>

// A batch under way: inputs, or shares of their bodies where inputs are few, go to workers that
// each keep a process. An input's key is the hash of its content, of the files that it names, and
// of all that parts are made with; an input whose key the journal has is done. What must hold:
// files are stored before the line of the journal that counts them, so a run that was killed
// repeats at most what was under way. The key of a part that was lost, or late, says so, and
// matches no run that may do better (decisions/0015-a-batch-is-a-journal.md).

namespace planish::batch {
namespace {

namespace fs = std::filesystem;

/// Hash of an input and of the files that it names.
std::string content_hash(const Input& input, const job::Catalogue& catalogue) {
  const auto file = job::read_input_file(input.file, "input file");
  if (!file) return hash_of(file.error().message);
  std::string hash = hash_of(file->content);
  const auto maker = catalogue.maker_for(file->name, file->content);
  if (maker && (*maker)->named_files && file->folder)
    for (const job::NamedFile& one : (*maker)->named_files(file->content)) {
      const auto other = job::read_input_file(*file->folder / one.file, "file");
      hash += hash_of(other ? other->content : other.error().message);
    }
  return hash;
}

/// All that parts are made with: version, formats, options, and the files that options name.
std::string settings_of(const BatchOptions& options) {
  std::string settings = fmt::format("{}\n{}\n{}\n", PLANISH_VERSION, options.options,
                                     fmt::join(options.formats, ","));
  const auto given = nlohmann::json::parse(options.options);
  for (const job::Option& option : job::options()) {
    const auto value = given.find(option.name);
    if (option.kind != job::OptionKind::file || value == given.end() || !value->is_string())
      continue;
    // What is no file is a word, such as a material of the shop.
    if (const auto file = schema::read_text(value->get<std::string>(), "file"))
      settings += hash_of(*file) + '\n';
  }
  return settings;
}

/// The size, the beginning and the end of a file: enough to deal files out evenly, without every
/// machine reading all of them. A file in an archive is read.
std::string sample_of(const fs::path& file) {
  constexpr std::streamoff kEnd = 4096;  // bytes
  if (is_in_archive(file)) return read_in_archive(file).value_or("");
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return {};
  const auto size = static_cast<std::streamoff>(stream.tellg());
  std::string sample(static_cast<std::size_t>(std::min(size, 2 * kEnd)), '\0');
  const std::streamoff head = std::min(size, kEnd), tail = std::ssize(sample) - head;
  stream.seekg(0);
  stream.read(sample.data(), head);
  stream.seekg(size - tail);
  stream.read(sample.data() + head, tail);
  return fmt::format("{}\n{}", size, sample);
}

/// Whether an input falls to this shard. The hash is even, so shards are of about the same size.
bool falls_to(const Shard& shard, const Input& input) {
  if (shard.of == 1) return true;
  constexpr std::size_t kDigits = 15;
  constexpr int kHexadecimal = 16;
  const std::string hash = hash_of(sample_of(input.file));
  std::uint64_t number = 0;
  std::from_chars(hash.data(), hash.data() + kDigits, number, kHexadecimal);
  return static_cast<int>(number % static_cast<std::uint64_t>(shard.of)) + 1 == shard.number;
}

/// Whether another try may go better, and with which limits.
std::string tried_with(const std::vector<PartDone>& parts, const process::Limits& limits) {
  const auto ended_by = [&](ErrorCode code) {
    return std::ranges::any_of(
        parts, [&](const PartDone& part) { return part.record.reason == code_name(code); });
  };
  if (ended_by(code::worker_died)) return "lost";
  if (ended_by(code::time_limit) || ended_by(code::out_of_memory))
    return fmt::format("{} ms, {} bytes", limits.time.count(), limits.memory);
  return {};
}

/// A batch under way.
class Running {
 public:
  Running(const std::vector<Input>& inputs, State& state, const BatchOptions& options,
          const job::Catalogue& catalogue, const std::function<void(const BatchProgress&)>& report,
          const std::function<bool()>& cancelled)
      : inputs_(inputs),
        mine_(inputs.size(), 0),
        state_(state),
        options_(options),
        catalogue_(catalogue),
        report_(report),
        cancelled_(cancelled) {
    progress_.all = inputs.size();
    const auto workers = static_cast<std::size_t>(options.workers);
    const auto shares = inputs.size() < workers ? (workers + inputs.size() - 1) / inputs.size() : 1;
    for (std::size_t input = 0; input < inputs.size(); ++input)
      for (std::size_t share = 1; share <= shares; ++share)
        tasks_.push_back({input, {static_cast<int>(share), static_cast<int>(shares)}});
    gathered_.resize(inputs.size(), {shares, {}});
  }

  std::optional<Error> run() {
    std::vector<std::thread> threads;
    const auto count = std::min<std::size_t>(static_cast<std::size_t>(options_.workers),
                                             tasks_.size());
    for (std::size_t i = 0; i < count; ++i)
      threads.emplace_back([this] { work(); });
    for (std::thread& thread : threads)
      thread.join();
    return error_;
  }

  const BatchProgress& progress() const { return progress_; }

  /// The names of the inputs of this shard, in order.
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < inputs_.size(); ++i)
      if (mine_[i]) names.push_back(inputs_[i].name);
    return names;
  }

 private:
  /// What a worker does at a time.
  struct Task {
    std::size_t input;
    BodyShare share;
  };
  /// What the shares of an input gave so far.
  struct Gathered {
    std::size_t left;
    std::vector<PartDone> parts;
  };

  bool ends() {
    const std::scoped_lock lock(mutex_);
    return error_.has_value();
  }

  void work() {
    BatchWorker worker(options_.limits, catalogue_, [this] { return cancelled_() || ends(); });
    for (;;) {
      const std::size_t at = next_++;
      if (at >= tasks_.size() || ends()) return;
      if (cancelled_()) return stop(interruption());
      if (auto error = work_on(tasks_[at], worker)) return stop(std::move(*error));
    }
  }

  std::optional<Error> work_on(const Task& task, BatchWorker& worker) {
    const Input& input = inputs_[task.input];
    const bool first = task.share.number == 1;
    if (!falls_to(options_.shard, input)) {
      if (first) skip();
      return std::nullopt;
    }
    if (first) mine_[task.input] = 1;
    const std::string key = hash_of(content_hash(input, catalogue_) + "\n" + settings_);
    if (is_known(input, key)) {
      if (first) resume();
      return std::nullopt;
    }
    auto parts = worker.work_on({.file = input.file.string(),
                                 .name = input.name,
                                 .options = options_.options,
                                 .formats = options_.formats,
                                 .share = task.share});
    if (!parts && parts.error().code == code::cancelled) return interruption();
    if (!parts) return parts.error();
    const auto all = gathered(task.input, std::move(*parts));
    return all ? enter(input, key, *all) : std::nullopt;
  }

  /// All parts of an input, in their order, once the last of its shares is done.
  std::optional<std::vector<PartDone>> gathered(std::size_t input, std::vector<PartDone> parts) {
    const std::scoped_lock lock(mutex_);
    Gathered& all = gathered_[input];
    std::ranges::move(parts, std::back_inserter(all.parts));
    if (--all.left > 0) return std::nullopt;
    std::ranges::stable_sort(all.parts, {}, &PartDone::body);
    // A file that cannot be read is one part, whichever share says so.
    const auto [first, last] = std::ranges::unique(
        all.parts, {}, [](const PartDone& part) { return part.record.folder; });
    all.parts.erase(first, last);
    return std::move(all.parts);
  }

  bool is_known(const Input& input, const std::string& key) {
    const std::scoped_lock lock(mutex_);
    const std::string before = state_.journal().key_of(input.name);
    return before == key || before == key + tried_with_these();
  }

  void resume() {
    const std::scoped_lock lock(mutex_);
    ++progress_.resumed;
    tell();
  }

  /// The end of the key of an input that these limits were too small for.
  std::string tried_with_these() const {
    PartDone late;
    late.record.reason = code_name(code::time_limit);
    return tried_with({late}, options_.limits);
  }

  std::optional<Error> enter(const Input& input, const std::string& key,
                             const std::vector<PartDone>& parts) {
    std::unique_lock lock(mutex_);
    const auto before = state_.journal().parts_of(input.name);
    if (!before) return before.error();
    lock.unlock();
    if (auto stored = state_.store(parts, *before); !stored) return stored.error();
    lock.lock();
    if (auto added = state_.journal().add(input.name, key + tried_with(parts, options_.limits),
                                          parts);
        !added)
      return added.error();
    progress_.refused += static_cast<std::size_t>(std::ranges::count_if(
        parts, [](const PartDone& part) { return !part.record.reason.empty(); }));
    tell();
    return std::nullopt;
  }

  void skip() {
    const std::scoped_lock lock(mutex_);
    --progress_.all;
  }

  void tell() {
    ++progress_.done;
    progress_.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    if (report_) report_(progress_);
  }

  void stop(Error error) {
    const std::scoped_lock lock(mutex_);
    if (!error_) error_ = std::move(error);
  }

  using Clock = std::chrono::steady_clock;

  const std::vector<Input>& inputs_;
  std::vector<char> mine_;  ///< of this shard; each is written by one thread
  State& state_;
  const BatchOptions& options_;
  const std::string settings_ = settings_of(options_);
  const job::Catalogue& catalogue_;
  const std::function<void(const BatchProgress&)>& report_;
  const std::function<bool()>& cancelled_;
  Clock::time_point start_ = Clock::now();
  std::vector<Task> tasks_;
  std::vector<Gathered> gathered_;  ///< by input
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  BatchProgress progress_;
  std::optional<Error> error_;
};

RunRecord record_of(const Inputs& inputs, const BatchOptions& options) {
  RunRecord record{.shard = options.shard, .inputs = inputs.files.size(), .work = {}};
  std::string work = settings_of(options);
  for (const Input& input : inputs.files) {
    work += fmt::format("{} x{}\n", input.name, input.copies);
    if (input.copies != 1) record.copies.emplace(input.name, input.copies);
  }
  record.work = hash_of(work);
  record.passed_over = inputs.passed_over;
  return record;
}

}  // namespace

Result<BatchResult> run_batch(const Inputs& inputs, const fs::path& out,
                              const BatchOptions& options, const job::Catalogue& catalogue,
                              const std::function<void(const BatchProgress&)>& report,
                              const std::function<bool()>& cancelled) {
  if (auto wrong = useless_options(inputs.files, options.options, catalogue))
    return tl::unexpected(std::move(*wrong));
  const Shard& shard = options.shard;
  auto state = State::open(
      shard.of == 1 ? out : out / fmt::format("shard-{}-of-{}", shard.number, shard.of));
  if (!state) return pass_on(state);
  RunRecord record = record_of(inputs, options);
  if (auto written = state->record(record); !written) return pass_on(written);
  Running running(inputs.files, *state, options, catalogue, report, cancelled);
  if (auto error = running.run()) return tl::unexpected(std::move(*error));
  record.names = running.names();
  auto result = write_results(record, *state);
  if (!result) return result;
  record.finished = true;
  if (auto written = state->record(record); !written) return pass_on(written);
  if (const auto request = request_of(options.options, catalogue);
      request && request->materials && shard.of == 1) {
    const auto lines = unused_rows(result->out, *request->materials);
    if (!lines) return pass_on(lines);
    for (const int line : *lines)
      result->notes.push_back(shop::unused_row_text(*request->materials, line));
  }
  result->resumed = running.progress().resumed;
  result->left = state->journal().names().size() - record.names.size();
  return result;
}

}  // namespace planish::batch
