#include "part_list.hpp"

#include "parts_csv.hpp"
#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/io/flat_json.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/output_paths.hpp>
#include <planish/job/outputs.hpp>
#include <planish/schema/text_file.hpp>
#include <planish/sheet/same_part.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <tuple>

// The parts of a batch as a shop counts them. Pieces of one material with the same pattern and
// bends are one part, with the sum of their quantities; the first describes it. The list is sorted
// by material, thickness and name, and files are named in that order. An unknown mass stays
// unknown.

namespace planish::pack {
namespace {

using batch::PartRecord;

/// Thicknesses that are the same to a thousandth of a millimetre are in one group.
double rounded(double thickness) {
  constexpr double kThousandths = 1000.0;
  return std::round(thickness * kThousandths) / kThousandths;
}

LengthUnit units_of(const PartRecord& record) {
  if (record.units == "inch") return LengthUnit::inch;
  return record.units == "m" ? LengthUnit::m : LengthUnit::mm;
}

/// Whether it can be bent, as far as its report says.
std::string plan_of(const PartRecord& record, const FlatPattern& flat) {
  if (flat.bends.empty()) return "nothing to bend";
  for (const batch::RecordedFinding& finding : record.findings) {
    if (finding.code == "cannot_bend") return "cannot be bent";
    if (finding.code == "no_plan") return "no order found";
  }
  return has_order(flat) ? "can be bent" : kNotPlanned;
}

/// kg; `alone`: it is the whole part.
std::optional<double> mass_of(const PartRecord& record, const FlatPattern& flat,
                              const shop::PartMaterial* material,
                              const std::optional<double>& density_of_all, bool alone) {
  constexpr double kCubicDecimetre = 1e6;  // mm³
  const auto density = material && material->density ? material->density : density_of_all;
  if (!density) {
    // A density of the file is that of the file's material.
    const bool of_another = material && record.density &&
                            lower_case(material->material) != lower_case(record.material);
    return alone && !of_another ? record.mass : std::nullopt;
  }
  const double unit = millimetres_in(units_of(record));
  const double volume = record.volume.value_or(0.0);
  const double mm3 = alone && volume > 0.0 ? volume * unit * unit * unit
                                           : flat.area * flat.thickness;
  return *density * mm3 / kCubicDecimetre;
}

void measure(PackPart& part) {
  const FlatPattern& flat = part.flat;
  part.size = blank_size(flat);
  part.cut_length = flat.perimeter;
  part.pierces = 1 + flat.openings.size() + flat.slits.size();
  for (const FlatBend& bend : flat.bends)
    part.bend_length += bend.length;
}

/// Parts of one material, identical ones found.
class OfMaterial {
 public:
  explicit OfMaterial(const std::vector<PackPart>& all)
      : all_(all), groups_([this](std::size_t group) { return all_[parts_[group]].flat; }) {}
  OfMaterial(const OfMaterial&) = delete;
  OfMaterial& operator=(const OfMaterial&) = delete;

  /// The part in the list that equals it; the list's size if it is new there.
  std::size_t place_of(const PackPart& part) {
    const std::size_t group = groups_.add(part.flat);
    if (group == parts_.size()) parts_.push_back(all_.size());
    return parts_[group];
  }

 private:
  const std::vector<PackPart>& all_;
  std::vector<std::size_t> parts_;  ///< by group
  PartGroups groups_;
};

class Collecting {
 public:
  explicit Collecting(const job::Request& request) : request_(request) {}

  Result<void> add(const batch::BatchPart& from) {
    const PartRecord& record = from.record;
    PartSource source{record.input, name_of(record), record.quantity.value_or(1)};
    const shop::PartMaterial* row = row_of(record, source);
    if (row && row->quantity && from.copies != 1)
      return fail(refuse::quantity_twice,
                  {{"part", source_text(source)}, {"line", place::line(row->line)}}, "materials");
    if (row && row->quantity) source.quantity = *row->quantity;
    source.quantity *= from.copies;
    if (record.shapes.empty()) {
      list_.refused.push_back({source, record.reason, record.message});
      return {};
    }
    for (std::size_t piece = 0; piece < record.shapes.size(); ++piece)
      if (auto added = add_piece(from, source, row, piece); !added) return added;
    return {};
  }

  PartList finish() && {
    if (request_.materials)
      for (const shop::PartMaterial& row : request_.materials->rows())
        if (!used_.contains(row.line)) list_.unused_rows.push_back(row.line);
    std::ranges::stable_sort(list_.parts, {}, [](const PackPart& part) {
      return std::tuple(part.material == kUnknown, part.material, rounded(part.flat.thickness),
                        part.name);
    });
    name_files();
    for (std::size_t i = 0; i < list_.parts.size(); ++i) {
      const PackPart& part = list_.parts[i];
      if (list_.groups.empty() || list_.groups.back().material != part.material ||
          list_.groups.back().thickness != rounded(part.flat.thickness))
        list_.groups.push_back({part.material, rounded(part.flat.thickness), i, i});
      list_.groups.back().end = i + 1;
    }
    return std::move(list_);
  }

 private:
  /// Of a body its own name, of a file without one the file's.
  static std::string name_of(const PartRecord& record) {
    if (!record.body.empty()) return record.body;
    return job::stem_of_input(record.input);
  }

  static std::string stem_of(const PartSource& source) { return job::stem_of_input(source.input); }

  /// What the list of materials says of a part.
  const shop::PartMaterial* row_of(const PartRecord& record, const PartSource& source) {
    if (!request_.materials) return nullptr;
    const std::filesystem::path input(source.input);
    const auto* row = request_.materials->find(
        {name_of(record), input.stem().string(), input.filename().string()}, record.colour);
    if (row) used_.insert(row->line);
    return row;
  }

  /// As the list says, else as was chosen for all, else as the file says. With a shop the batch
  /// knows better: it has chosen among the shop's.
  std::string material_of(const PartRecord& record, const shop::PartMaterial* row) const {
    const bool of_shop = request_.shop && !record.material.empty();
    if (row && !of_shop) return row->material;
    if (!request_.material.empty() && !of_shop) return request_.material;
    return record.material.empty() ? kUnknown : record.material;
  }

  Result<void> add_piece(const batch::BatchPart& from, const PartSource& source,
                         const shop::PartMaterial* row, std::size_t piece) {
    const PartRecord& record = from.record;
    auto flat = read_flat_json(record.shapes[piece]);
    if (!flat)
      return fail(refuse::piece_unread,
                  {{"folder", record.folder}, {"reason", continued(flat.error().message)}});
    const bool alone = record.shapes.size() == 1;
    PackPart part;
    const std::string name = record.folder == source.input && job::is_nameless(source.body)
                                 ? stem_of(source)
                                 : source.body;
    part.name = alone ? name : fmt::format("{}-{}", name, piece + 1);
    part.material = material_of(record, row);
    part.flat = std::move(*flat);
    OfMaterial& same = of(part.material);
    const std::size_t at = same.place_of(part);
    if (at == list_.parts.size()) {
      describe(part, from, row, piece);
      list_.parts.push_back(std::move(part));
    }
    PackPart& kept = list_.parts[at];
    kept.quantity += source.quantity;
    kept.sources.push_back(source);
    return {};
  }

  void describe(PackPart& part, const batch::BatchPart& from, const shop::PartMaterial* row,
                std::size_t piece) const {
    const PartRecord& record = from.record;
    part.units = units_of(record);
    part.plan = plan_of(record, part.flat);
    for (const batch::RecordedFinding& warning : batch::warnings_of(record)) {
      part.warnings.push_back(warning.message);
      if (warning.code == "cannot_bend") part.help = warning.remedies;
    }
    part.notes = record.notes;
    // With a shop the batch knows the density of each material.
    part.mass = mass_of(record, part.flat, row, request_.shop ? std::nullopt : request_.density,
                        record.shapes.size() == 1);
    measure(part);
    if (const auto text = schema::read_text(from.files / batch::view_name(piece), "view"))
      if (auto view = drawing::read_view_json(*text)) part.view = std::move(*view);
  }

  OfMaterial& of(const std::string& material) {
    auto& found = by_material_[material];
    if (!found) found = std::make_unique<OfMaterial>(list_.parts);
    return *found;
  }

  /// Parts of one name, material and thickness are counted.
  void name_files() {
    std::set<std::string> taken;
    for (PackPart& part : list_.parts) {
      const std::string name = job::safe_name(part.name);
      const std::string kind = kind_of(part.material, part.flat.thickness);
      std::string stem = name + kind;
      for (int number = 2; !taken.insert(lower_case(stem)).second; ++number)
        stem = fmt::format("{}-{}{}", name, number, kind);
      part.stem = fmt::format("{}_x{}", stem, part.quantity);
    }
  }

  const job::Request& request_;
  std::set<int> used_;  ///< lines of the list of materials
  PartList list_;
  std::map<std::string, std::unique_ptr<OfMaterial>> by_material_;
};

}  // namespace

std::string kind_of(const std::string& material, double thickness) {
  const std::string field = material == kUnknown ? "" : "_" + job::safe_name(material);
  return fmt::format("{}_{:g}mm", field, rounded(thickness));
}

Result<PartList> part_list(const std::filesystem::path& batch, const job::Request& request) {
  Collecting collecting(request);
  const auto taken = batch::for_each_part(
      batch, [&](const batch::BatchPart& part) { return collecting.add(part); });
  if (!taken) return pass_on(taken);
  PartList list = std::move(collecting).finish();
  auto passed = batch::passed_over_by(batch);
  if (!passed) return pass_on(passed);
  list.passed_over = std::move(*passed);
  return list;
}

}  // namespace planish::pack
