#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/shop/shop_checks.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::shop {
namespace {

std::string in_mm(double length) { return fmt::format("{:.4g} mm", length); }

/// "2 and 2.5 mm": the gauges on both sides of a thickness.
std::string nearest_gauges(const ShopMaterial& material, double thickness) {
  const auto above = std::ranges::upper_bound(material.gauges, thickness, {}, &Gauge::thickness);
  if (above == material.gauges.begin()) return in_mm(above->thickness);
  if (above == material.gauges.end()) return in_mm(std::prev(above)->thickness);
  return fmt::format("{:.4g} and {:.4g} mm", std::prev(above)->thickness, above->thickness);
}

Finding shop_warning(std::string code, std::string message) {
  return {.code = std::move(code),
          .severity = Severity::warning,
          .message = std::move(message),
          .at = {}};
}

Finding gauge_finding(const ShopChoice& choice, double thickness) {
  const ShopMaterial& material = choice.chosen();
  const std::string nearest = nearest_gauges(material, thickness);
  return shop_warning(
      "shop_gauge",
      fmt::format("{} does not stock {} of {}; the nearest {} {}, and K is not the shop's",
                  choice.shop.name, material.name, in_mm(thickness),
                  nearest.find(" and ") == std::string::npos ? "is" : "are", nearest));
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
  Finding finding = shop_warning("shop_radius", "");
  double worst = kSameRadius;
  int count = 0;
  for (const FlatBend& bend : part.flat.bends) {
    if (!has_shop_radius(bend, part.thickness)) continue;
    const double off = std::abs(bend.inside_radius - gauge.inside_radius);
    if (off <= kSameRadius) continue;
    ++count;
    const std::string message = fmt::format(
        "bend {} has an inside radius of {}, but {} bends {} of {} to {}", bend.id,
        in_mm(bend.inside_radius), choice.shop.name, choice.chosen().name, in_mm(gauge.thickness),
        in_mm(gauge.inside_radius));
    finding.places.push_back({Severity::warning, message, {line_middle(bend)}});
    if (off > worst) {
      worst = off;
      finding.message = message;
      finding.at = {line_middle(bend)};
    }
  }
  if (count == 0) return {};
  if (count > 1) finding.message = fmt::format("{} bends: {}", count, finding.message);
  return {finding};
}

std::vector<Finding> limit_findings(const ShopPart& part, const ShopChoice& choice) {
  const ShopLimits& limits = choice.shop.limits;
  const std::string& shop = choice.shop.name;
  std::vector<Finding> findings;
  const auto add = [&](std::string message) {
    findings.push_back(shop_warning("shop_limit", std::move(message)));
  };
  const Vec2 size = part.size;
  const auto exceeds = [](const Vec2& a, const Vec2& b) {
    return (a.array() > b.array() * (1.0 + tolerance::kWrittenDigits)).any();
  };
  if (limits.sheet && exceeds(size, *limits.sheet))
    add(
        fmt::format("the blank of {:.4g} × {:.4g} mm does not lie on the largest sheet of {}, "
                    "{:.4g} × {:.4g} mm",
                    size.x(), size.y(), shop, limits.sheet->x(), limits.sheet->y()));
  if (limits.smallest_part && exceeds(*limits.smallest_part, size))
    add(fmt::format("the blank of {:.4g} × {:.4g} mm is smaller than {} cuts, {:.4g} × {:.4g} mm",
                    size.x(), size.y(), shop, limits.smallest_part->x(),
                    limits.smallest_part->y()));
  const auto bends = static_cast<int>(part.flat.bends.size());
  if (limits.most_bends && bends > *limits.most_bends)
    add(fmt::format("the part has {} bends, and {} makes {} at most", bends, shop,
                    *limits.most_bends));
  for (const FlatBend& bend : part.flat.bends) {
    if (!limits.longest_bend) break;
    if (bend.length <= *limits.longest_bend * (1.0 + tolerance::kWrittenDigits)) continue;
    add(fmt::format("bend {} is {} long, and {} bends {} at most", bend.id, in_mm(bend.length),
                    shop, in_mm(*limits.longest_bend)));
    findings.back().at = {line_middle(bend)};
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
