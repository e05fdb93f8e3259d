#pragma once

#include <Eigen/Core>

#include <optional>
#include <utility>
#include <vector>

namespace planish::slit_detail {

/// A symmetric matrix of dense blocks on the diagonal. Those beside it are products of few columns,
/// the *faces* of their rows, since strips touch each other in few places. Blocks may be empty.
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

  /// Some columns of a row's face.
  struct Part {
    int row = 0;
    Eigen::Index first = 0, count = 0;
  };
  /// More columns of a row's face, by which it is coupled to other rows.
  Part face_part(int row, const Eigen::MatrixXd& columns);
  const Eigen::MatrixXd& face(int row) const { return faces_[row]; }

  /// A term of the block in the row of `low` and the column of `high`: columns of `low` · `middle`
  /// · columns of `high`ᵀ.
  struct Coupling {
    Part low, high;  ///< `high` before `low`
    Eigen::MatrixXd middle;
  };
  /// Adds such a term and its mirror image; either row first.
  void couple(const Part& a, const Part& b, const Eigen::MatrixXd& middle);
  /// The same of columns of their own: `of_row` · `of_column`ᵀ.
  void couple(int row, int column, const Eigen::MatrixXd& of_row, const Eigen::MatrixXd& of_column);
  const std::vector<Coupling>& beside(int row) const { return beside_[row]; }

  Eigen::VectorXd times(const Eigen::VectorXd& v) const;
  /// No eigenvalue is larger in absolute value (Gershgorin).
  double bound() const;

 private:
  std::vector<int> sizes_, begins_;
  std::vector<Eigen::MatrixXd> diagonal_, faces_;
  std::vector<std::vector<Coupling>> beside_;  ///< by row
};

/// Of a positive definite matrix: L Lᵀ. O(rows × size² × (size + columns of a face)) where
/// neighbours touch only.
class BlockCholesky {
 public:
  /// Of the matrix with a number added to its diagonal; empty if that is not positive definite.
  static std::optional<BlockCholesky> of(const BlockMatrix& matrix, double added);

  Eigen::VectorXd solve(Eigen::VectorXd v) const;
  /// L⁻¹ v.
  Eigen::VectorXd half_solved(Eigen::VectorXd v) const;

 private:
  /// The block of an earlier row's column, as a product of both faces: the later row's · `middle` ·
  /// (L⁻¹ the earlier row's)ᵀ.
  struct Below {
    int row = 0;
    Eigen::MatrixXd middle;
  };
  struct Row {
    Eigen::MatrixXd lower;
    Eigen::MatrixXd face, solved_face;  ///< and L⁻¹ of it
    std::vector<Below> below;           ///< in the order of rows
  };

  Eigen::Index begin(std::size_t row) const { return begins_[row]; }

  std::vector<Row> rows_;
  std::vector<Eigen::Index> begins_;
};

}  // namespace planish::slit_detail
