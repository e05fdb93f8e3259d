#pragma once

#include "state.hpp"

namespace planish::batch {

/// Writes `parts.jsonl`, the summaries and the page from what the journal holds of the inputs of
/// these names, in their order. Errors: `cannot_read`, `cannot_write`.
Result<BatchResult> write_results(const std::vector<std::string>& names, State& state);

}  // namespace planish::batch
