#include "api.hpp"
#include "embedded.hpp"

#include <planish/base/text.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace planish::studio {
namespace {

constexpr std::string_view kFolder = "examples/";

std::string kind_of(std::string_view name) {
  if (name.ends_with(".step")) return "unfold";
  return name.ends_with(".json") ? std::string(name.substr(0, name.find('/'))) : "";
}

/// "Square to round" for "transition/a_square_to_round.json"; letters that only order the files are
/// left out.
std::string title_of(std::string_view name) {
  name.remove_prefix(name.rfind('/') == std::string_view::npos ? 0 : name.rfind('/') + 1);
  name = name.substr(0, name.rfind('.'));
  if (name.size() > 2 && name[1] == '_') name.remove_prefix(2);
  std::string title = capitalized(std::string(name));
  std::ranges::replace(title, '_', ' ');
  return title;
}

}  // namespace

Answer example_list() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const EmbeddedFile& file : embedded_files()) {
    if (!file.name.starts_with(kFolder)) continue;
    const std::string_view name = file.name.substr(kFolder.size());
    if (const std::string kind = kind_of(name); !kind.empty())
      list.push_back({{"name", name}, {"kind", kind}, {"title", title_of(name)}});
  }
  return {200, kJsonType, list.dump()};
}

}  // namespace planish::studio
