#include "refusals.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/text.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/shop/shop_checks.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// What a shop profile makes of a part (shop-profiles.md): the nearest gauge within the tolerance,
// its K, its limits in place of the rules', and findings where the part asks for what the shop does
// not do. Only bends that take their radius from the tools are compared with the gauge's; hems,
// folds and rolled bends have their own. The worst bend gives the message.

namespace planish::shop {
namespace {

std::string in_mm(double length) { return fmt::format("{:.4g} mm", length); }

/// "2 mm and 2.5 mm": the gauges on both sides of a thickness.
Facts nearest_gauges(const ShopMaterial& material, double thickness) {
  const auto above = std::ranges::upper_bound(material.gauges, thickness, {}, &Gauge::thickness);
  Facts nearest;
  if (above != material.gauges.begin())
    nearest.emplace_back("nearest", std::prev(above)->thickness, unit::mm);
  if (above != material.gauges.end()) nearest.emplace_back("nearest", above->thickness, unit::mm);
  nearest.emplace_back("verb", nearest.size() == 1 ? "is" : "are");
  return nearest;
}

Finding shop_warning(std::string code, std::string_view pattern, const Facts& facts,
                     std::vector<Vec2> at = {}) {
  Told told = tell(pattern, facts);
  return {.code = std::move(code),
          .severity = Severity::warning,
          .message = continued(std::move(told.sentence)),
          .at = std::move(at),
          .about = std::move(told.places),
          .numbers = std::move(told.numbers),
          .named = std::move(told.named)};
}

Finding gauge_finding(const ShopChoice& choice, double thickness) {
  const ShopMaterial& material = choice.chosen();
  Facts facts = nearest_gauges(material, thickness);
  facts.emplace_back("shop", choice.shop.name);
  facts.emplace_back("material", material.name);
  facts.emplace_back("thickness", thickness, unit::mm);
  return shop_warning("shop_gauge", say::gauge_not_stocked, facts);
}

Vec2 line_middle(const FlatBend& bend) {
  if (bend.lines.empty()) return Vec2::Zero();
  const Segment& line = bend.lines[bend.lines.size() / 2];
  return 0.5 * (line.a + line.b);
}

/// Whether a press brake bends it to the radius of the tools: no hem, nothing rolled, no fold.
bool has_shop_radius(const FlatBend& bend, double thickness) {
  constexpr double kRolled = 10.0;  // thicknesses, as in `check_rules`
  constexpr double kHem = 170.0;    // degrees, likewise
  return (bend.kind == BendKind::cylinder || bend.kind == BendKind::cone) &&
         bend.angle.degrees() < kHem && bend.inside_radius <= kRolled * thickness;
}

std::vector<Finding> radius_findings(const ShopPart& part, const ShopChoice& choice,
                                     const Gauge& gauge) {
  constexpr double kSameRadius = 0.1;  // mm; no tool is truer
  Finding finding;
  std::vector<FindingPlace> places;
  double worst = kSameRadius;
  for (const FlatBend& bend : part.flat.bends) {
    if (!has_shop_radius(bend, part.thickness)) continue;
    const double off = std::abs(bend.inside_radius - gauge.inside_radius);
    if (off <= kSameRadius) continue;
    Finding one = shop_warning("shop_radius", say::other_radius,
                               {{"bend", place::at(place::bend(bend.id), line_middle(bend))},
                                {"radius", bend.inside_radius, unit::mm},
                                {"shop", choice.shop.name},
                                {"material", choice.chosen().name},
                                {"gauge", gauge.thickness, unit::mm},
                                {"usual", gauge.inside_radius, unit::mm}},
                               {line_middle(bend)});
    places.push_back({one.severity, one.message, one.at, one.about, one.numbers, one.named});
    if (off <= worst) continue;
    worst = off;
    finding = std::move(one);
  }
  if (places.empty()) return {};
  if (places.size() > 1) {
    Told many = tell(say::other_radii, {{"count", places.size()}, {"worst", words_of(finding)}});
    finding.message = std::move(many.sentence);
    finding.named = std::move(many.named);
  }
  finding.places = std::move(places);
  return {finding};
}

std::vector<Finding> limit_findings(const ShopPart& part, const ShopChoice& choice) {
  const ShopLimits& limits = choice.shop.limits;
  const std::string& shop = choice.shop.name;
  std::vector<Finding> findings;
  const auto add = [&](std::string_view pattern, Facts facts, std::vector<Vec2> at = {}) {
    facts.emplace_back("shop", shop);
    findings.push_back(shop_warning("shop_limit", pattern, facts, std::move(at)));
  };
  const Vec2 size = part.size;
  const auto exceeds = [](const Vec2& a, const Vec2& b) {
    return (a.array() > b.array() * (1.0 + tolerance::kWrittenDigits)).any();
  };
  if (limits.sheet && exceeds(size, *limits.sheet))
    add(say::blank_too_large, {{"length", size.x(), unit::mm},
                               {"width", size.y(), unit::mm},
                               {"most_length", limits.sheet->x(), unit::mm},
                               {"most_width", limits.sheet->y(), unit::mm}});
  if (limits.smallest_part && exceeds(*limits.smallest_part, size))
    add(say::blank_too_small, {{"length", size.x(), unit::mm},
                               {"width", size.y(), unit::mm},
                               {"least_length", limits.smallest_part->x(), unit::mm},
                               {"least_width", limits.smallest_part->y(), unit::mm}});
  const auto bends = static_cast<int>(part.flat.bends.size());
  if (limits.most_bends && bends > *limits.most_bends)
    add(say::too_many_bends, {{"count", bends}, {"most", *limits.most_bends}});
  for (const FlatBend& bend : part.flat.bends) {
    if (!limits.longest_bend) break;
    if (bend.length <= *limits.longest_bend * (1.0 + tolerance::kWrittenDigits)) continue;
    add(say::bend_too_long,
        {{"bend", place::at(place::bend(bend.id), line_middle(bend))},
         {"length", bend.length, unit::mm},
         {"most", *limits.longest_bend, unit::mm}},
        {line_middle(bend)});
  }
  return findings;
}

}  // namespace

const ShopMaterial& ShopChoice::chosen() const {
  PLANISH_ASSERT(material && *material < std::ssize(shop.materials));
  return shop.materials[*material];
}

const Gauge* gauge_of(const ShopChoice& choice, double thickness) {
  const auto& gauges = choice.chosen().gauges;
  const auto nearest = std::ranges::min_element(
      gauges, {}, [&](const Gauge& gauge) { return std::abs(gauge.thickness - thickness); });
  const bool found = nearest != gauges.end() &&
                     std::abs(nearest->thickness - thickness) <=
                         choice.shop.thickness_tolerance + tolerance::kWrittenDigits;
  return found ? &*nearest : nullptr;
}

ConstantK shop_k(const ShopChoice& choice, double thickness) {
  const Gauge* gauge = gauge_of(choice, thickness);
  if (!gauge) return {};
  return {gauge->k_factor, fmt::format("shop {}, {} {}: {}", choice.shop.name, choice.chosen().name,
                                       in_mm(gauge->thickness), gauge->k_from)};
}

std::string material_names(const Shop& shop) {
  std::string names;
  for (const ShopMaterial& material : shop.materials)
    names += (names.empty() ? "" : ", ") + material.name;
  return names;
}

Rules rules_with_gauge(const Rules& rules, const ShopChoice& choice, double thickness) {
  const Gauge* gauge = gauge_of(choice, thickness);
  Rules mine = rules;
  if (!gauge || !choice.gauge_limits) return mine;
  if (gauge->smallest_flange) {
    mine.flange_height_t = *gauge->smallest_flange / thickness;
    mine.flange_height_r = 0.0;
  }
  if (gauge->smallest_opening) mine.smallest_opening_t = *gauge->smallest_opening / thickness;
  return mine;
}

std::vector<Finding> shop_findings(const ShopPart& part, const ShopChoice& choice) {
  std::vector<Finding> findings;
  const Gauge* gauge = gauge_of(choice, part.thickness);
  if (!gauge) findings.push_back(gauge_finding(choice, part.thickness));
  if (gauge)
    for (Finding& finding : radius_findings(part, choice, *gauge))
      findings.push_back(std::move(finding));
  for (Finding& finding : limit_findings(part, choice))
    findings.push_back(std::move(finding));
  return findings;
}

}  // namespace planish::shop
