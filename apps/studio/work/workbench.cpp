#include "workbench.hpp"

#include "made_files.hpp"

#include <chrono>
#include <exception>
#include <new>

namespace planish::studio {
namespace {

Answer bad_request(const Error& error) {
  return failure(400, "bad_request", error.message, error.where);
}

}  // namespace

Answer Workbench::open(const Task& task, const Progress& progress) {
  auto document = open_document(task.argument, task.body, attachments_, progress);
  if (!document) return failure(document.error());
  document_ = std::move(*document);
  Json json{
      {"kind", document_->kind()}, {"name", task.argument}, {"info", document_->info(progress)}};
  json["text"] = document_->kind() == "unfold" ? Json(nullptr) : Json(task.body);
  return {200, kJsonType, json_text(json)};
}

Answer Workbench::shape(const Task& task, job::Effort effort, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const auto asked = parse_asked(task.body);
  if (!asked) return bad_request(asked.error());
  const auto shape = document_->shape(*asked, effort, progress);
  if (!shape) return failure(shape.error());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return {200, "application/octet-stream", encoded(*shape, taken.count())};
}

Answer Workbench::file(const Task& task, const Progress& progress) {
  const auto asked = parse_asked(task.body);
  if (!asked) return bad_request(asked.error());
  if (task.argument == "spec") {
    if (auto given = has_spec(*asked); !given) return failure(given.error());
    return {200, kJsonType, json_text(*parse_json(asked->spec, "spec"), 2) + "\n"};
  }
  auto made = document_->file(*asked, task.argument, progress);
  if (!made) return failure(made.error());
  return {200, std::move(made->type), std::move(made->bytes)};
}

Answer Workbench::dispatch(const Task& task, const Progress& progress) {
  if (task.verb == "open") return open(task, progress);
  if (!document_) return failure(500, "internal", "nothing is open");
  if (task.verb == "draft") return shape(task, job::Effort::draft, progress);
  if (task.verb == "result") return shape(task, job::Effort::full, progress);
  if (task.verb == "files") return file(task, progress);
  return failure(500, "internal", "there is no task \"" + task.verb + "\"");
}

Answer Workbench::perform(const Task& task, const Progress& progress) {
  try {
    return dispatch(task, progress);
  } catch (const std::bad_alloc&) {
    return failure(409, "out_of_memory", "the request needs more memory than a worker may have");
  } catch (const std::exception& defect) {
    return failure(500, "internal", defect.what());
  } catch (...) {
    return failure(500, "internal", "an exception of unknown type");
  }
}

}  // namespace planish::studio
