#include <planish/base/assert.hpp>

#include <cstdio>
#include <cstdlib>

namespace planish {
void assertion_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "planish: assertion failed: %s (%s:%d)\n", condition, file, line);
  std::abort();
}

void rule_broken(std::string_view where, std::string_view rule) {
  std::fprintf(stderr, "planish: rule broken at %.*s: %.*s\n", static_cast<int>(where.size()),
               where.data(), static_cast<int>(rule.size()), rule.data());
  std::abort();
}

}  // namespace planish
