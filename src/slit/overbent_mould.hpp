#pragma once

#include <planish/slit/mould.hpp>

namespace planish::slit_detail {

/// The mould for strips that are bent one by one, so far that they keep their shape when let go
/// (`MouldOptions::overbend`): each has ribs of its own, which stand side by side on one base.
/// Errors: those of `mould_of` and `overbent`, `bad_option` for one body.
Result<Mould> overbent_mould(const FoldedSlitSheet& folded, const MouldOptions& options);

}  // namespace planish::slit_detail
