#include "slit_drafts.hpp"

#include <planish/slit/scans.hpp>

namespace planish::job {
namespace {

SlitDesign moved_scans(SlitDesign design, const Eigen::Isometry3d& motion) {
  for (SlitScan& scan : design.scans)
    for (Vec3& point : scan.points)
      point = motion * point;
  return design;
}

/// A gain of the objective that cannot be seen while something is dragged.
constexpr double kUnseen = 1e-5;

}  // namespace

Result<void> SlitDrafts::solve(const Progress& progress) {
  SlitSolveOptions options;
  options.seconds = 0.05;
  options.function_tolerance = kUnseen;
  const auto solved = session_->solve(options, progress);
  if (!solved) return pass_on(solved);
  return {};
}

Result<void> SlitDrafts::begin(const SlitFile& file, const Progress& progress) {
  auto started = SlitSession::start(file.design);
  if (!started) return pass_on(started);
  session_ = std::move(*started);
  motion_ = Eigen::Isometry3d::Identity();
  aligned_ = file.align_scans;
  cloud_ = cloud_of(file.design);
  shares_.clear();
  if (!aligned_ && cloud_.empty()) return {};
  if (auto solved = solve(progress); !solved) return solved;
  if (!cloud_.empty()) {
    shares_ = by_strip(cloud_, session_->folded());
    if (auto set = session_->set_design(with_shares(file.design, shares_)); !set) return set;
  }
  if (!aligned_) return {};
  // Scans lie only roughly where the sheet is: move them to the first shape.
  const auto motion = session_->align_scans();
  if (!motion) return pass_on(motion);
  motion_ = *motion;
  return {};
}

Result<void> SlitDrafts::take(const SlitFile& file, const Progress& progress) {
  if (!session_ || aligned_ != file.align_scans || cloud_ != cloud_of(file.design))
    return begin(file, progress);
  SlitDesign design = with_shares(file.design, shares_);
  return session_->set_design(aligned_ ? moved_scans(std::move(design), motion_) : design);
}

Result<void> SlitDrafts::follow(const SlitFile& file, const Progress& progress) {
  if (auto taken = take(file, progress); !taken) return taken;
  return solve(progress);
}

}  // namespace planish::job
