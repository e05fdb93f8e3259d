#include "rpc.hpp"

#include <planish/job/reason.hpp>

#include <algorithm>
#include <mutex>

// Answers in the form of JSON-RPC 2.0. An error is the request's where its place is a field of the
// request or an option; else the work failed. The answers to a list of requests wait for each
// other, and a list of notifications has none.

namespace planish::serve {
namespace {

/// Answers that wait for each other.
class AnswerList {
 public:
  AnswerList(MessageWriter& writer, std::size_t count) : writer_(writer), open_(count) {}

  void put(const std::optional<std::string>& answer) {
    const std::lock_guard lock(mutex_);
    if (answer) answers_ += (answers_.empty() ? "" : ",") + *answer;
    if (--open_ == 0 && !answers_.empty()) writer_.send("[" + answers_ + "]");
  }

 private:
  MessageWriter& writer_;
  std::mutex mutex_;
  std::size_t open_;
  std::string answers_;
};

}  // namespace

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_of_request(const Error& error) {
  // Of a file, `where` is its name before the pointer.
  const bool of_field = std::ranges::any_of(
      error.places, [&](const Place& place) { return place == place::pointer(error.where); });
  return error.code.status == ExitStatus::usage || (error.code == code::invalid_input && of_field);
}

RpcError rpc_error(const Error& error) {
  const RpcCode code = error.code == code::cancelled ? RpcCode::cancelled
                       : is_of_request(error)        ? RpcCode::invalid_params
                                                     : RpcCode::failed;
  Json data = Json::parse(job::reason_text(error));
  data.erase("message");
  return {code, error.message, std::move(data)};
}

std::string response(const Json& id, const std::string& result) {
  return R"({"jsonrpc":"2.0","id":)" + text_of(id) + R"(,"result":)" + result + "}";
}

std::string response(const Json& id, const RpcError& error) {
  Json told{{"code", static_cast<int>(error.code)}, {"message", error.message}};
  if (!error.data.is_null()) told["data"] = error.data;
  return text_of({{"jsonrpc", "2.0"}, {"id", id}, {"error", std::move(told)}});
}

std::string notification(const std::string& method, const Json& params) {
  return text_of({{"jsonrpc", "2.0"}, {"method", method}, {"params", params}});
}

Sink single_sink(MessageWriter& writer) {
  return [&writer](const std::optional<std::string>& answer) {
    if (answer) writer.send(*answer);
  };
}

Sink list_sink(MessageWriter& writer, std::size_t count) {
  const auto list = std::make_shared<AnswerList>(writer, count);
  return [list](const std::optional<std::string>& answer) { list->put(answer); };
}

}  // namespace planish::serve
