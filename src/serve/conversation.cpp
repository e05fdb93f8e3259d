#include "conversation.hpp"

#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/schema/fail_at.hpp>
#include <planish/schema/json_depth.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

// What is said over standard input and output: JSON-RPC, and Model Context Protocol on top of it
// (serve.md). Requests are read one after the other and answered in any order. Each with an id has
// one answer, or none once the client says that it wants none; so an id in use is refused, and a
// cancelled request answers at once. Files are written after the work, unless it was cancelled at
// the last moment.

namespace planish::serve {
namespace {

const Json kNoId;

RpcError wrong(RpcCode code, std::string sentence, std::string where = {}) {
  const char* const name = code == RpcCode::method_not_found ? "unknown_method" : "bad_request";
  return {code, std::move(sentence), {{"code", name}, {"where", std::move(where)}}};
}

/// Why a message is no request; empty if it is one.
std::optional<RpcError> mistake_in(const Json& message) {
  const auto invalid = [](const char* sentence, const char* where) {
    return wrong(RpcCode::invalid_request, sentence, where);
  };
  if (!message.is_object()) return invalid("a request must be a JSON object", "");
  if (message.value("jsonrpc", Json()) != "2.0")
    return invalid("/jsonrpc must be \"2.0\"", "/jsonrpc");
  if (!message.contains("method") || !message["method"].is_string())
    return invalid("/method must be a text", "/method");
  if (const Json id = message.value("id", Json());
      !id.is_null() && !id.is_string() && !id.is_number())
    return invalid("/id must be a text or a number", "/id");
  return std::nullopt;
}

/// An answer of the client's, who was asked nothing.
bool is_answer(const Json& message) {
  return message.is_object() && !message.contains("method") &&
         (message.contains("result") || message.contains("error"));
}

/// The seconds that are asked for a search, which are allowed beside those for all else.
std::chrono::milliseconds search_time(const Json& parameters) {
  constexpr double kMilli = 1000.0, kDay = 86400.0;
  const Json options = parameters.value("options", Json());
  if (!options.is_object()) return {};
  const Json seconds = options.value("search_time", Json());
  if (!seconds.is_number()) return {};
  return std::chrono::milliseconds(
      static_cast<std::int64_t>(kMilli * std::clamp(seconds.get<double>(), 0.0, kDay)));
}

/// Paths in "write"; the error of what is none.
Result<std::vector<std::pair<std::string, std::string>>> writes_in(const Json& parameters,
                                                                   const Tool& tool) {
  std::vector<std::pair<std::string, std::string>> writes;
  if (!parameters.contains("write")) return writes;
  const Json known = tool.schema["properties"].value("write", Json());
  if (known.is_null())
    return schema::fail_at(refuse::writes_nothing, "/write", {{"tool", tool.name}});
  const Json& given = parameters["write"];
  if (!given.is_object()) return schema::fail_at(refuse::writes_no_object, "/write");
  for (const auto& [artifact, path] : given.items()) {
    if (!path.is_string() || path.get<std::string>().empty() || path == "-")
      return schema::fail_at(refuse::no_path, "/write/" + artifact);
    writes.emplace_back(artifact, path.get<std::string>());
  }
  return writes;
}

bool is_progress_token(const Json& token) { return token.is_string() || token.is_number(); }

}  // namespace

Conversation::Conversation(MessageWriter& writer, const ServeOptions& options,
                           const job::Catalogue& catalogue)
    : writer_(writer),
      options_(options),
      catalogue_(catalogue),
      tools_(tools_of(catalogue)),
      protocol_(protocol_version("")),
      crew_(options.jobs, options.limits) {}

void Conversation::refuse(const Error& error) {
  writer_.send(response(kNoId, wrong(RpcCode::parse_error, error.message)));
}

void Conversation::take(const std::string& message) {
  if (const auto byte = schema::too_deep_at(message))
    return refuse(schema::too_deep(message, *byte, "The message", ":"));
  Json json;
  try {
    json = Json::parse(message);
  } catch (const Json::parse_error& error) {
    return refuse(schema::not_json(message, error.byte, "The message", ":"));
  }
  if (!json.is_array()) return take_one(json, single_sink(writer_));
  if (json.empty())
    return writer_.send(
        response(kNoId, wrong(RpcCode::invalid_request, "a list of requests must not be empty")));
  const Sink sink = list_sink(writer_, json.size());
  for (const Json& one : json)
    take_one(one, sink);
}

void Conversation::take_one(const Json& message, const Sink& sink) {
  if (is_answer(message)) return sink(std::nullopt);
  if (const auto mistake = mistake_in(message)) return sink(response(kNoId, *mistake));
  Call call{.id = message.contains("id") ? std::optional(message["id"]) : std::nullopt,
            .method = message["method"].get<std::string>(),
            .parameters = message.value("params", Json()),
            .sink = sink};
  if (call.parameters.is_null()) call.parameters = Json::object();
  if (!call.parameters.is_object()) {
    if (!call.id) return sink(std::nullopt);
    return sink(response(*call.id, wrong(RpcCode::invalid_params, "/params must be an object")));
  }
  if (call.id) return take_request(call);
  take_notification(call);
}

void Conversation::take_notification(const Call& call) {
  const Json& said = call.parameters;
  if (call.method == "exit") exit_ = shut_down_ ? 0 : 1;
  if (call.method == "$/cancelRequest") cancel(said.value("id", Json()), false);
  if (call.method == "notifications/cancelled") cancel(said.value("requestId", Json()), true);
  const Tool* const one = tool(call.method);
  if (!one || !one->works || shut_down_) return call.sink(std::nullopt);
  // What nobody waits for is done all the same: it may write files.
  begin_work(call, *one, said, {});
}

void Conversation::take_request(const Call& call) {
  const auto answer = [&](const Json& result) { call.sink(response(*call.id, text_of(result))); };
  if (shut_down_)
    return call.sink(response(
        *call.id, wrong(RpcCode::invalid_request, "after `shutdown` only `exit` is accepted")));
  if (call.method == "ping") return answer(Json::object());
  if (call.method == "shutdown") {
    shut_down_ = true;
    return answer(nullptr);
  }
  if (call.method == "initialize") {
    const Json wanted = call.parameters.value("protocolVersion", Json());
    protocol_ = protocol_version(wanted.is_string() ? wanted.get<std::string>() : "");
    return answer(introduction(protocol_, options_.version));
  }
  if (call.method == "tools/list") return answer(tool_list(tools_));
  if (call.method == "tools/call") return call_tool(call);
  const Tool* const one = tool(call.method);
  if (!one)
    return call.sink(response(
        *call.id,
        wrong(RpcCode::method_not_found, fmt::format("there is no method {}; see docs/serve.md",
                                                     text_of(shortened(call.method))))));
  if (!one->works) {
    const auto result = answer_at_once(one->name, call.parameters, catalogue_);
    if (!result) return call.sink(response(*call.id, rpc_error(result.error())));
    return answer(*result);
  }
  begin_work(
      call, *one, call.parameters,
      {.done = [](const WorkDone& done) { return done.result; },
       .failed = [](const Json& id, const Error& error) { return response(id, rpc_error(error)); },
       .progress =
           [](const Json& id, std::string_view stage, double share) {
             return notification("$/progress", {{"id", id}, {"stage", stage}, {"done", share}});
           }});
}

void Conversation::call_tool(const Call& call) {
  const Json name = call.parameters.value("name", Json());
  const Tool* const one = name.is_string() ? tool(name.get<std::string>()) : nullptr;
  Json arguments = call.parameters.value("arguments", Json());
  if (arguments.is_null()) arguments = Json::object();
  if (!one || !arguments.is_object())
    return call.sink(response(
        *call.id, one ? wrong(RpcCode::invalid_params, "/arguments must be an object", "/arguments")
                      : wrong(RpcCode::invalid_params,
                              fmt::format("there is no tool {}", text_of(name)), "/name")));
  const auto failed = [](const Json& id, const Error& error) {
    return response(id, call_result(error));
  };
  if (!one->works) {
    const auto result = answer_at_once(one->name, arguments, catalogue_);
    if (!result) return call.sink(failed(*call.id, result.error()));
    return call.sink(response(*call.id, call_result(*result)));
  }
  Wording wording{
      .done = [protocol = protocol_](const WorkDone& done) { return call_result(done, protocol); },
      .failed = failed,
      .progress = {}};
  const Json about = call.parameters.value("_meta", Json());
  const Json token = about.is_object() ? about.value("progressToken", Json()) : Json();
  if (is_progress_token(token))
    // It may only grow.
    wording.progress = [token, last = std::make_shared<double>(-1.0)](
                           const Json&, std::string_view stage, double share) -> std::string {
      if (share <= *last) return {};
      *last = share;
      return notification(
          "notifications/progress",
          {{"progressToken", token}, {"progress", share}, {"total", 1}, {"message", stage}});
    };
  begin_work(call, *one, std::move(arguments), std::move(wording));
}

void Conversation::begin_work(const Call& call, const Tool& asked, Json parameters,
                              Wording wording) {
  const auto fails = [&](const Error& error) {
    return call.sink(call.id && wording.failed ? std::optional(wording.failed(*call.id, error))
                                               : std::nullopt);
  };
  auto writes = writes_in(parameters, asked);
  if (!writes) return fails(writes.error());
  for (const char* key : {"write", "_meta"})
    parameters.erase(key);
  if (parameters.contains("maker")) return fails(schema::error_at(refuse::maker_given, "/maker"));
  parameters["maker"] = asked.name;
  const auto ticket = std::make_shared<Ticket>();
  ticket->task = {text_of(parameters), std::move(*writes)};
  ticket->time = options_.limits.time + search_time(parameters);
  if (call.id) {
    const std::lock_guard lock(mutex_);
    if (!at_work_.emplace(text_of(*call.id), AtWork{ticket}).second)
      return call.sink(response(
          kNoId, wrong(RpcCode::invalid_request,
                       fmt::format("the id {} belongs to a request that is not answered yet",
                                   text_of(*call.id)),
                       "/id")));
    if (wording.progress)
      ticket->progress = [this, id = *call.id, tell = wording.progress](std::string_view stage,
                                                                        double share) {
        if (const std::string told = tell(id, stage, share); !told.empty()) writer_.send(told);
      };
  }
  ticket->done = [this, call, wording = std::move(wording)](Result<WorkDone> done) {
    finish(call, wording, std::move(done));
  };
  crew_.add(ticket);
}

void Conversation::finish(const Call& call, const Wording& wording, Result<WorkDone> done) {
  bool silent = !call.id;
  if (call.id) {
    const std::lock_guard lock(mutex_);
    const auto found = at_work_.find(text_of(*call.id));
    silent = found->second.silent;
    // Cancelled at the last moment.
    if (found->second.ticket->cancelled) done = fail(refuse::stopped);
    at_work_.erase(found);
  }
  if (done && !done->files.empty())
    if (auto written = write_files(done->files); !written) done = pass_on(written);
  if (silent) return call.sink(std::nullopt);
  call.sink(done ? response(*call.id, wording.done(*done))
                 : wording.failed(*call.id, done.error()));
}

void Conversation::cancel(const Json& id, bool silent) {
  const std::lock_guard lock(mutex_);
  const auto found = at_work_.find(text_of(id));
  if (found == at_work_.end()) return;
  found->second.silent = found->second.silent || silent;
  found->second.ticket->cancelled = true;
}

const Tool* Conversation::tool(const std::string& name) const {
  const auto found = std::ranges::find(tools_, name, &Tool::name);
  return found == tools_.end() ? nullptr : &*found;
}

}  // namespace planish::serve
