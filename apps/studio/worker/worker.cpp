#include "worker.hpp"

#include <fmt/format.h>

#include <charconv>

namespace planish::studio {
namespace {

constexpr int kLeastStatus = 200, kLargestStatus = 599;  // of HTTP

}  // namespace

Result<std::unique_ptr<process::ChildProcess>> start_worker(const std::filesystem::path& folder) {
  return process::ChildProcess::program({"studio-worker"}, folder);
}

tl::expected<Answer, process::ChildEnd> ask(process::ChildProcess& worker, const Task& task,
                                            std::chrono::seconds limit,
                                            const std::function<void(Stage)>& report) {
  process::Parent parent;
  parent.progress.report = [&](std::string_view stage, double share) {
    report({std::string(stage), share});
  };
  const auto texts = worker.ask(texts_of(task), limit, parent);
  if (!texts) return tl::unexpected(texts.error());
  if (auto answer = answer_of(*texts)) return std::move(*answer);
  worker.kill();
  return tl::unexpected(
      process::ChildEnd{process::ChildEnd::Cause::crashed, process::kDamagedAnswer});
}

process::Texts texts_of(const Task& task) { return {task.verb, task.argument, task.body}; }

process::Texts texts_of(const Answer& answer) {
  return {fmt::format("{}", answer.status), answer.type, answer.body};
}

std::optional<Task> task_of(const process::Texts& texts) {
  if (texts.size() != 3) return std::nullopt;
  return Task{texts[0], texts[1], texts[2]};
}

std::optional<Answer> answer_of(const process::Texts& texts) {
  if (texts.size() != 3) return std::nullopt;
  int status = 0;
  const std::string& text = texts[0];
  const auto read = std::from_chars(text.data(), text.data() + text.size(), status);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  if (status < kLeastStatus || status > kLargestStatus) return std::nullopt;
  return Answer{status, texts[1], texts[2]};
}

}  // namespace planish::studio
