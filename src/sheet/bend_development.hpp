#pragma once

#include <planish/sheet/layout.hpp>

namespace planish::sheet_detail {

/// What each bend takes of the flat sheet. Errors: those of `bend_allowance`.
Result<IdVector<BendId, BendAllowance>> allowances_of(const Sheet& sheet,
                                                      const FlattenOptions& options);

/// How each bend is developed at its neutral surface; empty for sharp bends. Error: `bad_option` if
/// K gives the neutral surface of a bend no radius.
Result<IdVector<BendId, std::optional<Development>>> developments_of(
    const Sheet& sheet, const IdVector<BendId, BendAllowance>& allowances);

/// How far the neutral surface lies from the reference surface along its normal, by face.
IdVector<FaceId, double> neutral_offsets_of(const Sheet& sheet,
                                            const IdVector<BendId, BendAllowance>& allowances);

}  // namespace planish::sheet_detail
