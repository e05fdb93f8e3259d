#pragma once

#include "pair_search.hpp"

#include <functional>

namespace planish::connect_detail {

/// What a fit must keep to beyond the bend itself, and what it should: lie flat, above all, and
/// leave the plates room beside each other.
struct FitChecks {
  using Check = std::function<Result<void>(const BendFit&)>;
  Check must, flat, room;
};

/// The first choice (`fit_between`), if it holds. Errors: those of `fit_between` and of the checks.
Result<BendFit> fit_first_choice(const FitTask& task, const ConnectOptions& options,
                                 const FitChecks& checks);

/// The first choice that holds, of all that the request leaves open: the edges, nearest and widest
/// first, also round the back of the plates; the lateral boundaries; cylinders of smaller and
/// larger radius, general bends. If none keeps to all checks, the first choice
/// of all if it keeps to `must`; in its place one that lies flat. The
/// error counts what was tried, by what stands against it; its code is that of the choices that
/// came farthest.
Result<BendFit> fit_any_choice(const FitTask& task, const ConnectOptions& options,
                               const FitChecks& checks);

/// As `nearness`, of the shortest bend among those that `fit_any_choice` tries.
std::optional<Nearness> nearest_choice(const FitTask& task, const ConnectOptions& options);

}  // namespace planish::connect_detail
