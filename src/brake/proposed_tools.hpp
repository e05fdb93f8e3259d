#pragma once

#include "proposing.hpp"

#include <span>
#include <string>
#include <vector>

namespace planish::brake_detail {

/// Other tools, or the same used otherwise, with which a sheet can be bent: of each kind the least
/// change that does.
void try_openings(Trying& trying);
void try_segments(Trying& trying);
void try_punches(Trying& trying);
void try_dies(Trying& trying);
void try_lower_ears(Trying& trying);
void try_short_punch(Trying& trying);
void try_taller(Trying& trying);

std::vector<std::string> ids_of(const BrakeTools& tools);
/// With the segments of a common set besides, of these tools.
BrakeTools with_segments(BrakeTools tools, std::span<const std::string> of);
BrakeTools with_punch(BrakeTools tools, const Punch& punch);

/// As few of these as halving finds with which it does: mostly one.
template <typename Does>
std::span<const std::string> fewest(std::span<const std::string> all, const Does& does) {
  while (all.size() > 1) {
    const std::size_t half = all.size() / 2;
    if (does(all.first(half)))
      all = all.first(half);
    else if (does(all.subspan(half)))
      all = all.subspan(half);
    else
      break;
  }
  return all;
}

/// Punches of the other catalogue that the shop has not, of those alike one: first those that it
/// has, but without ears, then the bluntest.
std::vector<Punch> punches_to_get(const Trying& trying);
/// To get it, or ears for one's own.
Proposal proposal_of(const Trying& trying, const Punch& punch);

}  // namespace planish::brake_detail
