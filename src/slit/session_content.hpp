#pragma once

#include "snapshot.hpp"

#include <planish/slit/session.hpp>

#include <utility>
#include <vector>

namespace planish {

/// What a session holds: how things stand, and what undo and redo bring back.
struct SlitSession::Content {
  slit_detail::Snapshot now;
  std::vector<slit_detail::Snapshot> before, after;

  /// Makes an edited copy current and remembers the last.
  void commit(slit_detail::Snapshot next) {
    before.push_back(std::move(now));
    after.clear();
    now = std::move(next);
  }
};

}  // namespace planish
