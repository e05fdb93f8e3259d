// For libFuzzer: JSON, bend tables and points, which need no kernel, in this process.
#include "fuzz/readers.hpp"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  (void)planish::fuzz::read_json(text, {});
  (void)planish::fuzz::read_table(text);
  return 0;
}
