#pragma once

#include <planish/base/result.hpp>
#include <planish/pack/pack.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::pack {

/// What a part is called whose material nobody says.
inline constexpr auto kUnknown = "unknown";

/// The material of parts by their names and colours, the first row that fits.
class Materials {
 public:
  struct Row {
    std::string pattern;  ///< of a name: * stands for any letters, ? for one; any case
    std::string material;
    std::optional<double> density;  ///< kg/dm³
    std::string colour = {};        ///< "#rrggbb" that the body must have; empty: any
  };

  Materials() = default;
  /// Reads CSV with the columns `material`, `part` or `colour` or both and, if wanted, `density`.
  /// Errors: `invalid_input`, `where` is name:line.
  static Result<Materials> parse(const GivenFile& file);

  /// Density of all parts whose row says none, kg/dm³: it goes before that of a STEP file.
  std::optional<double> density_of_all = {};

  /// Null if no row fits.
  const Row* find(const std::vector<std::string>& names, const std::string& colour) const;

 private:
  std::vector<Row> rows_;
};

/// Whether a name is like a pattern, in any case of ASCII letters.
bool fits(const std::string& pattern, const std::string& name);

}  // namespace planish::pack
