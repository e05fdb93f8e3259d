#include "readers.hpp"

#include <planish/job/artifact.hpp>
#include <planish/job/slit_json.hpp>
#include <planish/sheet/allowance.hpp>
#include <planish/shop/rules_json.hpp>
#include <planish/shop/tools_json.hpp>

namespace planish::fuzz {

std::optional<Error> read_step_and_unfold(const std::string& text, const Progress& progress) {
  const job::Maker& maker = *job::built_in().maker("unfold");
  const auto work = maker.open({"input.step", text, std::nullopt}, progress);
  if (!work) return work.error();
  job::Request request;
  request.input = "input.step";
  request.body = "1";
  const auto made = shown((*work)->make(request, progress));
  if (!made) return made.error();
  const std::string report = (*made)->json() + (*made)->text();
  if ((*made)->report().refusal) return (*made)->report().refusal;
  for (const char* name : {"dxf", "svg"}) {
    const job::Artifact* artifact = job::built_in().artifact(maker, name);
    const auto bytes = artifact->write(**made, 0, request);
    if (!bytes) return bytes.error();
  }
  return std::nullopt;
}

namespace {

/// A channel with lips, 1 mm thick.
constexpr auto kChannel = R"({ "thickness": 1, "defaults": { "inside_radius": 1 },
  "plates": [
    { "id": "web", "outline": [[5, 0, 0], [55, 0, 0], [55, 80, 0], [5, 80, 0]] },
    { "id": "left", "outline": [[0, 0, 5], [0, 80, 5], [0, 80, 25], [0, 0, 25]] },
    { "id": "right", "outline": [[60, 0, 5], [60, 80, 5], [60, 80, 25], [60, 0, 25]] },
    { "id": "lip", "outline": [[5, 0, 30], [5, 80, 30], [15, 80, 30], [15, 0, 30]] } ],
  "bends": [ { "between": ["web", "left"] }, { "between": ["web", "right"] },
             { "between": ["left", "lip"] } ] })";

bool is_of_tools(const std::string& text) {
  return text.find("planish/tools") != std::string::npos;
}

}  // namespace

std::optional<Error> read_json(const std::string& text, const Progress& progress) {
  (void)shop::parse_rules(text, "input.json");
  if (is_of_tools(text)) {
    const auto tools = shop::parse_tools(text, "input.json");
    return tools ? std::nullopt : std::optional(tools.error());
  }
  const auto maker = job::built_in().maker_for("input.json", text);
  if (!maker) return maker.error();
  const auto work = (*maker)->open({"input.json", text, std::nullopt}, progress);
  return work ? std::nullopt : std::optional(work.error());
}

std::optional<Error> make_json(const std::string& text, const Progress& progress) {
  job::Request request;
  request.input = "input.json";
  request.effort = job::Effort::draft;
  if (is_of_tools(text)) {
    auto tools = shop::parse_tools(text, "input.json");
    if (!tools) return tools.error();
    request.bending.tools = std::move(*tools);
    request.bending.ask = job::Bending::Ask::plan;
    request.bending.plan.limits.seconds = 1.0;
    request.effort = job::Effort::full;
  }
  const std::string input = is_of_tools(text) ? kChannel : text;
  const auto maker = job::built_in().maker_for("input.json", input);
  if (!maker) return maker.error();
  const auto work = (*maker)->open({"input.json", input, std::nullopt}, progress);
  if (!work) return work.error();
  const auto made = shown((*work)->make(request, progress));
  if (!made) return made.error();
  const std::string report = (*made)->json() + (*made)->text();
  return (*made)->report().refusal;
}

std::optional<Error> read_table(const std::string& text) {
  const auto points = job::parse_points(text, "input.xyz", 1.0);
  const auto table = parse_bend_table(text, "input.csv");
  if (!table) return table.error();
  return points ? std::nullopt : std::optional(points.error());
}

}  // namespace planish::fuzz
