#pragma once

#include <planish/base/result.hpp>
#include <planish/inspect/findings.hpp>

#include <string>

namespace planish::shop {

/// Rules of manufacture as the JSON text of a rules file: one key for each of `rule_fields`, and
/// "enabled", "strict", "sources" (of the thresholds), "format" ("planish/rules") and "version"
/// (1).
std::string rules_json(const Rules& rules);

/// Reads a rules file. Thresholds left out are those of `usual`; `strict` is set unless the file
/// says otherwise, for a shop's own limits are meant as written. Errors: `invalid_input` for
/// anything that is not JSON (`where` is name:line:column), unknown keys, and values other than
/// numbers ≥ 0 (`where` is name and JSON pointer).
Result<Rules> parse_rules(const std::string& json, const std::string& name,
                          const Rules& usual = {});

}  // namespace planish::shop
