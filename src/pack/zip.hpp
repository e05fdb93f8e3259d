#pragma once

#include <planish/base/result.hpp>

#include <string>
#include <string_view>

namespace planish::pack {

/// Files as one ZIP, deflated by zlib: the same files in the same order give the same bytes, since
/// all have the time with which the format begins. Names are UTF-8.
class Zip {
 public:
  /// Error: `cannot_write` beyond what the format holds without extensions: 4 GB, 65535 files.
  Result<void> add(std::string_view name, std::string_view bytes);
  /// The archive.
  std::string take() &&;

 private:
  std::string bytes_, directory_;
  unsigned count_ = 0;
};

}  // namespace planish::pack
