#pragma once

#include "journal.hpp"

#include <planish/batch/batch.hpp>

namespace planish::batch {

/// Writes `parts.jsonl`, the summaries and the page from what the journal holds of the inputs, in
/// their order. Errors: `cannot_read`, `cannot_write`.
Result<BatchResult> write_results(const std::vector<Input>& inputs,
                                  const std::filesystem::path& out, Journal& journal);

}  // namespace planish::batch
