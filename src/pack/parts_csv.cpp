#include "parts_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace planish::pack {
namespace {

std::string cell(const std::string& text) {
  if (text.find_first_of(",;\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string row_of(const std::vector<std::string>& cells) {
  std::vector<std::string> safe;
  for (const std::string& text : cells)
    safe.push_back(cell(text));
  return fmt::format("{}\n", fmt::join(safe, ","));
}

/// To a thousandth, without trailing zeros.
std::string decimal(double value) {
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string decimal(const std::optional<double>& value) {
  return value ? decimal(*value) : std::string();
}

std::string money(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : std::string();
}

/// "panel.step", "chair.step: leg ×4"
std::string source_text(const PartSource& source) {
  std::string text = source.input;
  if (!source.body.empty()) text += ": " + source.body;
  return source.quantity == 1 ? text : text + fmt::format(" ×{}", source.quantity);
}

std::vector<std::string> cells_of(const PackPart& part) {
  std::vector<std::string> sources;
  for (const PartSource& source : part.sources)
    sources.push_back(source_text(source));
  return {part.stem,
          part.name,
          part.material,
          decimal(part.flat.thickness),
          std::to_string(part.quantity),
          decimal(part.size.x()),
          decimal(part.size.y()),
          decimal(part.flat.area),
          decimal(part.mass),
          decimal(part.cut_length),
          std::to_string(part.pierces),
          std::to_string(part.flat.bends.size()),
          decimal(part.bend_length),
          part.plan,
          part.warnings.empty() ? "ok" : "warning",
          fmt::format("{}", fmt::join(part.warnings, "; ")),
          fmt::format("{}", fmt::join(sources, "; ")),
          money(part.cost)};
}

std::string totals_row(const std::string& name, const std::string& material,
                       const std::string& thickness, const Totals& totals) {
  return row_of({"total", name, material, thickness, std::to_string(totals.quantity), "", "",
                 decimal(totals.area), decimal(totals.mass), decimal(totals.cut_length),
                 std::to_string(totals.pierces), std::to_string(totals.bends),
                 decimal(totals.bend_length), "", "", "", "", money(totals.cost)});
}

std::string parts_text(int parts) {
  return fmt::format("{} {}", parts, parts == 1 ? "part" : "parts");
}

}  // namespace

Totals totals_of(const PartList& list, std::size_t first, std::size_t end) {
  Totals totals;
  const auto add = [](std::optional<double>& sum, const std::optional<double>& value, int times) {
    if (sum) sum = value ? std::optional(*sum + *value * times) : std::nullopt;
  };
  for (std::size_t i = first; i < end; ++i) {
    const PackPart& part = list.parts[i];
    const auto times = static_cast<std::size_t>(part.quantity);
    ++totals.parts;
    totals.quantity += part.quantity;
    totals.area += part.flat.area * part.quantity;
    totals.cut_length += part.cut_length * part.quantity;
    totals.bend_length += part.bend_length * part.quantity;
    totals.pierces += part.pierces * times;
    totals.bends += part.flat.bends.size() * times;
    add(totals.mass, part.mass, part.quantity);
    add(totals.cost, part.cost, 1);
  }
  return totals;
}

std::string parts_csv(const PartList& list, const std::string& currency) {
  std::string text = row_of({"file", "part", "material", "thickness", "quantity", "length", "width",
                             "area", "mass", "cut_length", "pierces", "bends", "bend_length",
                             "plan", "status", "warnings", "sources",
                             currency.empty() ? "cost" : "cost " + currency});
  for (const PartGroup& group : list.groups) {
    for (std::size_t i = group.first; i < group.end; ++i)
      text += row_of(cells_of(list.parts[i]));
    const Totals totals = totals_of(list, group.first, group.end);
    text += totals_row(parts_text(totals.parts), group.material, decimal(group.thickness), totals);
  }
  if (!list.parts.empty()) {
    const Totals totals = totals_of(list, 0, list.parts.size());
    text += totals_row(parts_text(totals.parts) + " in all", "", "", totals);
  }
  for (const RefusedPart& refused : list.refused)
    text += row_of({"", refused.source.body, "", "", std::to_string(refused.source.quantity), "",
                    "", "", "", "", "", "", "", "", "refused",
                    fmt::format("{}: {}", refused.code, refused.reason),
                    source_text(refused.source), ""});
  return text;
}

}  // namespace planish::pack
