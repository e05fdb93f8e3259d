#pragma once

namespace planish::batch {

/// The page of a batch, with {{data}} where its rows belong.
extern const char* const kPageText;

}  // namespace planish::batch
