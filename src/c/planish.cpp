#include "refusals.hpp"

#include <planish/job/run.hpp>
#include <planish/job/schemas.hpp>
#include <planish/planish.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <utility>

// The C interface (c.md). No exception leaves it: what is thrown becomes the error of a result, and
// where there is no memory for a result there is one made beforehand. A result owns its texts;
// those that never change are made once and not freed, and before a process is copied, so that no
// lock is held in the copy.
namespace job = planish::job;
namespace process = planish::process;
using planish::Error;

/// All texts that a result gives out are its own.
struct planish_result {
  int status = PLANISH_FAILED;
  std::string report, summary;
  std::string code, message, where;
  int exit_status = 0;
  std::vector<job::ArtifactFile> files;
  std::vector<planish_artifact> artifacts;
};

namespace {

constexpr double kLongestTime = 1e9;  // seconds

void set_error(planish_result& result, const Error& error) {
  result.code = code_name(error.code);
  result.message = error.message;
  result.where = error.where;
  result.exit_status = exit_status(error.code);
}

void set_result(planish_result& result, job::RunResult made) {
  result.status = made.status == job::Status::ok        ? PLANISH_OK
                  : made.status == job::Status::warning ? PLANISH_WARNING
                                                        : PLANISH_REFUSED;
  result.report = std::move(made.report);
  result.summary = std::move(made.summary);
  result.files = std::move(made.artifacts);
  for (const job::ArtifactFile& file : result.files)
    result.artifacts.push_back({file.artifact.c_str(), file.name.c_str(), file.media_type.c_str(),
                                file.bytes.c_str(), file.bytes.size()});
}

/// Progress as the caller's function hears it; also what asks it whether to go on.
class Caller {
 public:
  explicit Caller(const planish_options& options) : options_(options) {}

  planish::Progress progress() {
    if (!options_.progress) return {};
    return {.report = [this](std::string_view stage, double share) { hear(stage, share); },
            .cancelled = [this] { return is_stopped(); }};
  }

 private:
  using Clock = std::chrono::steady_clock;

  void hear(std::string_view stage, double share) {
    stage_ = stage;
    share_ = share;
    ask();
  }
  bool is_stopped() {
    constexpr std::chrono::milliseconds kPace(50);
    if (!stopped_ && Clock::now() - asked_ >= kPace) ask();
    return stopped_;
  }
  void ask() {
    if (stopped_) return;
    stopped_ = options_.progress(options_.user, stage_.c_str(), share_) != 0;
    asked_ = Clock::now();
  }

  const planish_options& options_;
  std::string stage_;
  double share_ = 0.0;
  bool stopped_ = false;
  Clock::time_point asked_;
};

/// The options of a caller that may know fewer members, or more, than this library.
planish::Result<planish_options> read_options(const planish_options* given) {
  planish_options options = PLANISH_OPTIONS_INIT;
  if (!given) return options;
  if (given->size < sizeof options)
    return planish::fail(planish::refuse::options_too_short,
                         {{"least", sizeof options}, {"size", given->size}},
                         "planish_options.size");
  options = *given;
  if (options.where != PLANISH_APART && options.where != PLANISH_HERE)
    return planish::fail(planish::refuse::where_unknown, {}, "planish_options.where");
  if (!(options.time_limit >= 0.0 && options.time_limit <= kLongestTime))
    return planish::fail(planish::refuse::time_limit_wrong, {}, "planish_options.time_limit");
  return options;
}

process::Limits limits_of(const planish_options& options) {
  process::Limits limits;
  if (options.time_limit > 0.0)
    limits.time = std::chrono::ceil<std::chrono::milliseconds>(
        std::chrono::duration<double>(options.time_limit));
  if (options.memory_limit > 0) limits.memory = options.memory_limit;
  if (options.memory_limit == UINT64_MAX) limits.memory = 0;
  return limits;
}

job::Outcome<job::RunResult> run(const char* request, const planish_options* given) {
  if (!request) return planish::fail(planish::refuse::no_request);
  const auto options = read_options(given);
  if (!options) return pass_on(options);
  Caller caller(*options);
  if (options->where == PLANISH_HERE) return job::run(request, caller.progress());
  return job::run_apart(request, caller.progress(), limits_of(*options));
}

void run_into(planish_result& result, const char* request, const planish_options* options) {
  try {
    auto made = run(request, options);
    if (!made) set_error(result, made.error());
    if (auto told = shown(std::move(made))) set_result(result, std::move(*told));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& defect) {
    set_error(result, planish::error_of(planish::refuse::defect, {{"reason", defect.what()}}));
  } catch (...) {
    set_error(result, planish::error_of(planish::refuse::defect,
                                        {{"reason", "An exception of unknown type"}}));
  }
}

/// What is returned where there is no memory for a result.
planish_result& no_memory() {
  static planish_result result = [] {
    planish_result none;
    set_error(none, planish::error_of(planish::refuse::no_memory, {}));
    return none;
  }();
  return result;
}
// Made while there is memory.
[[maybe_unused]] const planish_result& kNoMemory = no_memory();

/// Texts that do not change, made when first asked for and never freed.
struct Texts {
  std::vector<std::string> names = job::schema_names();
  std::map<std::string, std::string> schemas;
  std::string catalogue = job::catalogue_json();

  Texts() {
    for (const std::string& name : names)
      schemas[name] = job::schema_text(name);
  }
};

/// Null where there is no memory for them.
const Texts* texts() {
  try {
    static const Texts* const all = new Texts();
    return all;
  } catch (...) {
    return nullptr;
  }
}

}  // namespace

const char* planish_version(void) { return PLANISH_VERSION; }

int planish_abi(void) { return PLANISH_ABI; }

planish_result* planish_run(const char* request, const planish_options* options) {
  try {
    // Otherwise another thread could be making them when the process is copied.
    (void)texts();
    auto result = std::make_unique<planish_result>();
    run_into(*result, request, options);
    return result.release();
  } catch (...) {
    return &no_memory();
  }
}

void planish_result_free(planish_result* result) {
  if (result != &no_memory()) delete result;
}

int planish_result_status(const planish_result* result) { return result->status; }

const char* planish_result_report(const planish_result* result) { return result->report.c_str(); }

const char* planish_result_summary(const planish_result* result) { return result->summary.c_str(); }

const char* planish_result_error_code(const planish_result* result) { return result->code.c_str(); }

const char* planish_result_error_message(const planish_result* result) {
  return result->message.c_str();
}

const char* planish_result_error_where(const planish_result* result) {
  return result->where.c_str();
}

int planish_result_exit_status(const planish_result* result) { return result->exit_status; }

size_t planish_result_artifact_count(const planish_result* result) {
  return result->artifacts.size();
}

const planish_artifact* planish_result_artifact(const planish_result* result, size_t number) {
  return number < result->artifacts.size() ? &result->artifacts[number] : nullptr;
}

size_t planish_schema_count(void) { return texts() ? texts()->names.size() : 0; }

const char* planish_schema_name(size_t number) {
  return number < planish_schema_count() ? texts()->names[number].c_str() : nullptr;
}

const char* planish_schema(const char* name) {
  if (!name || !texts()) return nullptr;
  const auto& schemas = texts()->schemas;
  const auto found = std::ranges::find_if(schemas,
                                          [&](const auto& one) { return one.first == name; });
  return found == schemas.end() ? nullptr : found->second.c_str();
}

const char* planish_catalogue(void) { return texts() ? texts()->catalogue.c_str() : ""; }
