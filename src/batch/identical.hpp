#pragma once

#include "journal.hpp"

#include <planish/sheet/same_part.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace planish::batch {

/// Finds identical parts among those of a journal, in the order in which they are asked for. Of
/// each distinct one only where it is kept stays in memory.
class IdenticalParts {
 public:
  explicit IdenticalParts(Journal& journal);
  IdenticalParts(const IdenticalParts&) = delete;
  IdenticalParts& operator=(const IdenticalParts&) = delete;

  /// The number of the distinct part, from 0, that this is one of; none for a refused part. Two
  /// parts of several pieces are identical if their pieces are. Error: `cannot_read`.
  Result<std::optional<std::size_t>> number_of(const std::string& input, std::size_t part,
                                               const std::vector<std::string>& shapes);

  std::size_t count() const { return parts_.size(); }

 private:
  /// Where the first of equal pieces is kept.
  struct Place {
    std::string input;
    std::size_t part = 0, piece = 0;
  };
  FlatPattern pattern_of(const Place& place);
  Result<std::size_t> group_of(const std::string& shape, const Place& place);

  Journal& journal_;
  PartGroups pieces_;
  std::vector<Place> firsts_;                              ///< by group of pieces
  std::unordered_map<std::string, std::size_t> texts_;     ///< groups by hash of the piece's text
  std::map<std::vector<std::size_t>, std::size_t> parts_;  ///< by the groups of their pieces
};

}  // namespace planish::batch
