#include "document_store.hpp"

#include "../work/attachments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <vector>

namespace planish::studio {
namespace {

constexpr std::size_t kMostDocuments = 8;
constexpr std::chrono::seconds kUnused(60);

Answer no_document(const std::string& id) {
  return failure(404, "no_such_document", fmt::format("there is no document \"{}\"", id), id);
}

/// −1 for what is none.
int number_of(const std::string& id) {
  int number = -1;
  if (id.size() < 2 || id.front() != 'd') return -1;
  const auto read = std::from_chars(id.data() + 1, id.data() + id.size(), number);
  return read.ec == std::errc() && read.ptr == id.data() + id.size() ? number : -1;
}

}  // namespace

Answer DocumentStore::open(const std::string& name, const std::string& bytes) {
  if (!is_plain_name(name))
    return failure(422, "invalid_input",
                   "the file needs a name without folders, of at most 128 bytes", name);
  std::string id;
  {
    const std::lock_guard lock(mutex_);
    if (!make_room())
      return failure(429, "too_many_documents",
                     fmt::format("{} documents are open and in use; close one", kMostDocuments));
    ++opening_;
    id = fmt::format("d{}", ++last_);
  }
  Answer answer = opened(id, name, bytes);
  const std::lock_guard lock(mutex_);
  --opening_;
  return answer;
}

Answer DocumentStore::opened(const std::string& id, const std::string& name,
                             const std::string& bytes) {
  auto document = ServedDocument::make(folder_ / id, name, bytes);
  if (!document) return failure(document.error());
  Answer answer = (*document)->open(turns_);
  if (answer.status != 200) return answer;
  answer.body = fmt::format("{{\"id\":\"{}\",", id) + answer.body.substr(1);
  const std::lock_guard lock(mutex_);
  rows_[number_of(id)] = {std::move(*document), answer.body};
  return answer;
}

bool DocumentStore::make_room() {
  if (rows_.size() + static_cast<std::size_t>(opening_) < kMostDocuments) return true;
  if (rows_.empty()) return false;
  const auto oldest =
      std::min_element(rows_.begin(), rows_.end(), [](const auto& a, const auto& b) {
        return a.second.document->last_used() < b.second.document->last_used();
      });
  if (!oldest->second.document->is_idle_since(std::chrono::steady_clock::now() - kUnused))
    return false;
  rows_.erase(oldest);
  return true;
}

Answer DocumentStore::list() const {
  const std::lock_guard lock(mutex_);
  std::string text;
  for (const auto& [number, row] : rows_)
    text += (text.empty() ? "" : ",") + row.answer;
  return {200, kJsonType, "[" + text + "]"};
}

std::shared_ptr<ServedDocument> DocumentStore::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto row = rows_.find(number_of(id));
  return row == rows_.end() ? nullptr : row->second.document;
}

Answer DocumentStore::close(const std::string& id) {
  const auto document = find(id);
  if (!document) return no_document(id);
  document->cancel();
  const std::lock_guard lock(mutex_);
  rows_.erase(number_of(id));
  return {204, "", ""};
}

Answer DocumentStore::attach(const std::string& id, const std::string& name,
                             const std::string& bytes) {
  const auto document = find(id);
  if (!document) return no_document(id);
  if (!is_plain_name(name))
    return failure(422, "invalid_input",
                   "an attachment needs a name without folders, of at most 128 bytes", name);
  return document->attach(name, bytes);
}

Answer DocumentStore::work(const std::string& id, const Task& task) {
  const auto document = find(id);
  return document ? document->work(task, turns_) : no_document(id);
}

Answer DocumentStore::progress(const std::string& id) const {
  const auto document = find(id);
  return document ? document->progress() : no_document(id);
}

Answer DocumentStore::cancel(const std::string& id) {
  const auto document = find(id);
  if (!document) return no_document(id);
  document->cancel();
  return {204, "", ""};
}

void DocumentStore::close_all() {
  std::map<int, Row> rows;
  {
    const std::lock_guard lock(mutex_);
    rows.swap(rows_);
  }
  for (const auto& [number, row] : rows)
    row.document->cancel();
}

}  // namespace planish::studio
