#include "description.hpp"

#include "../work/json_text.hpp"

#include <planish/base/text.hpp>

namespace planish::studio {
namespace {

std::string_view kind_name(job::OptionKind kind) {
  return word_of(kind, {"flag", "number", "whole", "word", "face", "name", "file", "by_bend"});
}

Json option_json(const job::OptionUse& use) {
  const job::Option& option = use.entry();
  return {{"name", option.name},
          {"kind", kind_name(option.kind)},
          {"group", job::heading(option.group)},
          {"description", option.description},
          {"default", use.otherwise.empty() ? option.otherwise : use.otherwise},
          {"words", option.words}};
}

Json maker_json(const job::Catalogue& catalogue, const job::Maker& maker) {
  Json json{{"name", maker.name},
            {"description", maker.description},
            {"input", maker.input_kind()},
            {"editable", !maker.format.empty()},
            {"names_files", maker.named_files != nullptr},
            {"options", Json::array()},
            {"artifacts", Json::array()}};
  for (const job::OptionUse& use : maker.options)
    json["options"].push_back(option_json(use));
  for (const job::Artifact* artifact : catalogue.written_by(maker))
    json["artifacts"].push_back(artifact->name);
  return json;
}

}  // namespace

Answer description(const job::Catalogue& catalogue) {
  Json json{{"makers", Json::array()}, {"artifacts", Json::array()}};
  for (const job::Maker& maker : catalogue.makers)
    json["makers"].push_back(maker_json(catalogue, maker));
  for (const job::Artifact& artifact : catalogue.artifacts)
    json["artifacts"].push_back({{"name", artifact.name},
                                 {"role", job::role_name(artifact.role)},
                                 {"suffix", artifact.suffix},
                                 {"media_type", artifact.media_type},
                                 {"description", artifact.description}});
  return {200, kJsonType, json_text(json)};
}

}  // namespace planish::studio
