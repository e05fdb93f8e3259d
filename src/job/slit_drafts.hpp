#pragma once

#include <planish/base/progress.hpp>
#include <planish/job/slit_json.hpp>
#include <planish/slit/session.hpp>

#include <optional>

namespace planish::job {

/// The strips of a slit sheet during a drag: each design starts from the previous shape.
class SlitDrafts {
 public:
  /// Takes the design of a file, without its subdivisions, and solves it for 0.05 s at most; strips
  /// still open continue with the next design. Errors: those of `SlitSession::start` (the previous
  /// design stays), `cancelled`.
  Result<void> follow(const SlitFile& file, const Progress& progress);

  /// Requires that `follow` has succeeded.
  const SlitSession& now() const { return *session_; }
  /// The motion of the scans to the strips, if the file asks for it.
  const Eigen::Isometry3d& scan_motion() const { return motion_; }

 private:
  Result<void> begin(const SlitFile& file, const Progress& progress);
  Result<void> take(const SlitFile& file, const Progress& progress);
  Result<void> solve(const Progress& progress);

  std::optional<SlitSession> session_;
  Eigen::Isometry3d motion_ = Eigen::Isometry3d::Identity();
  bool aligned_ = false;
  std::vector<Vec3> cloud_;       ///< points that name no strip
  std::vector<SlitScan> shares_;  ///< the same, by the strips of the first shape
};

}  // namespace planish::job
