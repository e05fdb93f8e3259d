#include "drawings.hpp"

#include "parts_csv.hpp"

#include <planish/base/message.hpp>
#include <planish/base/text.hpp>
#include <planish/drawing/list_pages.hpp>
#include <planish/drawing/part_pages.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace planish::pack {
namespace {

/// A length as drawings have it.
std::string size_of(const PackPart& part, double mm) {
  constexpr int kMetric = 2, kFiner = 4;  // decimals
  return trimmed_number(schema::Units(part.units).length(mm),
                        part.units == LengthUnit::mm ? kMetric : kFiner);
}

std::string with_unit(const PackPart& part, double mm) {
  return fmt::format("{} {}", size_of(part, mm), schema::Units(part.units).symbol());
}

std::string blank_of(const PackPart& part) {
  return fmt::format("{} × {}", size_of(part, part.size.x()), with_unit(part, part.size.y()));
}

std::vector<std::pair<std::string, std::string>> facts_of(const PackPart& part) {
  std::vector<std::pair<std::string, std::string>> facts{
      {"quantity", std::to_string(part.quantity)},
      {"thickness", with_unit(part, part.flat.thickness)},
      {"blank", blank_of(part)},
      {"cutting length", with_unit(part, part.cut_length)},
      {"pierces", std::to_string(part.pierces)},
      {"openings", std::to_string(part.flat.openings.size())},
      {"bends", std::to_string(part.flat.bends.size())},
      {"press brake", part.plan}};
  if (part.material != kUnknown) facts.insert(facts.begin() + 1, {"material", part.material});
  if (part.mass) facts.emplace_back("mass", number_text(*part.mass, 3) + " kg");
  return facts;
}

/// "From panel.step, chair.step and 3 more files."
std::string origin_of(const PackPart& part) {
  constexpr std::size_t kNamed = 6;
  std::string text = "From ";
  for (std::size_t i = 0; i < std::min(kNamed, part.sources.size()); ++i)
    text += (i == 0 ? "" : ", ") + part.sources[i].input;
  if (part.sources.size() > kNamed)
    text += fmt::format(" and {} more", part.sources.size() - kNamed);
  return text + ".";
}

drawing::ListedPart listed(const PackPart& part, const std::string& currency) {
  std::string work = fmt::format("blank {}, {}", blank_of(part),
                                 counted(part.flat.bends.size(), "bend"));
  if (part.mass) work += fmt::format(", {} kg", number_text(*part.mass, 3));
  if (part.cost) work += fmt::format(", {:.2f} {}", *part.cost, currency);
  const bool alert = !part.warnings.empty();
  return {.name = part.stem,
          .work = work,
          .state = alert ? part.plan + "; " + counted(part.warnings.size(), "warning") : part.plan,
          .quantity = part.quantity,
          .flat = &part.flat,
          .view = part.view ? &*part.view : nullptr,
          .alert = alert,
          .help = fmt::format("{}", fmt::join(part.help, "; "))};
}

std::string sums_of(const std::string& what, const Totals& totals, const std::string& currency) {
  constexpr double kMetre = 1000.0;
  std::string text = fmt::format("{}: {}, {}, {} m to cut, {}, {}", what,
                                 counted(totals.parts, "part"), counted(totals.quantity, "piece"),
                                 number_text(totals.cut_length / kMetre),
                                 counted(totals.pierces, "pierce"), counted(totals.bends, "bend"));
  if (totals.mass && *totals.mass > 0.0) text += fmt::format(", {} kg", number_text(*totals.mass));
  if (totals.cost) text += fmt::format(", {:.2f} {}", *totals.cost, currency);
  return text;
}

drawing::ListedGroup group_of(const PartList& list, const PartGroup& group,
                              const std::string& currency) {
  const schema::Units units(list.parts[group.first].units);
  drawing::ListedGroup listed_group{
      (group.material == kUnknown ? "" : group.material + ", ") +
          fmt::format("{} {}", units.short_text(group.thickness), units.symbol()),
      {},
      sums_of("Together", totals_of(list, group.first, group.end), currency)};
  for (std::size_t i = group.first; i < group.end; ++i)
    listed_group.parts.push_back(listed(list.parts[i], currency));
  return listed_group;
}

drawing::ListedLines sheets_of(const StockSheets& stock) {
  drawing::ListedLines section{{"Sheets"}, {}};
  for (const StockSheet& sheet : stock.sheets)
    section.lines.push_back(
        {fmt::format("{}: {}, {:.1f} % used", sheet.stem,
                     counted(sheet.nested.placed.size(), "piece"), 100.0 * sheet.nested.use)});
  for (const std::string& note : stock.notes)
    section.lines.push_back({note, true});
  return section;
}

/// Told once: names of files and groups leave out a material that is not known.
drawing::ListedLines material_of(std::size_t without) {
  return {
      {"Material"},
      {{fmt::format("not known of {}: `--material` names that of all, `--materials` that of each",
                    counted(without, "part"))}}};
}

drawing::ListedLines refused_of(const PartList& list) {
  drawing::ListedLines section{{"Refused: not in this pack", true}, {}};
  for (const RefusedPart& refused : list.refused)
    section.lines.push_back({fmt::format("{} – {}", source_text(refused.source),
                                         refused.reason.empty() ? refused.code : refused.reason)});
  return section;
}

drawing::ListedLines passed_of(const batch::PassedOver& passed) {
  constexpr std::size_t kMost = 40;  // lines
  drawing::ListedLines section{{fmt::format("Passed over ({})", passed.count)}, {}};
  const std::size_t told = std::min(kMost, passed.files.size());
  for (std::size_t i = 0; i < told; ++i)
    section.lines.push_back({fmt::format("{} – {}", passed.files[i].name, passed.files[i].why)});
  if (told < passed.count)
    section.lines.push_back({fmt::format("and {} more", passed.count - told)});
  return section;
}

}  // namespace

std::vector<Page> drawing_of(const PackPart& part) {
  drawing::PartDrawing drawing;
  drawing.title = part.name;
  drawing.subtitle = fmt::format("{}, {}", with_unit(part, part.flat.thickness),
                                 counted(part.quantity, "piece"));
  if (part.material != kUnknown) drawing.subtitle.insert(0, part.material + ", ");
  drawing.facts = facts_of(part);
  drawing.flat = &part.flat;
  drawing.view = part.view ? &*part.view : nullptr;
  drawing.warnings = part.warnings;
  drawing.notes = part.notes;
  drawing.notes.push_back(origin_of(part));
  drawing.units = part.units;
  return drawing::part_pages(drawing);
}

std::vector<Page> cover_of(const PartList& list, const StockSheets& stock, const std::string& title,
                           const std::string& currency) {
  drawing::ListDrawing drawing{.title = title, .groups = {}, .sums = {}, .sections = {}};
  for (const PartGroup& group : list.groups)
    drawing.groups.push_back(group_of(list, group, currency));
  if (!list.parts.empty())
    drawing.sums = sums_of("In all", totals_of(list, 0, list.parts.size()), currency);
  std::size_t without = 0;
  for (const PackPart& part : list.parts)
    without += part.material == kUnknown ? 1 : 0;
  if (without > 0) drawing.sections.push_back(material_of(without));
  if (!stock.sheets.empty() || !stock.notes.empty()) drawing.sections.push_back(sheets_of(stock));
  if (!list.refused.empty()) drawing.sections.push_back(refused_of(list));
  if (list.passed_over.count > 0) drawing.sections.push_back(passed_of(list.passed_over));
  return drawing::list_pages(drawing);
}

}  // namespace planish::pack
