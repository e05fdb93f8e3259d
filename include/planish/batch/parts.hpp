#pragma once

#include <planish/base/result.hpp>
#include <planish/batch/inputs.hpp>
#include <planish/batch/part_record.hpp>
#include <planish/shop/part_materials.hpp>

#include <filesystem>
#include <functional>
#include <string>

namespace planish::batch {

/// Among the formats of a batch: the isometric view of each piece, as `drawing::view_json`, in a
/// file of this name beside the others.
inline constexpr auto kViews = "views";
std::string view_name(std::size_t piece);

/// A part of a finished batch.
struct BatchPart {
  PartRecord record;
  std::filesystem::path files;  ///< the folder where its files are
  int copies = 1;               ///< of its input that are wanted
};

/// Whether a folder holds the results of a batch.
bool is_batch(const std::filesystem::path& out);

/// What a finished batch passed over. Errors: those of `for_each_part`.
Result<PassedOver> passed_over_by(const std::filesystem::path& out);

/// Goes through the parts of a finished batch, in the byte order of their inputs, until `take`
/// gives an error. Errors: `cannot_read` (also of a batch that is not finished), those of `take`.
Result<void> for_each_part(const std::filesystem::path& out,
                           const std::function<Result<void>(BatchPart)>& take);

/// Lines of a list of materials that are about no part of a finished batch. Errors: those of
/// `for_each_part`.
Result<std::vector<int>> unused_rows(const std::filesystem::path& out,
                                     const shop::PartMaterials& list);

}  // namespace planish::batch
