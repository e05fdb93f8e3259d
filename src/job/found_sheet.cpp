#include "found_sheet.hpp"

#include "lay_flat.hpp"

namespace planish::job {

Result<Recognized> found_sheet(const Body& body, const std::vector<int>& rips,
                               const Progress& progress) {
  const FlattenOptions options{.allowance = ConstantK{0.5, "recognition"}};
  const auto lies = [&](const Sheet& open) { return lies_uncovered(open, options, progress); };
  return recognize(body, {.rip_edges = rips, .passes = lies});
}

}  // namespace planish::job
