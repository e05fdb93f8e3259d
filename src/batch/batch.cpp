#include "journal.hpp"
#include "results.hpp"
#include "workers.hpp"

#include <planish/batch/batch.hpp>
#include <planish/io/flat_writers.hpp>

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

namespace planish::batch {
namespace {

namespace fs = std::filesystem;

constexpr auto kState = ".planish-batch";
constexpr auto kParts = "parts";

std::string hash_of(const std::string& text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

/// A batch under way.
class Running {
 public:
  Running(const std::vector<Input>& inputs, const fs::path& out, const BatchOptions& options,
          const job::Catalogue& catalogue, Journal& journal,
          const std::function<void(const BatchProgress&)>& report,
          const std::function<bool()>& cancelled)
      : inputs_(inputs),
        out_(out),
        options_(options),
        catalogue_(catalogue),
        journal_(journal),
        report_(report),
        cancelled_(cancelled) {
    progress_.all = inputs.size();
  }

  std::optional<Error> run() {
    std::vector<std::thread> threads;
    for (int i = 0; i < options_.workers; ++i)
      threads.emplace_back([this] { work(); });
    for (std::thread& thread : threads)
      thread.join();
    return error_;
  }

  const BatchProgress& progress() const { return progress_; }

 private:
  bool ends() {
    const std::scoped_lock lock(mutex_);
    return error_.has_value();
  }

  void work() {
    Worker worker(options_.limits, catalogue_, [this] { return cancelled_() || ends(); });
    for (;;) {
      const std::size_t at = next_++;
      if (at >= inputs_.size() || ends()) return;
      if (cancelled_()) return stop({ErrorCode::cancelled, "interrupted", {}});
      const Input& input = inputs_[at];
      const std::string key = key_of(input);
      if (known(input, key)) continue;
      auto parts = worker.work_on(
          {input.file.string(), input.name, options_.options, options_.formats});
      if (!parts) return stop(parts.error());
      if (auto error = store(*parts)) return stop(*error);
      if (auto error = enter(input, key, *parts)) return stop(*error);
    }
  }

  std::string key_of(const Input& input) const {
    const auto content = job::read_input_file(input.file, "input file");
    std::string all = content ? content->content : content.error().message;
    all += fmt::format("\n{}\n{}\n{}", PLANISH_VERSION, options_.options,
                       fmt::join(options_.formats, ","));
    return hash_of(all);
  }

  bool known(const Input& input, const std::string& key) {
    const std::scoped_lock lock(mutex_);
    if (!journal_.has(input.name, key)) return false;
    ++progress_.resumed;
    tell();
    return true;
  }

  std::optional<Error> store(const std::vector<PartDone>& parts) const {
    for (const PartDone& part : parts) {
      const fs::path folder = out_ / kParts / part.folder;
      std::error_code failed;
      fs::create_directories(folder, failed);
      if (failed)
        return Error{
            ErrorCode::cannot_write,
            fmt::format("cannot make the folder {}: {}", folder.string(), failed.message()),
            folder.string()};
      for (const PartFile& file : part.files)
        if (const auto written = write_file(folder / file.name, file.bytes); !written)
          return written.error();
    }
    return std::nullopt;
  }

  std::optional<Error> enter(const Input& input, const std::string& key,
                             const std::vector<PartDone>& parts) {
    const std::scoped_lock lock(mutex_);
    if (auto added = journal_.add(input.name, key, parts); !added) return added.error();
    progress_.refused += static_cast<std::size_t>(
        std::ranges::count_if(parts, [](const PartDone& part) {
          return part.report.find("\"status\":\"refused\"") != std::string::npos;
        }));
    tell();
    return std::nullopt;
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
  const fs::path& out_;
  const BatchOptions& options_;
  const job::Catalogue& catalogue_;
  Journal& journal_;
  const std::function<void(const BatchProgress&)>& report_;
  const std::function<bool()>& cancelled_;
  Clock::time_point start_ = Clock::now();
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  BatchProgress progress_;
  std::optional<Error> error_;
};

}  // namespace

int run_batch_worker(const std::string& parent, std::uint64_t memory,
                     const job::Catalogue& catalogue) {
  const auto answering = [&](const job::Texts& question, const job::Parent& asking) {
    const auto task = task_in(question);
    return task ? texts_of(work_on(*task, catalogue, asking)) : job::Texts{};
  };
  return job::answer_parent(parent, answering, {}, memory);
}

Result<BatchResult> run_batch(const std::vector<Input>& inputs, const fs::path& out,
                              const BatchOptions& options, const job::Catalogue& catalogue,
                              const std::function<void(const BatchProgress&)>& report,
                              const std::function<bool()>& cancelled) {
  std::error_code failed;
  fs::create_directories(out / kState, failed);
  if (failed)
    return fail(ErrorCode::cannot_write,
                fmt::format("cannot make the folder {}: {}", out.string(), failed.message()),
                out.string());
  auto journal = Journal::open(out / kState / "journal.jsonl");
  if (!journal) return tl::unexpected(journal.error());
  Running running(inputs, out, options, catalogue, *journal, report, cancelled);
  if (auto error = running.run()) return tl::unexpected(std::move(*error));
  auto result = write_results(inputs, out, *journal);
  if (result) result->resumed = running.progress().resumed;
  return result;
}

}  // namespace planish::batch
