#include "makers.hpp"
#include "report_schema.hpp"
#include "request_schema.hpp"

#include <planish/job/schemas.hpp>
#include <planish/shop/schemas.hpp>

#include <algorithm>
#include <optional>

namespace planish::job {
using namespace shop;
using namespace schema;
namespace {

std::optional<Schema> schema_named(const std::string& name, const Catalogue& catalogue) {
  for (const Maker& maker : catalogue.makers)
    if (maker.schema && name == maker.schema_name()) return maker.schema();
  if (name == "rules") return rules_schema();
  if (name == "material") return material_schema();
  if (name == "tools") return tools_schema();
  if (name == "shop") return shop_schema();
  if (name == "request") return request_schema(catalogue);
  if (name == "report") return report_schema(catalogue);
  if (name == "summary") return summary_schema(catalogue);
  if (name == "info") return info_schema();
  return std::nullopt;
}

}  // namespace

std::vector<std::string> schema_names(const Catalogue& catalogue) {
  std::vector<std::string> names;
  for (const Maker& maker : catalogue.makers)
    if (maker.schema) names.push_back(maker.schema_name());
  for (const char* name :
       {"rules", "material", "tools", "shop", "request", "report", "summary", "info"})
    names.emplace_back(name);
  return names;
}

std::string schema_text(const std::string& name, const Catalogue& catalogue) {
  const auto schema = schema_named(name, catalogue);
  if (!schema) return {};
  return text_of(json_schema(*schema, "planish/" + name, name + ".json"));
}

std::string request_schema_text(const std::string& maker, const Catalogue& catalogue) {
  if (!catalogue.task(maker)) return {};
  return text_of(json_schema(request_schema(maker, catalogue), "planish/request of " + maker,
                             "request-" + maker + ".json"));
}

std::string catalogue_json(const Catalogue& catalogue) {
  Json makers = Json::array(), artifacts = Json::array();
  for (const Maker& maker : catalogue.makers) {
    Json row{{"name", maker.name},
             {"description", maker.description},
             {"input", maker.input_kind()},
             {"artifacts", Json::array()},
             {"options", Json::array()}};
    if (maker.schema) row["schema"] = maker.schema_name();
    for (const Artifact* artifact : catalogue.written_by(maker))
      row["artifacts"].push_back(artifact->name);
    for (const OptionUse& use : maker.options)
      row["options"].push_back(use.name);
    makers.push_back(std::move(row));
  }
  for (const Artifact& artifact : catalogue.artifacts)
    artifacts.push_back({{"name", artifact.name},
                         {"shows", role_name(artifact.role)},
                         {"suffix", artifact.suffix},
                         {"media_type", artifact.media_type},
                         {"description", artifact.description}});
  return text_of({{"makers", std::move(makers)}, {"artifacts", std::move(artifacts)}});
}

}  // namespace planish::job
