#pragma once

#include "rpc.hpp"
#include "served_work.hpp"
#include "tools.hpp"

#include <string>
#include <vector>

namespace planish::serve {

// What Model Context Protocol says differently: docs/serve.md#model-context-protocol.

/// A version of the protocol; those since `kStructured` read "structuredContent".
inline constexpr std::string_view kStructured = "2025-06-18";

/// The version that is spoken with a client that asks for `wanted`.
std::string protocol_version(const std::string& wanted);

/// The answer to `initialize`.
Json introduction(const std::string& protocol, const std::string& version);

/// The answer to `tools/list`.
Json tool_list(const std::vector<Tool>& tools);

/// The answer to `tools/call`, JSON text: of a tool that works, of one that is answered at once,
/// and of an error, which the model is to read and to do better.
std::string call_result(const WorkDone& done, const std::string& protocol);
std::string call_result(const Json& answer);
std::string call_result(const Error& error);

}  // namespace planish::serve
