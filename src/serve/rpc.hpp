#pragma once

#include "framing.hpp"

#include <planish/base/result.hpp>

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>

namespace planish::serve {

using Json = nlohmann::ordered_json;

/// One line; bytes that are not UTF-8 become U+FFFD.
std::string text_of(const Json& json);

/// Codes of JSON-RPC 2.0, those that it leaves to the server, and one of the Language Server
/// Protocol.
enum class RpcCode {
  parse_error = -32700,
  invalid_request = -32600,
  method_not_found = -32601,
  invalid_params = -32602,
  failed = -32000,
  cancelled = -32800,
};

struct RpcError {
  RpcCode code = RpcCode::failed;
  std::string message;
  Json data = {};  ///< null: none
};

/// An error of Planish, with its code and place as data.
RpcError rpc_error(const Error& error);
/// Whether the request is at fault, not the input or the work.
bool is_of_request(const Error& error);

/// `result` is JSON text.
std::string response(const Json& id, const std::string& result);
std::string response(const Json& id, const RpcError& error);
std::string notification(const std::string& method, const Json& params);

/// Where the answer of one request goes; called once, with nothing if there is none.
using Sink = std::function<void(std::optional<std::string>)>;

/// Answers go out as they come.
Sink single_sink(MessageWriter& writer);
/// The answers of the `count` members of a list go out together, when all are there.
Sink list_sink(MessageWriter& writer, std::size_t count);

}  // namespace planish::serve
