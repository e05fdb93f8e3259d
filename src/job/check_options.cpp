// What the shop asks of a pattern: its materials and those of parts, the rules of manufacture and
// their limits.
#include "option_tables.hpp"
#include "taken_shop.hpp"

#include <planish/shop/rules_json.hpp>

#include <filesystem>

namespace planish::job {
using namespace shop;
using namespace schema;
namespace {

Result<void> set_shop(Request& to, const OptionValue& value) {
  auto shop = parse_shop(file_of(value).text, file_of(value).name);
  if (!shop) return pass_on(shop);
  take_shop(to, std::move(*shop));
  return {};
}

Result<void> set_materials(Request& to, const OptionValue& value) {
  const std::string name = std::filesystem::path(file_of(value).name).filename().string();
  auto materials = PartMaterials::parse(file_of(value).text, name);
  if (!materials) return pass_on(materials);
  to.materials = std::move(*materials);
  return {};
}

Result<void> set_process(Request& to, const OptionValue& value) {
  to.rules = rules_for(given_text(value) == "punch" ? Process::punch : Process::laser);
  return {};
}

Result<void> set_rules(Request& to, const OptionValue& value) {
  const auto rules = parse_rules(file_of(value).text, file_of(value).name, to.rules);
  if (!rules) return pass_on(rules);
  to.rules = *rules;
  return {};
}

Result<void> set_no_rules(Request& to, const OptionValue& value) {
  to.rules.enabled = !yes(value);
  return {};
}

}  // namespace

const std::vector<Option>& shop_options() {
  static const std::vector<Option> table = joined({
      {OptionGroup::shop,
       {
           row::file("shop", "FILE.json", "shop profile",
                     "shop profile: stocked materials with radius and K, layers, limits, tools; "
                     "other options override it",
                     set_shop),
           row::file("materials", "FILE.csv", "list of materials",
                     "material, and if wanted density and quantity, of each part by its name or "
                     "colour; all others are of `material`",
                     set_materials),
       }},
  });
  return table;
}

const std::vector<Option>& check_options() {
  static const std::vector<Option> table = joined({
      {OptionGroup::checks,
       {
           row::word("process", {"laser", "punch"}, "laser",
                     "how openings and contours are cut; sets the limits of the rules",
                     set_process),
           row::file("rules", "FILE.json", "rules file",
                     "limits of the rules of manufacture, instead of those of the process",
                     set_rules),
           row::flag("no_rules", "do not check the rules of manufacture", set_no_rules),
           row::flag("write_overlapping", "write the pattern even if it overlaps itself",
                     stored<&Request::write_overlapping>),
           row::flag("write_anyway", "write the files even if a check finds an error",
                     stored<&Request::write_anyway>),
           row::number("density", kAboveZero, "kg/dm³, for the mass: steel 7.85, aluminium 2.70",
                       stored<&Request::density>),
       }},
  });
  return table;
}

}  // namespace planish::job
