#include "parts_csv.hpp"

#include <planish/base/text.hpp>
#include <planish/sheet/csv.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace planish::pack {
namespace {

std::string money(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : std::string();
}

std::vector<std::string> cells_of(const PackPart& part) {
  const auto sources = mapped(part.sources,
                              [&](const PartSource& source) { return source_text(source); });
  return {part.stem,
          part.name,
          part.material,
          csv_number(part.flat.thickness),
          std::to_string(part.quantity),
          csv_number(part.size.x()),
          csv_number(part.size.y()),
          csv_number(part.flat.area),
          csv_number(part.mass),
          csv_number(part.cut_length),
          std::to_string(part.pierces),
          std::to_string(part.flat.bends.size()),
          csv_number(part.bend_length),
          part.plan,
          part.warnings.empty() ? "ok" : "warning",
          fmt::format("{}", fmt::join(part.warnings, "; ")),
          fmt::format("{}", fmt::join(sources, "; ")),
          money(part.cost)};
}

std::string totals_row(const std::string& name, const std::string& material,
                       const std::string& thickness, const Totals& totals) {
  return csv_row({"total", name, material, thickness, std::to_string(totals.quantity), "", "",
                  csv_number(totals.area), csv_number(totals.mass), csv_number(totals.cut_length),
                  std::to_string(totals.pierces), std::to_string(totals.bends),
                  csv_number(totals.bend_length), "", "", "", "", money(totals.cost)});
}

}  // namespace

std::string source_text(const PartSource& source) {
  std::string text = source.input;
  if (!source.body.empty()) text += ": " + source.body;
  return source.quantity == 1 ? text : text + fmt::format(" ×{}", source.quantity);
}

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
  std::string text = csv_row({"file", "part", "material", "thickness", "quantity", "length",
                              "width", "area", "mass", "cut_length", "pierces", "bends",
                              "bend_length", "plan", "status", "warnings", "sources",
                              currency.empty() ? "cost" : "cost " + currency});
  for (const PartGroup& group : list.groups) {
    for (std::size_t i = group.first; i < group.end; ++i)
      text += csv_row(cells_of(list.parts[i]));
    const Totals totals = totals_of(list, group.first, group.end);
    text += totals_row(counted(totals.parts, "part"), group.material, csv_number(group.thickness),
                       totals);
  }
  if (!list.parts.empty()) {
    const Totals totals = totals_of(list, 0, list.parts.size());
    text += totals_row(counted(totals.parts, "part") + " in all", "", "", totals);
  }
  for (const RefusedPart& refused : list.refused)
    text += csv_row({"", refused.source.body, "", "", std::to_string(refused.source.quantity), "",
                     "", "", "", "", "", "", "", "", "refused",
                     fmt::format("{}: {}", refused.code, refused.reason),
                     source_text(refused.source), ""});
  return text;
}

}  // namespace planish::pack
