#pragma once

#include <cstdint>

namespace planish::studio {

/// The descriptor at which a worker finds its socket.
constexpr int kWorkerSocket = 3;

/// Address space of a worker, bytes; 0: unlimited. Sanitizers reserve far more than they use.
#if defined(__SANITIZE_ADDRESS__)
constexpr std::uint64_t kMostMemory = 0;
#else
constexpr std::uint64_t kMostMemory = std::uint64_t{4} << 30;
#endif

}  // namespace planish::studio
