#pragma once

#include "state.hpp"

namespace planish::batch {

/// Writes `parts.jsonl`, the summaries and the page from what the journal holds of the inputs of
/// the record's names, in their order. Errors: `cannot_read`, `cannot_write`.
Result<BatchResult> write_results(const RunRecord& record, State& state);

}  // namespace planish::batch
