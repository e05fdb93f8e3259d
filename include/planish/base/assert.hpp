#pragma once

/// A caller's bug, checked in all builds: prints the condition and its place, then aborts.
#define PLANISH_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::planish::assertion_failed(#condition, __FILE__, __LINE__))

#include <string_view>

namespace planish {
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);
/// The same for data that breaks a rule: `where` is the row at fault.
[[noreturn]] void rule_broken(std::string_view where, std::string_view rule);
}  // namespace planish
