#pragma once

#include <Eigen/Core>

#include <optional>
#include <utility>
#include <vector>

namespace planish::slit_detail {

/// A symmetric matrix of dense blocks on the diagonal, with others of low rank: strips touch each
/// other in few places. Blocks may be empty.
class BlockMatrix {
 public:
  /// `sizes` of the blocks on the diagonal.
  explicit BlockMatrix(std::vector<int> sizes);

  int rows() const { return static_cast<int>(sizes_.size()); }
  int size(int row) const { return sizes_[row]; }
  /// Where a block row begins in a vector.
  int begin(int row) const { return begins_[row]; }
  int dimensions() const { return begins_.back(); }

  Eigen::MatrixXd& on_diagonal(int row) { return diagonal_[row]; }
  const Eigen::MatrixXd& on_diagonal(int row) const { return diagonal_[row]; }

  /// The block `of_row` · `of_column`ᵀ beside the diagonal.
  struct Coupling {
    int column = 0;  ///< before the row
    Eigen::MatrixXd of_row, of_column;
  };
  /// Adds such a block. At most one for each row and column; either row first.
  void couple(int row, int column, Eigen::MatrixXd of_row, Eigen::MatrixXd of_column);
  const std::vector<Coupling>& beside(int row) const { return beside_[row]; }
  /// Instead of all that are there, in the order of columns.
  void set_beside(int row, std::vector<Coupling> blocks) { beside_[row] = std::move(blocks); }

  Eigen::VectorXd times(const Eigen::VectorXd& v) const;
  /// No eigenvalue is larger in absolute value (Gershgorin).
  double bound() const;

 private:
  std::vector<int> sizes_, begins_;
  std::vector<Eigen::MatrixXd> diagonal_;
  std::vector<std::vector<Coupling>> beside_;  ///< by row, in the order of columns
};

/// Of a positive definite matrix: L Lᵀ. O(rows × size² × (size + rank)) where neighbours touch
/// only.
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
