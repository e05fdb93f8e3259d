#include "drawings.hpp"

#include "parts_csv.hpp"

#include <planish/drawing/page_parts.hpp>
#include <planish/drawing/part_pages.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::pack {
namespace {

constexpr double kPageWidth = 210.0, kPageHeight = 297.0, kBorder = 12.0;
constexpr double kRight = kPageWidth - kBorder, kBottom = kPageHeight - kBorder;
constexpr double kLetter = 3.1, kSmallLetter = 2.6;  // mm

std::string counted(std::size_t n, const std::string& one, const std::string& more) {
  return fmt::format("{} {}", n, n == 1 ? one : more);
}

/// A length as drawings have it, without trailing zeros.
std::string size_of(const PackPart& part, double mm) {
  const bool metric = part.units == LengthUnit::mm;
  const double value = mm / millimetres_in(part.units);
  std::string text = fmt::format("{:.{}f}", value, metric ? 2 : 4);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string unit_of(const PackPart& part) {
  if (part.units == LengthUnit::inch) return "in";
  return part.units == LengthUnit::m ? "m" : "mm";
}

std::string with_unit(const PackPart& part, double mm) {
  return size_of(part, mm) + " " + unit_of(part);
}

std::string blank_of(const PackPart& part) {
  return fmt::format("{} × {}", size_of(part, part.size.x()), with_unit(part, part.size.y()));
}

std::string pieces_of(int quantity) {
  return counted(static_cast<std::size_t>(quantity), "piece", "pieces");
}

std::vector<std::pair<std::string, std::string>> facts_of(const PackPart& part) {
  std::vector<std::pair<std::string, std::string>> facts{
      {"quantity", std::to_string(part.quantity)},
      {"material", part.material},
      {"thickness", with_unit(part, part.flat.thickness)},
      {"blank", blank_of(part)},
      {"cutting length", with_unit(part, part.cut_length)},
      {"pierces", std::to_string(part.pierces)},
      {"openings", std::to_string(part.flat.openings.size())},
      {"bends", std::to_string(part.flat.bends.size())},
      {"press brake", part.plan}};
  if (part.mass) facts.emplace_back("mass", fmt::format("{:.3g} kg", *part.mass));
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

/// Pages of a cover, filled from above.
class Cover {
 public:
  Cover(const PartList& list, const StockSheets& stock, std::string title, std::string currency)
      : list_(list), stock_(stock), title_(std::move(title)), currency_(std::move(currency)) {
    begin();
  }

  std::vector<Page> take() && {
    for (const PartGroup& group : list_.groups)
      add(group);
    if (!list_.parts.empty()) {
      need(12.0);
      add_sums("In all", totals_of(list_, 0, list_.parts.size()));
    }
    add_sheets();
    add_refused();
    for (std::size_t p = 0; p < pages_.size(); ++p)
      pages_[p].text({kRight, kBorder + 5.0}, fmt::format("{} / {}", p + 1, pages_.size()),
                     {.size = 3.5, .anchor = TextAnchor::end, .colour = drawing::kPageGrey});
    return std::move(pages_);
  }

 private:
  void begin() {
    Page& page = pages_.emplace_back(kPageWidth, kPageHeight);
    constexpr double kRoom = 165.0, kLargest = 6.5;
    page.text({kBorder, kBorder + 5.0}, title_,
              {.size = drawing::fitting_size(title_, kRoom, kLargest), .bold = true});
    page.line({kBorder, kBorder + 8.0}, {kRight, kBorder + 8.0}, {.width = 0.4});
    top_ = kBorder + 12.0;
  }
  void need(double height) {
    if (top_ + height > kBottom) begin();
  }
  Page& page() { return pages_.back(); }

  void add(const PartGroup& group) {
    need(8.0 + kRow);
    page().text(
        {kBorder, top_ + 4.0},
        fmt::format("{}, {:g} mm", group.material == kUnknown ? "material unknown" : group.material,
                    group.thickness),
        {.size = 4.4, .bold = true});
    top_ += 7.0;
    for (std::size_t i = group.first; i < group.end; ++i)
      add(list_.parts[i]);
    add_sums("Together", totals_of(list_, group.first, group.end));
    top_ += 4.0;
  }

  void add(const PackPart& part) {
    need(kRow);
    constexpr double kPicture = 26.0, kHigh = kRow - 3.0;
    const Vec2 corner(kBorder, top_ + 0.5);
    if (part.view && !part.view->edges.empty())
      drawing::draw_view(page(), *part.view, corner, {kPicture, kHigh});
    drawing::draw_flat(page(), part.flat, corner + Vec2(kPicture + 2.0, 0.0), {kPicture, kHigh});
    const double x = kBorder + 2.0 * kPicture + 7.0;
    const double room = kRight - x - 26.0;
    page().text({kRight, top_ + 6.0}, fmt::format("{}×", part.quantity),
                {.size = 5.0, .bold = true, .anchor = TextAnchor::end});
    page().text({x, top_ + 4.5}, part.stem,
                {.size = drawing::fitting_size(part.stem, room, 3.6), .bold = true});
    std::string work = fmt::format("blank {}, {}", blank_of(part),
                                   counted(part.flat.bends.size(), "bend", "bends"));
    if (part.mass) work += fmt::format(", {:.3g} kg", *part.mass);
    if (part.cost) work += fmt::format(", {:.2f} {}", *part.cost, currency_);
    page().text({x, top_ + 9.5}, work, {.size = drawing::fitting_size(work, kRight - x, kLetter)});
    const bool alert = !part.warnings.empty();
    const std::string state = alert ? fmt::format(
                                          "{}; {}", part.plan,
                                          counted(part.warnings.size(), "warning", "warnings"))
                                    : part.plan;
    page().text({x, top_ + 14.0}, state,
                {.size = kSmallLetter, .colour = alert ? drawing::kPageAlert : drawing::kPageGrey});
    top_ += kRow;
    page().line({kBorder, top_ - 1.0}, {kRight, top_ - 1.0},
                {.stroke = drawing::kPageGrey, .width = 0.1});
  }

  void add_sums(const std::string& what, const Totals& totals) {
    need(7.0);
    constexpr double kMetre = 1000.0;
    std::string text = fmt::format("{}: {}, {}, {:.4g} m to cut, {}, {}", what,
                                   counted(static_cast<std::size_t>(totals.parts), "part", "parts"),
                                   pieces_of(totals.quantity), totals.cut_length / kMetre,
                                   counted(totals.pierces, "pierce", "pierces"),
                                   counted(totals.bends, "bend", "bends"));
    if (totals.mass && *totals.mass > 0.0) text += fmt::format(", {:.4g} kg", *totals.mass);
    if (totals.cost) text += fmt::format(", {:.2f} {}", *totals.cost, currency_);
    page().text({kBorder, top_ + 3.5}, text,
                {.size = drawing::fitting_size(text, kRight - kBorder, kLetter), .bold = true});
    top_ += 6.0;
  }

  void add_title(const std::string& text, const Colour& colour) {
    need(8.0 + 2.0 * kStep);
    top_ += 3.0;
    page().text({kBorder, top_ + 4.0}, text, {.size = 4.4, .bold = true, .colour = colour});
    top_ += 7.0;
  }

  void add_lines(const std::string& text, const Colour& colour) {
    constexpr std::size_t kLetters = 115;
    for (const std::string& line : drawing::wrapped(text, kLetters)) {
      need(kStep);
      page().text({kBorder, top_ + 3.0}, line, {.size = kSmallLetter + 0.3, .colour = colour});
      top_ += kStep;
    }
  }

  void add_sheets() {
    if (stock_.sheets.empty() && stock_.notes.empty()) return;
    add_title("Sheets", kBlack);
    for (const StockSheet& sheet : stock_.sheets)
      add_lines(fmt::format("{}: {}, {:.1f} % used", sheet.stem,
                            counted(sheet.nested.placed.size(), "piece", "pieces"),
                            100.0 * sheet.nested.use),
                kBlack);
    for (const std::string& note : stock_.notes)
      add_lines(note, drawing::kPageAlert);
  }

  void add_refused() {
    if (list_.refused.empty()) return;
    add_title("Refused: not in this pack", drawing::kPageAlert);
    for (const RefusedPart& refused : list_.refused) {
      std::string text = refused.source.input;
      if (!refused.source.body.empty()) text += ": " + refused.source.body;
      if (refused.source.quantity > 1) text += fmt::format(" ×{}", refused.source.quantity);
      text += fmt::format(" – {}", refused.reason.empty() ? refused.code : refused.reason);
      add_lines(text, kBlack);
    }
  }

  static constexpr double kRow = 19.0, kStep = 4.4;

  const PartList& list_;
  const StockSheets& stock_;
  std::string title_, currency_;
  std::vector<Page> pages_;
  double top_ = 0.0;
};

}  // namespace

std::vector<Page> drawing_of(const PackPart& part) {
  drawing::PartDrawing drawing;
  drawing.title = part.name;
  drawing.subtitle = fmt::format("{}, {}, {}", part.material, with_unit(part, part.flat.thickness),
                                 pieces_of(part.quantity));
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
  return Cover(list, stock, title, currency).take();
}

}  // namespace planish::pack
