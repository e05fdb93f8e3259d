// Cholesky's decomposition block by block: a row of blocks is filled only as far from the diagonal
// as the matrix is, so that its cost grows linearly with the strips (Golub and Van Loan, Matrix
// Computations, 4.3 and 4.5).
#include "block_matrix.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <utility>

namespace planish::slit_detail {

BlockMatrix::BlockMatrix(std::vector<int> sizes, int band)
    : sizes_(std::move(sizes)), begins_{0}, band_(band) {
  for (int row = 0; row < rows(); ++row) {
    begins_.push_back(begins_.back() + sizes_[row]);
    std::vector<Eigen::MatrixXd>& blocks = blocks_.emplace_back();
    for (int column = row; column >= std::max(0, row - band_); --column)
      blocks.push_back(Eigen::MatrixXd::Zero(sizes_[row], sizes_[column]));
  }
}

Eigen::VectorXd BlockMatrix::times(const Eigen::VectorXd& v) const {
  Eigen::VectorXd product = Eigen::VectorXd::Zero(v.size());
  for (int row = 0; row < rows(); ++row)
    for (int column = std::max(0, row - band_); column <= row; ++column) {
      product.segment(begin(row), size(row)) += at(row, column) *
                                                v.segment(begin(column), size(column));
      if (column < row)
        product.segment(begin(column), size(column)) += at(row, column).transpose() *
                                                        v.segment(begin(row), size(row));
    }
  return product;
}

double BlockMatrix::bound() const {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(dimensions());
  for (int row = 0; row < rows(); ++row)
    for (int column = std::max(0, row - band_); column <= row; ++column) {
      const auto absolute = at(row, column).cwiseAbs();
      sums.segment(begin(row), size(row)) += absolute.rowwise().sum();
      if (column < row)
        sums.segment(begin(column), size(column)) += absolute.colwise().sum().transpose();
    }
  return sums.size() > 0 ? sums.maxCoeff() : 0.0;
}

std::optional<BlockCholesky> BlockCholesky::of(const BlockMatrix& matrix, double added) {
  BlockMatrix lower = matrix;
  const int rows = matrix.rows(), band = matrix.band();
  for (int row = 0; row < rows; ++row)
    for (int column = std::max(0, row - band); column <= row; ++column) {
      Eigen::MatrixXd& block = lower.at(row, column);
      for (int k = std::max(0, row - band); k < column; ++k)
        block.noalias() -= lower.at(row, k) * lower.at(column, k).transpose();
      if (column < row) {
        lower.at(column, column)
            .triangularView<Eigen::Lower>()
            .transpose()
            .solveInPlace<Eigen::OnTheRight>(block);
        continue;
      }
      block.diagonal().array() += added;
      const Eigen::LLT<Eigen::MatrixXd> llt(block);
      if (llt.info() != Eigen::Success) return std::nullopt;
      block = llt.matrixL();
    }
  return BlockCholesky(std::move(lower));
}

Eigen::VectorXd BlockCholesky::half_solved(Eigen::VectorXd v) const {
  for (int row = 0; row < lower_.rows(); ++row) {
    auto part = v.segment(lower_.begin(row), lower_.size(row));
    for (int column = std::max(0, row - lower_.band()); column < row; ++column)
      part.noalias() -= lower_.at(row, column) *
                        v.segment(lower_.begin(column), lower_.size(column));
    lower_.at(row, row).triangularView<Eigen::Lower>().solveInPlace(part);
  }
  return v;
}

Eigen::VectorXd BlockCholesky::solve(Eigen::VectorXd v) const {
  v = half_solved(std::move(v));
  for (int row = lower_.rows() - 1; row >= 0; --row) {
    auto part = v.segment(lower_.begin(row), lower_.size(row));
    lower_.at(row, row).triangularView<Eigen::Lower>().transpose().solveInPlace(part);
    for (int column = std::max(0, row - lower_.band()); column < row; ++column)
      v.segment(lower_.begin(column), lower_.size(column))
          .noalias() -= lower_.at(row, column).transpose() * part;
  }
  return v;
}

}  // namespace planish::slit_detail
