#include "option_tables.hpp"
#include "refusals.hpp"

#include <planish/shop/tools_json.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace planish::job {
using namespace shop;
using namespace schema;
namespace {

constexpr schema::Range kSpringback{"an angle of at least 0 and below 45 degrees", 0.0, 45.0, true,
                                    false};

struct Weight {
  std::string_view name;
  double StrokeWeights::*value;
};

constexpr std::array kStrokeWeights{
    Weight{"turn_over", &StrokeWeights::turn_over},     Weight{"rotate", &StrokeWeights::rotate},
    Weight{"tool_change", &StrokeWeights::tool_change}, Weight{"stroke", &StrokeWeights::stroke},
    Weight{"ungauged", &StrokeWeights::ungauged},       Weight{"v", &StrokeWeights::v}};

/// What a metal does at the press brake: the upper ends of what shops measure, since tools that
/// bear more do no harm (shop-floor.md#press-brake).
struct Metal {
  std::string_view name;
  double tensile_strength;   ///< N/mm²
  double springback;         ///< degrees
  double radius_of_opening;  ///< inside radius that air bending leaves, per opening of the die
};

constexpr std::array kMetals{Metal{"steel", 450.0, 1.0, 0.16}, Metal{"stainless", 700.0, 3.0, 0.20},
                             Metal{"aluminium", 270.0, 2.0, 0.13}};

std::vector<std::string> words_between(const std::string& text, char separator) {
  std::vector<std::string> words(1);
  for (const char c : text)
    if (c == separator)
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

Result<void> set_tools(Request& to, const OptionValue& value) {
  const OptionFile& file = std::get<OptionFile>(value);
  auto tools = parse_tools(file.text, file.name);
  if (!tools) return pass_on(tools);
  to.bending.tools = std::move(*tools);
  return {};
}

Result<void> set_metal(Request& to, const OptionValue& value) {
  for (const Metal& metal : kMetals) {
    if (metal.name != given_text(value)) continue;
    to.bending.metal = metal.name;
    to.bending.plan.tensile_strength = metal.tensile_strength;
    to.bending.plan.springback = Angle::degrees(metal.springback);
    to.bending.plan.radius_of_opening = metal.radius_of_opening;
  }
  return {};
}

Result<void> set_weights(Request& to, const OptionValue& value) {
  for (const std::string& word : words_between(given_text(value), ',')) {
    const auto equals = word.find('=');
    const auto weight = std::ranges::find(kStrokeWeights, word.substr(0, equals), &Weight::name);
    const auto number = equals == std::string::npos ? std::nullopt
                                                    : parse_number(word.substr(equals + 1));
    if (weight == kStrokeWeights.end() || !number || *number < 0.0)
      return fail(refuse::bad_weights, {{"text", word}}, "weights");
    to.bending.plan.weights.*(weight->value) = *number;
  }
  return {};
}

Result<void> set_v(Request& to, const OptionValue& value) {
  to.bending.plan.v = given_text(value) == "wanted" ? VChoice::wanted : VChoice::any;
  return {};
}

Result<void> set_as_drawn(Request& to, const OptionValue& value) {
  to.bending.plan.radius = std::get<bool>(value) ? RadiusWanted::drawn : RadiusWanted::made;
  return {};
}

Result<void> set_large_radii(Request& to, const OptionValue& value) {
  const std::string& word = given_text(value);
  to.bending.plan.large_radii = word == "v"      ? Forming::over_v
                                : word == "bump" ? Forming::bumps
                                                 : Forming::rolled;
  return {};
}

Result<void> set_fix(Request& to, const OptionValue& value) {
  to.bending.begin_with = words_between(given_text(value), ',');
  return {};
}

}  // namespace

const std::vector<Option>& bending_options() {
  static const std::vector<Option> table = joined({
      {OptionGroup::brake,
       {
           row::flag("check_bending", "check whether a press brake can bend the part",
                     [](Request& to, const OptionValue& value) -> Result<void> {
                       to.bending.ask = std::get<bool>(value) ? Bending::Ask::finding
                                                              : Bending::Ask::nothing;
                       return {};
                     }),
           row::file(
               "tools", "FILE.json", "tools file",
               "press brake and its tools; `planish bend --print-tools` prints the built-in ones",
               set_tools),
           row::word("metal", {"steel", "stainless", "aluminium"}, "",
                     "metal, which sets tensile strength, springback and the radius that air "
                     "bending leaves; otherwise mild steel without springback",
                     set_metal),
           row::number(
               "springback", kSpringback,
               "springback in degrees, by which every bend is bent further",
               [](Request& to, const OptionValue& value) -> Result<void> {
                 to.bending.plan.springback = Angle::degrees(std::get<double>(value));
                 return {};
               },
               "0, or the metal's"),
           row::number("clearance", kAtLeastZero, "clearance to keep between part and tools, in mm",
                       stored<&Request::bending, &Bending::plan, &PlanOptions::clearance>, "0"),
           row::number("shortfall", kAtLeastZero,
                       "distance by which the punch may be short of each end of a bend line, in mm",
                       stored<&Request::bending, &Bending::plan, &PlanOptions::shortfall>,
                       "the thickness"),
           row::number("opening", kAboveZero, "wanted opening of the V, in mm",
                       stored<&Request::bending, &Bending::plan, &PlanOptions::opening>,
                       "by thickness: 6 times to 2.5 mm, 8 times to 8 mm, 10 times above"),
           row::word("v", {"choice", "wanted"}, "choice",
                     "take any V from 4 to 12 thicknesses at the cost of the weight v, or only the "
                     "die nearest to the wanted V",
                     set_v),
           row::flag("as_drawn",
                     "take only tools that leave the drawn inside radius, within a third of it",
                     set_as_drawn),
           row::word(
               "large_radii", {"v", "bump", "roll"}, "",
               "form a radius that no usual V leaves over a wider V, by bumps, or not on the "
               "press brake; otherwise over a V that the shop has, else by bumps, else rolled",
               set_large_radii),
           row::number("chord_error", kAboveZero,
                       "distance of the drawn radius from the pieces between bumps, at most, in mm",
                       stored<&Request::bending, &Bending::plan, &PlanOptions::chord_error>, "0.2"),
           row::flag("gauge_openings",
                     "let strokes without another stop touch the back gauge within an opening, by "
                     "the nose of its fingers",
                     stored<&Request::bending, &Bending::plan, &PlanOptions::gauge_openings>),
       }},
      {OptionGroup::order,
       {
           row::name("weights", "costs by which the cheapest order is chosen", set_weights,
                     "turn_over=3,rotate=2,tool_change=5,stroke=1,ungauged=4,v=1"),
           row::name("fix", "bends that come first, in this order, as in B3,B1", set_fix),
           row::flag("first", "stop at the first plan found",
                     stored<&Request::bending, &Bending::plan, &PlanOptions::limits,
                            &StrokeLimits::first>),
           {.name = "as_made",
            .kind = OptionKind::flag,
            .description = "lay the part flat, and plan, for the inside radii that the plan's "
                           "tools "
                           "leave",
            .on_command_line = false,
            .set = stored<&Request::bending, &Bending::as_made>},
           {.name = "search_time",
            .kind = OptionKind::number,
            .description = "seconds after which the best plan so far is given",
            .otherwise = "60",
            .range = kAboveZero,
            .on_command_line = false,
            .set = stored<&Request::bending, &Bending::plan, &PlanOptions::limits,
                          &StrokeLimits::seconds>},
       }},
  });
  return table;
}

}  // namespace planish::job
