#pragma once

#include <planish/job/artifact.hpp>

#include <string>
#include <vector>

namespace planish::job {

/// Names of all schemas: those of the makers' inputs, "rules", "material", "tools", "request", and
/// the outputs "report", "summary", "info".
std::vector<std::string> schema_names(const Catalogue& catalogue = built_in());

/// JSON Schema (2020-12) as text; empty for an unknown name.
std::string schema_text(const std::string& name, const Catalogue& catalogue = built_in());

/// Schema of a request to one maker or for one task ("bend"), without the key "maker"; empty for an
/// unknown name.
std::string request_schema_text(const std::string& maker, const Catalogue& catalogue = built_in());

/// The tables of `planish --formats` as JSON: {"makers": [...], "artifacts": [...]}.
std::string catalogue_json(const Catalogue& catalogue = built_in());

}  // namespace planish::job
