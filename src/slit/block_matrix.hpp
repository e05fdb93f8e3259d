#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace planish::slit_detail {

/// A symmetric matrix of dense blocks that vanish far from the diagonal: what a strip does depends
/// on strips near it only. Blocks may be empty.
class BlockMatrix {
 public:
  /// `sizes` of the blocks on the diagonal; blocks more than `band` rows from it are zero.
  BlockMatrix(std::vector<int> sizes, int band);

  int rows() const { return static_cast<int>(sizes_.size()); }
  int band() const { return band_; }
  int size(int row) const { return sizes_[row]; }
  /// Where a block row begins in a vector.
  int begin(int row) const { return begins_[row]; }
  int dimensions() const { return begins_.back(); }

  /// The block of a row and a column not after it, within the band.
  Eigen::MatrixXd& at(int row, int column) { return blocks_[row][row - column]; }
  const Eigen::MatrixXd& at(int row, int column) const { return blocks_[row][row - column]; }

  Eigen::VectorXd times(const Eigen::VectorXd& v) const;
  /// No eigenvalue is larger in absolute value (Gershgorin).
  double bound() const;

 private:
  std::vector<int> sizes_, begins_;
  int band_ = 0;
  std::vector<std::vector<Eigen::MatrixXd>> blocks_;  ///< by row, from the diagonal leftwards
};

/// Of a positive definite matrix: L Lᵀ. O(rows × band² × size³).
class BlockCholesky {
 public:
  /// Of the matrix with a number added to its diagonal; empty if that is not positive definite.
  static std::optional<BlockCholesky> of(const BlockMatrix& matrix, double added);

  Eigen::VectorXd solve(Eigen::VectorXd v) const;
  /// L⁻¹ v.
  Eigen::VectorXd half_solved(Eigen::VectorXd v) const;

 private:
  explicit BlockCholesky(BlockMatrix lower) : lower_(std::move(lower)) {}

  BlockMatrix lower_;
};

}  // namespace planish::slit_detail
