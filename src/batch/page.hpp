#pragma once

#include <planish/batch/inputs.hpp>
#include <planish/batch/part_record.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace planish::batch {

/// The page of a batch: its parts with their sketches, shown without a server. Of more parts than a
/// browser shows well it keeps the refused ones and those with warnings, and says so.
class Page {
 public:
  /// `distinct`: the number of the distinct part that it is one of.
  void add(const PartRecord& part, std::optional<std::size_t> distinct);
  std::string text(const PassedOver& passed) const;

 private:
  /// Parts of one status: how many, and the first of them as JSON objects.
  struct Rows {
    std::size_t count = 0;
    std::vector<std::string> rows = {};
  };

  std::size_t all_ = 0;
  Rows refused_, warnings_, ok_;
  std::vector<std::size_t> copies_;  ///< of each distinct part
};

}  // namespace planish::batch
