#pragma once

#include "json_text.hpp"

#include <planish/geometry/frame.hpp>
#include <planish/geometry/mesh.hpp>
#include <planish/job/report.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace planish::studio {

/// One array of numbers as it is sent: little endian, four bytes each.
struct ShapeArray {
  std::string name;
  const char* type;
  std::string bytes;
};

/// What a request looks like: docs/studio-api.md, "shape".
struct Shape {
  std::string report;  ///< JSON text
  Json parts = Json::array();
  std::optional<Eigen::Isometry3d> root;
  std::string handles = "{}";  ///< JSON text
  std::vector<ShapeArray> arrays;

  void add(const std::string& name, const std::vector<float>& values);
  void add(const std::string& name, const std::vector<std::uint32_t>& values);
  void add(const std::string& name, const std::vector<std::int32_t>& values);
};

/// Flanges and bends as rows of `parts`: first the flanges, then the bends, each in the sheet's
/// order. Then the facets with their outline, the lines at which it bends, and where the pattern
/// covers itself. Nothing for a report that knows no pattern. Drafts have fewer facets.
void add_sheet(Shape& shape, const job::Report& report, job::Effort effort);

/// A solid to look at.
void add_space(Shape& shape, const Mesh& mesh);

/// The bytes, with the time that it took to compute them.
std::string encoded(const Shape& shape, double seconds);

}  // namespace planish::studio
