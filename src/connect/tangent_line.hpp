#pragma once

#include "pair_search.hpp"

namespace planish::connect_detail {

/// The tangent line on which a bend is built: that of least plate extension
/// (math.md#least-extension) subject to the given values, with an inside radius above zero along
/// all edges. Errors: `no_bend_fits`, `plates_touch`, `radius_too_small`, `apex_in_span`; `where`
/// is the key of the request that is at fault, if one is.
Result<TangentLine> tangent_line(const FitTask& task, const PairChoice& choice,
                                 const ConnectOptions& options);

/// An error of the search, with the feasible range of the given radius, slope or apex added.
Error with_range(const FitTask& task, const ConnectOptions& options, const Error& error);

}  // namespace planish::connect_detail
