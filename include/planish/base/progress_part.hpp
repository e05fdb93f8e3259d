#pragma once

#include <planish/base/progress.hpp>

namespace planish {

/// Progress of a part of some work: its shares 0 to 1 become `from` to `to` of the whole, which
/// must outlive it.
inline Progress part_of(const Progress& whole, double from, double to) {
  Progress part;
  part.cancelled = whole.cancelled;
  part.report = [&whole, from, to](std::string_view stage, double share) {
    whole.at(stage, from + share * (to - from));
  };
  return part;
}

}  // namespace planish
