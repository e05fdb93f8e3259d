#pragma once

#include <mutex>

namespace planish::brep {

/// Held while a STEP file is read or written: the kernel's STEP exchange keeps global state
/// (parameters, protocols, the message of the parser) and is not thread-safe. Lock it inside
/// `guarded`, around the exchange only: nothing else needs it, and it is not recursive.
[[nodiscard]] std::unique_lock<std::mutex> exchange_lock();

}  // namespace planish::brep
