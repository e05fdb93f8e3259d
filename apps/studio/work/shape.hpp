#pragma once

#include "json_text.hpp"

#include <planish/geometry/mesh.hpp>
#include <planish/job/report.hpp>
#include <planish/sheet/facets.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace planish::studio {

/// An array of numbers as sent: little endian, four bytes each.
struct ShapeArray {
  std::string name;
  const char* type;
  std::string bytes;
};

/// What the page shows of a result: docs/studio-api.md, "shape".
struct Shape {
  std::string report;  ///< JSON text
  Json parts = Json::array();
  std::optional<Eigen::Isometry3d> root;
  std::string handles = "{}";          ///< JSON text
  std::optional<std::size_t> pierces;  ///< contours and slits; none without a pattern
  std::vector<ShapeArray> arrays;

  /// Of floats and of integers with and without sign.
  template <typename Number>
  void add(const std::string& name, const std::vector<Number>& values) {
    static_assert(sizeof(Number) == 4);
    const char* type = std::is_floating_point_v<Number> ? "f32"
                       : std::is_signed_v<Number>       ? "i32"
                                                        : "u32";
    const char* bytes = reinterpret_cast<const char*>(values.data());
    arrays.push_back({name, type, std::string(bytes, bytes + values.size() * sizeof(Number))});
  }
};

/// Adds flanges and bends as rows of `parts`, first the flanges, then the bends, each in the
/// sheet's order; then the facets with their outline, the bend lines, where the pattern covers
/// itself, and how often it is pierced. Adds nothing for a report without a pattern.
void add_sheet(Shape& shape, const job::Report& report, const FacetOptions& options);

/// The 4×4 matrix of a motion, row by row.
Json rows_json(const Eigen::Isometry3d& motion);

/// Adds a solid to show, with the number of each triangle's face, from 1 as messages count.
void add_space(Shape& shape, const MeshOfFaces& solid);

/// The bytes, with the time taken to compute them.
std::string encoded(const Shape& shape, double seconds);

}  // namespace planish::studio
