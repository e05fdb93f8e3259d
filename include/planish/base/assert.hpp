#pragma once

/// A caller's bug, checked in all builds: prints the condition and its place, then aborts.
#define PLANISH_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::planish::assertion_failed(#condition, __FILE__, __LINE__))

namespace planish {
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);
}
