#pragma once

#include <functional>
#include <string_view>

namespace planish {

/// How long-running work reports its progress and learns that it should stop. Both may be empty.
/// `report` gets a stage name and the share done in [0, 1]; `cancelled` is polled between steps and
/// work that sees `true` ends with `code::cancelled` and leaves nothing half written.
struct Progress {
  std::function<void(std::string_view stage, double share)> report;
  std::function<bool()> cancelled;

  void at(std::string_view stage, double share) const {
    if (report) report(stage, share);
  }
  bool should_stop() const { return cancelled && cancelled(); }
};

}  // namespace planish
