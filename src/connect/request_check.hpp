#pragma once

#include "bend_fit.hpp"

#include <string>
#include <vector>

namespace planish::connect_detail {

/// Index of the plate that is named at `pointer`. Error: `unknown_plate`.
Result<int> row_of(const PlateStructure& structure, const std::string& id,
                   const std::string& pointer);

/// Indices of the plates that a bend joins, in its order. `pointer` is the request's place,
/// "/bends/1". Errors: `unknown_plate`, `invalid_input`.
Result<std::vector<int>> rows_of(const PlateStructure& structure, const BendRequest& request,
                                 const std::string& pointer);

/// Whether the values given for a bend are compatible. Error: `invalid_input`.
Result<void> check_numbers(const BendRequest& request, const std::string& pointer);

/// Whether the plates of a task have the given edges. Errors: `unknown_edge`, `invalid_input`.
Result<void> check_edges(const FitTask& task);

}  // namespace planish::connect_detail
