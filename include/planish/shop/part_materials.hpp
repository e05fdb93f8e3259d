#pragma once

#include <planish/base/result.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::shop {

/// More pieces of one part than anybody asks for.
inline constexpr int kMostPieces = 1'000'000;

/// A row of a list of materials: which parts it is about, and what it says of them.
struct PartMaterial {
  std::string pattern;  ///< of a name: * stands for any letters, ? for one; any case
  std::string material;
  std::optional<double> density = {};  ///< kg/dm³
  std::string colour = {};             ///< "#rrggbb" that the body must have; empty: any
  std::optional<int> quantity = {};    ///< pieces that are wanted
  int line = 0;                        ///< of the file
};

/// The materials of parts by their names and colours: the first row that fits.
class PartMaterials {
 public:
  PartMaterials() = default;
  /// Reads CSV with the columns `material`, `part` or `colour` or both and, if wanted, `density`
  /// and `quantity`; `name` is the file's. Errors: `invalid_input`, also for any other column;
  /// `where` is name:line.
  static Result<PartMaterials> parse(const std::string& csv, const std::string& name);

  /// Null if no row fits.
  const PartMaterial* find(const std::vector<std::string>& names, const std::string& colour) const;

  const std::string& name() const { return name_; }
  const std::vector<PartMaterial>& rows() const { return rows_; }

 private:
  std::string name_;
  std::vector<PartMaterial> rows_;
};

/// Says that no part is meant by the row in a line.
std::string unused_row_text(const PartMaterials& list, int line);

/// Whether a name is like a pattern, in any case of ASCII letters.
bool fits(const std::string& pattern, const std::string& name);

}  // namespace planish::shop
