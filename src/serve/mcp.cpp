#include "mcp.hpp"

#include <planish/job/reason.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>

// Answers in the form of Model Context Protocol (serve.md#model-context-protocol): tools with their
// JSON Schemas, results as text for people and as structured content for programs. Versions are
// dates, so their texts compare; clients from before structured content get it as a second text.

namespace planish::serve {
namespace {

constexpr std::array<std::string_view, 3> kProtocols{"2024-11-05", "2025-03-26", kStructured};

constexpr auto kInstructions =
    "Planish lays sheet metal flat: it unfolds STEP files, joins plates by bends, makes "
    "transitions "
    "and slit sheets, and plans the order of bends. Give `input` as a path, and `write` to get "
    "files on disk; relative paths start where the server was started. A refusal names what is "
    "wrong, where, and what would be possible.";

Json text_item(const std::string& text) { return {{"type", "text"}, {"text", text}}; }

}  // namespace

std::string protocol_version(const std::string& wanted) {
  const bool known = std::ranges::find(kProtocols, wanted) != kProtocols.end();
  return known ? wanted : std::string(kProtocols.back());
}

Json introduction(const std::string& protocol, const std::string& version) {
  return {{"protocolVersion", protocol},
          {"capabilities", {{"tools", {{"listChanged", false}}}}},
          {"serverInfo", {{"name", "planish"}, {"title", "Planish"}, {"version", version}}},
          {"instructions", kInstructions}};
}

Json tool_list(const std::vector<Tool>& tools) {
  Json list = Json::array();
  for (const Tool& tool : tools) {
    const bool writes = tool.schema["properties"].contains("write");
    list.push_back({{"name", tool.name},
                    {"description", tool.description},
                    {"inputSchema", tool.schema},
                    {"annotations", {{"readOnlyHint", !writes}, {"openWorldHint", false}}}});
  }
  return {{"tools", std::move(list)}};
}

std::string call_result(const WorkDone& done, const std::string& protocol) {
  Json content = Json::array({text_item(done.summary)});
  // Where nothing else holds the report.
  if (protocol < kStructured) content.push_back(text_item(done.result));
  return fmt::format(R"({{"content":{},"structuredContent":{},"isError":{}}})", text_of(content),
                     done.result, done.refused);
}

std::string call_result(const Json& answer) {
  return text_of({{"content", Json::array({text_item(answer.dump(1))})},
                  {"structuredContent", answer},
                  {"isError", false}});
}

std::string call_result(const Error& error) {
  std::string said = fmt::format("[{}] {}", code_name(error.code), error.message);
  if (!error.where.empty() && error.message.find(error.where) == std::string::npos)
    said += fmt::format(" ({})", error.where);
  return text_of({{"content", Json::array({text_item(said)})},
                  {"structuredContent", Json::parse(job::reason_text(error))},
                  {"isError", true}});
}

}  // namespace planish::serve
