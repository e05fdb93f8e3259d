#include <planish/job/run.hpp>
#include <planish/schema/json_parts.hpp>

namespace planish::job {
using namespace schema;
namespace {

Json json_of(bool value) { return value; }
Json json_of(double value) { return value; }
Json json_of(const std::string& value) { return value; }
Json json_of(const OptionFile& file) { return {{"name", file.name}, {"content", file.text}}; }
Json json_of(const std::vector<std::pair<std::string, double>>& numbers) {
  Json json = Json::object();
  for (const auto& [id, value] : numbers)
    json[id] = value;
  return json;
}

}  // namespace

std::string options_json(const OptionValues& values) {
  Json json = Json::object();
  for (const auto& [option, value] : values.all())
    json[std::string(option->name)] = std::visit([](const auto& one) { return json_of(one); },
                                                 value);
  return json.dump();
}

}  // namespace planish::job
