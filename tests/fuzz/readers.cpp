#include "readers.hpp"

#include <planish/job/artifact.hpp>
#include <planish/job/rules_json.hpp>
#include <planish/job/slit_json.hpp>
#include <planish/sheet/allowance.hpp>

namespace planish::fuzz {

std::optional<Error> read_step_and_unfold(const std::string& text, const Progress& progress) {
  const job::Maker& maker = *job::built_in().maker("unfold");
  const auto work = maker.open({"input.step", text, std::nullopt}, progress);
  if (!work) return work.error();
  job::Request request;
  request.input = "input.step";
  request.body = "1";
  const auto made = (*work)->make(request, progress);
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

std::optional<Error> read_json(const std::string& text, const Progress& progress) {
  (void)job::parse_rules(text, "input.json");
  const auto maker = job::built_in().maker_for("input.json", text);
  if (!maker) return maker.error();
  const auto work = (*maker)->open({"input.json", text, std::nullopt}, progress);
  return work ? std::nullopt : std::optional(work.error());
}

std::optional<Error> make_json(const std::string& text, const Progress& progress) {
  const auto maker = job::built_in().maker_for("input.json", text);
  if (!maker) return maker.error();
  const auto work = (*maker)->open({"input.json", text, std::nullopt}, progress);
  if (!work) return work.error();
  job::Request request;
  request.input = "input.json";
  request.effort = job::Effort::draft;
  const auto made = (*work)->make(request, progress);
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
