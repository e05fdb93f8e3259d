#include "served_document.hpp"

#include "../work/json_text.hpp"

#include <planish/io/flat_writers.hpp>
#include <planish/schema/text_file.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::studio {
namespace fs = std::filesystem;
namespace {

using Cause = process::ChildEnd::Cause;

constexpr int kUnreadable = 422;  // status for a file that the program cannot read

}  // namespace

Result<std::shared_ptr<ServedDocument>> ServedDocument::make(fs::path folder, DocumentLabel label,
                                                             std::chrono::seconds limit,
                                                             const std::string& bytes) {
  std::shared_ptr<ServedDocument> document(
      new ServedDocument(std::move(folder), std::move(label), limit));
  if (auto made = make_folder(document->attachments()); !made) return pass_on(made);
  if (auto written = write_file(document->file(), bytes); !written) return pass_on(written);
  return document;
}

ServedDocument::~ServedDocument() {
  worker_.end();
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Answer ServedDocument::open(Turns& turns) {
  // Immediately, whatever else is being computed.
  if (const auto answer = known()) return *answer;
  return work({"", "", ""}, turns);
}

Answer ServedDocument::work(const Task& task, Turns& turns) {
  begin();
  Answer answer;
  {
    const std::lock_guard turn(turn_);
    {
      const std::lock_guard lock(state_);
      computing_ = true;
      cancelled_ = closed_;
      stage_ = {};
    }
    answer = computed(task, turns);
  }
  end();
  return answer;
}

void ServedDocument::begin() {
  const std::lock_guard lock(state_);
  ++waiting_;
}

void ServedDocument::end() {
  const std::lock_guard lock(state_);
  computing_ = --waiting_ > 0;
  last_used_ = std::chrono::steady_clock::now();
}

Answer ServedDocument::computed(const Task& task, Turns& turns) {
  const auto turn = turns.take([this] { return is_cancelled(); });
  if (!turn || is_cancelled()) return worker_lost(Cause::crashed);
  if (const auto answer = known(); answer && (task.verb.empty() || answer->status != 200))
    return *answer;
  if (!worker_.is_alive()) {
    Answer answer = read();
    if (answer.status != 200 || task.verb.empty()) return answer;
  }
  return asked(task);
}

Answer ServedDocument::read() {
  const auto bytes = schema::read_text(file(), "document");
  if (!bytes) return failure(bytes.error());
  if (const auto begun = worker_.begin(); !begun) return failure(begun.error());
  Answer answer = labelled(asked({"open", label_.name, *bytes}));
  if (answer.status != 200) worker_.end();
  const std::lock_guard lock(state_);
  // Any other answer may be different next time.
  if (answer.status == 200 || answer.status == kUnreadable) known_ = answer;
  return answer;
}

/// A worker does not know the document's id and origin.
Answer ServedDocument::labelled(Answer answer) const {
  if (answer.status != 200) return answer;
  const bool given = label_.origin == Origin::command_line;
  answer.body = fmt::format("{{\"id\":\"{}\",\"given\":{},", label_.id, given) +
                answer.body.substr(1);
  return answer;
}

std::optional<Answer> ServedDocument::known() const {
  const std::lock_guard lock(state_);
  return known_;
}

bool ServedDocument::is_unreadable() const {
  const std::lock_guard lock(state_);
  return known_ && known_->status == kUnreadable;
}

Answer ServedDocument::asked(const Task& task) {
  if (is_cancelled()) return worker_lost(Cause::crashed);
  process::Parent parent;
  parent.progress.report = [this](std::string_view stage, double share) {
    const std::lock_guard lock(state_);
    stage_ = {std::string(stage), share};
  };
  auto answer = worker_.work_on(task, {.time = limit_, .parent = parent});
  if (!answer) return worker_lost(answer.error().cause);
  // After running out of memory a worker's heap is fragmented.
  if (answer->status == 409) worker_.end();
  return std::move(*answer);
}

Answer ServedDocument::worker_lost(Cause cause) {
  worker_.end();
  if (is_cancelled()) return failure(409, "cancelled", "cancelled");
  if (cause == Cause::out_of_time)
    return failure(
        409, "worker_timeout",
        fmt::format("the request took longer than {} s and was stopped", limit_.count()));
  return failure(
      409, "worker_ended",
      "the worker that computed the request ended unexpectedly; the document is as it was");
}

void ServedDocument::cancel() {
  const std::lock_guard lock(state_);
  if (!computing_) return;
  cancelled_ = true;
  worker_.kill();
}

void ServedDocument::close() {
  {
    const std::lock_guard lock(state_);
    closed_ = true;
  }
  cancel();
}

Answer ServedDocument::progress() const {
  const std::lock_guard lock(state_);
  Json json;
  if (computing_) json = {{"stage", stage_.name}, {"share", stage_.share}};
  return {200, kJsonType, json_text(json)};
}

Answer ServedDocument::attach(const std::string& name, const std::string& bytes) {
  constexpr std::ptrdiff_t kMost = 100;
  const std::lock_guard turn(turn_);
  std::error_code ignored;
  const bool known = fs::exists(attachments() / name, ignored);
  if (!known && std::distance(fs::directory_iterator(attachments(), ignored),
                              fs::directory_iterator()) >= kMost)
    return failure(422, "invalid_input",
                   fmt::format("a document has at most {} attachments", kMost), name);
  if (auto written = write_file(attachments() / name, bytes); !written)
    return failure(written.error());
  // The worker's state was made without this file.
  worker_.end();
  return {204, "", ""};
}

bool ServedDocument::is_cancelled() const {
  const std::lock_guard lock(state_);
  return cancelled_;
}

bool ServedDocument::is_idle_since(Moment moment) const {
  const std::lock_guard lock(state_);
  return waiting_ == 0 && last_used_ <= moment;
}

Moment ServedDocument::last_used() const {
  const std::lock_guard lock(state_);
  return last_used_;
}

}  // namespace planish::studio
