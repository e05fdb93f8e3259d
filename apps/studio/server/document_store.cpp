#include "document_store.hpp"

#include "../work/attachments.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <chrono>

namespace planish::studio {
namespace {

constexpr std::size_t kMostDocuments = 8;
constexpr std::chrono::seconds kUnused(60);

Answer no_document(const std::string& id) {
  return failure(404, "no_such_document", fmt::format("there is no document \"{}\"", id), id);
}

/// −1 if it is not the id of a document.
int number_of(const std::string& id) {
  int number = -1;
  if (id.size() < 2 || id.front() != 'd') return -1;
  const auto read = std::from_chars(id.data() + 1, id.data() + id.size(), number);
  return read.ec == std::errc() && read.ptr == id.data() + id.size() ? number : -1;
}

}  // namespace

Answer DocumentStore::take(const std::string& name, const std::string& bytes, Origin origin) {
  if (!is_plain_name(name))
    return failure(422, "invalid_input",
                   "the file needs a name without folders, of at most 240 bytes", name);
  const auto number = new_number();
  if (!number)
    return failure(429, "too_many_documents",
                   fmt::format("{} documents are open and in use; close one", kMostDocuments));
  const std::string id = fmt::format("d{}", *number);
  auto document = ServedDocument::make(folder_ / id, {id, name, origin}, limit_, bytes);
  const std::lock_guard lock(mutex_);
  --taking_;
  taken_.notify_all();
  if (!document) return failure(document.error());
  documents_[*number] = std::move(*document);
  return {200, kJsonType, nlohmann::ordered_json{{"id", id}, {"name", name}}.dump()};
}

/// For a document about to be written. Empty if there is no room for another.
std::optional<int> DocumentStore::new_number() {
  const std::lock_guard lock(mutex_);
  if (closed_ || !make_room()) return std::nullopt;
  ++taking_;
  return ++last_;
}

Answer DocumentStore::open(const std::string& id) {
  const auto document = find(id);
  return document ? document->open(turns_) : no_document(id);
}

bool DocumentStore::make_room() {
  if (documents_.size() + static_cast<std::size_t>(taking_) < kMostDocuments) return true;
  if (documents_.empty()) return false;
  const auto now = std::chrono::steady_clock::now();
  const auto unreadable = std::ranges::find_if(documents_, [&](const auto& row) {
    return row.second->is_unreadable() && row.second->is_idle_since(now);
  });
  const auto oldest = std::ranges::min_element(
      documents_, {}, [](const auto& row) { return row.second->last_used(); });
  if (unreadable != documents_.end())
    documents_.erase(unreadable);
  else if (oldest->second->is_idle_since(now - kUnused))
    documents_.erase(oldest);
  else
    return false;
  return true;
}

Answer DocumentStore::list() const {
  const std::lock_guard lock(mutex_);
  std::string text;
  for (const auto& [number, document] : documents_)
    if (const auto answer = document->known(); answer && answer->status == 200)
      text += (text.empty() ? "" : ",") + answer->body;
  return {200, kJsonType, "[" + text + "]"};
}

std::shared_ptr<ServedDocument> DocumentStore::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto row = documents_.find(number_of(id));
  return row == documents_.end() ? nullptr : row->second;
}

Answer DocumentStore::close(const std::string& id) {
  const auto document = find(id);
  if (!document) return no_document(id);
  document->close();
  const std::lock_guard lock(mutex_);
  documents_.erase(number_of(id));
  return {204, "", ""};
}

Answer DocumentStore::attach(const std::string& id, const std::string& name,
                             const std::string& bytes) {
  const auto document = find(id);
  if (!document) return no_document(id);
  if (!is_plain_name(name))
    return failure(422, "invalid_input",
                   "an attachment needs a name without folders, of at most 240 bytes", name);
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
  std::map<int, std::shared_ptr<ServedDocument>> documents;
  {
    // Documents being written now would be written into a folder that no longer exists.
    std::unique_lock lock(mutex_);
    closed_ = true;
    taken_.wait(lock, [this] { return taking_ == 0; });
    documents.swap(documents_);
  }
  for (const auto& [number, document] : documents)
    document->close();
}

}  // namespace planish::studio
