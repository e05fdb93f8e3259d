#include "drawings.hpp"
#include "folder.hpp"
#include "part_list.hpp"
#include "parts_csv.hpp"
#include "refusals.hpp"
#include "stock.hpp"
#include "zip.hpp"

#include <planish/batch/inputs.hpp>
#include <planish/batch/options.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/options.hpp>
#include <planish/pack/pack.hpp>
#include <planish/shop/rates.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

// A production pack (pack.md): a batch that keeps reports, shapes and views, then everything that a
// shop needs, written from it. All tables are read first, so a fault in one costs no work. Patterns
// are drawn from the batch's shapes, not made again, so other materials, rates or sheets cost
// seconds. A batch that is given is used as it is.

namespace planish::pack {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Where the batch behind a pack is kept.
constexpr auto kBatch = ".planish-pack";

/// The options of the batch: whether parts can be bent is looked for, not how. A list of materials
/// that changes no pattern is left to the pack, so that another one costs no work.
std::string batch_options(const PackOptions& options) {
  Json json = Json::parse(options.options);
  if (!json.contains("shop") && !json.contains("material")) json.erase("materials");
  if (options.plan) json["check_bending"] = true;
  return json.dump();
}

/// A pack is called as what it was made of.
std::string title_of(const std::vector<std::string>& words) {
  if (words.size() != 1) return fmt::format("{} inputs", words.size());
  const fs::path whole = fs::weakly_canonical(words.front());
  return (whole.has_filename() ? whole : whole.parent_path()).stem().string();
}

Result<void> enter_costs(PartList& list, const shop::Rates& rates) {
  for (PackPart& part : list.parts) {
    const auto cost = rates.cost_of({.name = part.name,
                                     .material = part.material,
                                     .quantity = part.quantity,
                                     .cut_length = part.cut_length,
                                     .pierces = part.pierces,
                                     .bends = part.flat.bends.size(),
                                     .size = part.size,
                                     .mass = part.mass});
    if (!cost) return pass_on(cost);
    part.cost = *cost;
  }
  return {};
}

/// A pack while it is made.
class Making {
 public:
  Making(const fs::path& out, const PackOptions& options, const std::function<bool()>& cancelled,
         std::string title, std::string currency)
      : options_(options),
        cancelled_(cancelled),
        folder_(out),
        title_(std::move(title)),
        currency_(std::move(currency)) {}

  Result<PackResult> run(PartList list, const job::Request& request) {
    const DxfOptions& dxf = request.dxf;
    list_ = std::move(list);
    for (const int line : list_.unused_rows)
      notes_.push_back(shop::unused_row_text(*request.materials, line));
    if (auto drawn = write_patterns(dxf); !drawn) return pass_on(drawn);
    if (options_.drawings)
      if (auto drawn = write_drawings(); !drawn) return pass_on(drawn);
    if (options_.stock)
      if (auto laid = write_sheets(*options_.stock, dxf); !laid) return pass_on(laid);
    if (options_.drawings)
      if (auto drawn = write_cover(); !drawn) return pass_on(drawn);
    if (auto added = add("parts.csv", parts_csv(list_, currency_)); !added) return pass_on(added);
    if (options_.zip)
      if (auto added = folder_.add("pack.zip", std::move(zip_).take()); !added)
        return pass_on(added);
    if (auto done = folder_.finish(); !done) return pass_on(done);
    return result();
  }

 private:
  /// Writes a file, and puts it in the archive.
  Result<void> add(const std::string& name, const std::string& bytes) {
    if (auto added = folder_.add(name, bytes); !added) return added;
    if (options_.zip) return zip_.add(name, bytes);
    return {};
  }

  Result<void> write_patterns(const DxfOptions& dxf) {
    for (const PackPart& part : list_.parts) {
      if (cancelled_()) return tl::unexpected(batch::interruption());
      DxfOptions drawn = dxf;
      drawn.units = part.units;
      const auto text = dxf_text(part.flat, drawn);
      if (!text) return pass_on(text);
      if (auto added = add(part.stem + ".dxf", *text); !added) return added;
    }
    return {};
  }

  Result<void> write_pages(const std::string& name, const std::vector<Page>& pages,
                           const std::string& title) {
    if (cancelled_()) return tl::unexpected(batch::interruption());
    const auto pdf = pages_pdf(pages, title);
    if (!pdf) return pass_on(pdf);
    return add(name, *pdf);
  }

  Result<void> write_drawings() {
    for (const PackPart& part : list_.parts)
      if (auto written = write_pages(part.stem + ".pdf", drawing_of(part), part.name); !written)
        return written;
    return {};
  }

  Result<void> write_sheets(const Stock& stock, const DxfOptions& dxf) {
    Progress progress;
    progress.cancelled = cancelled_;
    auto laid = lay_on_stock(list_, stock, progress);
    if (!laid && laid.error().code == code::cancelled) return tl::unexpected(batch::interruption());
    if (!laid) return pass_on(laid);
    stock_ = std::move(*laid);
    for (const StockSheet& sheet : stock_.sheets) {
      const auto text = sheet_dxf(list_, sheet, stock, dxf);
      if (!text) return pass_on(text);
      if (auto added = add(fmt::format("sheets/{}.dxf", sheet.stem), *text); !added) return added;
    }
    return add("sheets.csv", sheets_csv(list_, stock_.sheets));
  }

  Result<void> write_cover() {
    return write_pages("cover.pdf", cover_of(list_, stock_, title_, currency_), title_);
  }

  PackResult result() const {
    PackResult result;
    result.parts = list_.parts.size();
    result.groups = list_.groups.size();
    for (const PackPart& part : list_.parts)
      result.pieces += static_cast<std::size_t>(part.quantity);
    for (const RefusedPart& refused : list_.refused) {
      result.refused += static_cast<std::size_t>(refused.source.quantity);
      batch::count_refused(result.refused_for,
                           {refused.code, refused.reason, source_text(refused.source)});
    }
    result.sheets = stock_.sheets.size();
    result.passed_over = list_.passed_over;
    result.notes = notes_;
    result.notes.insert(result.notes.end(), stock_.notes.begin(), stock_.notes.end());
    result.files = folder_.files();
    return result;
  }

  const PackOptions& options_;
  const std::function<bool()>& cancelled_;
  Folder folder_;
  Zip zip_;
  PartList list_;
  StockSheets stock_;
  std::vector<std::string> notes_;
  std::string title_, currency_;
};

/// What is wrong with options for the parts of a finished batch: they are drawn, but not made
/// again.
std::optional<Error> made_already(const std::string& folder, const PackOptions& options) {
  const Json given = Json::parse(options.options);
  for (const auto& [name, value] : given.items()) {
    const bool drawn = job::option(name).group == job::OptionGroup::dxf;
    if (!drawn && name != "materials" && name != "density")
      return error_of(refuse::made_already, {{"option", name}, {"folder", folder}}, name);
  }
  return std::nullopt;
}

/// The folder of the batch that a pack is made of: one that is given, or made now.
Result<fs::path> batch_of(const std::vector<std::string>& words, const fs::path& out,
                          const PackOptions& options, const job::Catalogue& catalogue,
                          const std::function<void(const batch::BatchProgress&)>& report,
                          const std::function<bool()>& cancelled) {
  if (words.size() == 1 && batch::is_batch(words.front())) {
    if (auto wrong = made_already(words.front(), options)) return tl::unexpected(std::move(*wrong));
    return fs::path(words.front());
  }
  const auto inputs = batch::inputs_of(words, out, catalogue);
  if (!inputs) return pass_on(inputs);
  batch::BatchOptions asked;
  asked.formats = {batch::kViews};
  asked.options = batch_options(options);
  asked.workers = options.workers;
  asked.limits = options.limits;
  if (auto wrong = batch::useless_options(inputs->files, options.options, catalogue))
    return tl::unexpected(std::move(*wrong));
  const auto done = batch::run_batch(*inputs, out / kBatch, asked, catalogue, report, cancelled);
  if (!done) return pass_on(done);
  return out / kBatch;
}

}  // namespace

Result<PackResult> make_pack(const std::vector<std::string>& words, const fs::path& out,
                             const PackOptions& options, const job::Catalogue& catalogue,
                             const std::function<void(const batch::BatchProgress&)>& report,
                             const std::function<bool()>& cancelled) {
  const auto request = batch::request_of(options.options, catalogue);
  if (!request) return pass_on(request);
  std::optional<shop::Rates> rates;
  if (options.rates) {
    auto read = shop::Rates::parse(options.rates->text, options.rates->name);
    if (!read) return pass_on(read);
    rates = std::move(*read);
  }
  const auto batch = batch_of(words, out, options, catalogue, report, cancelled);
  if (!batch) return pass_on(batch);
  auto list = part_list(*batch, *request);
  if (!list) return pass_on(list);
  const bool planned = options.plan && *batch == out / kBatch;
  for (PackPart& part : list->parts)
    if (planned && part.plan == kNotPlanned) part.plan = kNoStroke;
  if (rates)
    if (auto priced = enter_costs(*list, *rates); !priced) return pass_on(priced);
  return Making(out, options, cancelled, title_of(words), rates ? rates->currency() : std::string())
      .run(std::move(*list), *request);
}

}  // namespace planish::pack
