#include "workbench.hpp"

#include "json_text.hpp"

#include <chrono>
#include <exception>
#include <new>

namespace planish::studio {
namespace {

/// Whether an error lies in the content of a file that somebody gave to an option.
bool is_of_file(const Error& error) {
  const std::string within = std::string(kOptions) + "/";
  const auto option = error.where.find('/', within.size());
  return error.where.starts_with(within) && option != std::string::npos &&
         error.where.compare(option, 8, "/content") == 0;
}

/// 400 for a malformed request; `failure` if it is valid but this kind of document cannot do it,
/// or a file of its options is invalid.
Answer bad_request(const Error& error) {
  if (error.code == code::bad_option || is_of_file(error)) return failure(error);
  Error bad = error;
  bad.code = {"bad_request", ExitStatus::usage};
  return failure(400, bad);
}

}  // namespace

Answer Workbench::open(const Task& task, const Progress& progress) {
  auto document = Document::open(catalogue_, task.argument, task.body, attachments_, progress);
  if (!document) return failure(document.error());
  document_ = std::move(*document);
  made_result_ = false;
  const job::Maker& maker = document_->maker();
  Json json{{"kind", maker.name},
            {"name", task.argument},
            {"info", Json::parse(document_->info(progress))}};
  json["text"] = maker.format.empty() ? Json(nullptr) : Json(task.body);
  return {200, kJsonType, json_text(json)};
}

Answer Workbench::shape(const Task& task, job::Effort effort, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const auto asked = parse_asked(task.body, document_->maker());
  if (!asked) return bad_request(asked.error());
  const auto shape = document_->shape(*asked, effort, progress);
  if (!shape) return failure(shape.error());
  if (effort == job::Effort::full) made_result_ = true;
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return {200, "application/octet-stream", encoded(*shape, taken.count())};
}

Answer Workbench::file(const Task& task, const Progress& progress) {
  const auto asked = parse_asked(task.body, document_->maker());
  if (!asked) return bad_request(asked.error());
  // The edited input itself.
  if (task.argument == "spec" && !asked->spec.empty())
    return {200, kJsonType, json_text(*parse_json(asked->spec, "spec"), 2) + "\n"};
  auto made = document_->file(*asked, task.argument, progress);
  if (!made) return failure(made.error());
  return {200, std::string(made->artifact->media_type), std::move(made->bytes)};
}

Answer Workbench::plan(const Task& task, const Progress& progress) {
  const auto asked = parse_asked(task.body, document_->maker());
  if (!asked) return bad_request(asked.error());
  auto plan = document_->plan(*asked, progress);
  if (!plan) return failure(plan.error());
  return {200, kJsonType, without_indents(*plan)};
}

Answer Workbench::dispatch(const Task& task, const Progress& progress) {
  if (task.verb == "open") return open(task, progress);
  if (!document_) return failure(500, "internal", "nothing is open");
  if (task.verb == "draft") return shape(task, job::Effort::draft, progress);
  if (task.verb == "result") return shape(task, job::Effort::full, progress);
  if (task.verb == "files") return file(task, progress);
  if (task.verb == "plan") return plan(task, progress);
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

bool Workbench::rest() { return made_result_ && document_ && document_->free_spare(); }

}  // namespace planish::studio
