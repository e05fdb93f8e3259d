#include "worker.hpp"

#include <fmt/format.h>

#include <charconv>

namespace planish::studio {
namespace {

constexpr int kLeastStatus = 200, kLargestStatus = 599;  // of HTTP

}  // namespace

process::Starting studio_worker(const std::filesystem::path& folder) {
  return process::program_again({"studio-worker"}, folder);
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
