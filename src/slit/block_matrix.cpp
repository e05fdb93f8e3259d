// Cholesky's decomposition block by block (Golub and Van Loan, Matrix Computations, 4.2). A block
// U Vᵀ beside the diagonal stays a product of as few columns: right of it is L⁻¹ V, and what it
// takes from blocks below it has the rank of both. So nearly all work is on the diagonal, and grows
// linearly with the strips.
#include "block_matrix.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <utility>

namespace planish::slit_detail {
namespace {

using Coupling = BlockMatrix::Coupling;

/// The block of a column among those of a row; null if it is zero.
const Coupling* at(const std::vector<Coupling>& row, int column) {
  const auto found = std::ranges::find(row, column, &Coupling::column);
  return found == row.end() ? nullptr : &*found;
}

/// One more term of a block.
void add(Coupling& block, const Eigen::MatrixXd& of_row, const Eigen::MatrixXd& of_column) {
  const Eigen::Index rank = block.of_row.cols();
  block.of_row.conservativeResize(of_row.rows(), rank + of_row.cols());
  block.of_column.conservativeResize(of_column.rows(), rank + of_row.cols());
  block.of_row.rightCols(of_row.cols()) = of_row;
  block.of_column.rightCols(of_row.cols()) = of_column;
}

/// The sums of the absolute values of a block's rows are no larger than these.
Eigen::VectorXd sums_of(const Eigen::MatrixXd& of_row, const Eigen::MatrixXd& of_column) {
  return of_row.cwiseAbs() * of_column.cwiseAbs().colwise().sum().transpose();
}

}  // namespace

BlockMatrix::BlockMatrix(std::vector<int> sizes) : sizes_(std::move(sizes)), begins_{0} {
  for (const int size : sizes_) {
    begins_.push_back(begins_.back() + size);
    diagonal_.push_back(Eigen::MatrixXd::Zero(size, size));
  }
  beside_.resize(sizes_.size());
}

void BlockMatrix::couple(int row, int column, Eigen::MatrixXd of_row, Eigen::MatrixXd of_column) {
  if (row < column) return couple(column, row, std::move(of_column), std::move(of_row));
  std::vector<Coupling>& blocks = beside_[row];
  const auto after = std::ranges::upper_bound(blocks, column, {}, &Coupling::column);
  blocks.insert(after, {column, std::move(of_row), std::move(of_column)});
}

Eigen::VectorXd BlockMatrix::times(const Eigen::VectorXd& v) const {
  Eigen::VectorXd product(v.size());
  for (int row = 0; row < rows(); ++row)
    product.segment(begin(row), size(row)) = diagonal_[row] * v.segment(begin(row), size(row));
  for (int row = 0; row < rows(); ++row)
    for (const Coupling& block : beside_[row]) {
      const int column = block.column;
      product.segment(begin(row), size(row)) += block.of_row *
                                                (block.of_column.transpose() *
                                                 v.segment(begin(column), size(column)));
      product.segment(begin(column), size(column)) += block.of_column *
                                                      (block.of_row.transpose() *
                                                       v.segment(begin(row), size(row)));
    }
  return product;
}

double BlockMatrix::bound() const {
  Eigen::VectorXd sums(dimensions());
  for (int row = 0; row < rows(); ++row)
    sums.segment(begin(row), size(row)) = diagonal_[row].cwiseAbs().rowwise().sum();
  for (int row = 0; row < rows(); ++row)
    for (const Coupling& block : beside_[row]) {
      sums.segment(begin(row), size(row)) += sums_of(block.of_row, block.of_column);
      sums.segment(begin(block.column), size(block.column)) += sums_of(block.of_column,
                                                                       block.of_row);
    }
  return sums.size() > 0 ? sums.maxCoeff() : 0.0;
}

std::optional<BlockCholesky> BlockCholesky::of(const BlockMatrix& matrix, double added) {
  BlockMatrix lower = matrix;
  for (int row = 0; row < matrix.rows(); ++row) {
    std::vector<Coupling> filled;  // of the row, in the order of columns
    const int first = matrix.beside(row).empty() ? row : matrix.beside(row).front().column;
    for (int column = first; column < row; ++column) {
      Coupling block{column, Eigen::MatrixXd(matrix.size(row), 0),
                     Eigen::MatrixXd(matrix.size(column), 0)};
      if (const Coupling* given = at(matrix.beside(row), column)) block = *given;
      for (const Coupling& before : filled)
        if (const Coupling* other = at(lower.beside(column), before.column))
          add(block, -before.of_row,
              other->of_row * (other->of_column.transpose() * before.of_column));
      if (block.of_row.cols() == 0) continue;
      lower.on_diagonal(column).triangularView<Eigen::Lower>().solveInPlace(block.of_column);
      filled.push_back(std::move(block));
    }
    Eigen::MatrixXd& diagonal = lower.on_diagonal(row);
    diagonal.diagonal().array() += added;
    for (const Coupling& block : filled)
      diagonal.noalias() -= block.of_row * (block.of_column.transpose() * block.of_column) *
                            block.of_row.transpose();
    const Eigen::LLT<Eigen::MatrixXd> llt(diagonal);
    if (llt.info() != Eigen::Success) return std::nullopt;
    diagonal = llt.matrixL();
    lower.set_beside(row, std::move(filled));
  }
  return BlockCholesky(std::move(lower));
}

Eigen::VectorXd BlockCholesky::half_solved(Eigen::VectorXd v) const {
  for (int row = 0; row < lower_.rows(); ++row) {
    auto part = v.segment(lower_.begin(row), lower_.size(row));
    for (const Coupling& block : lower_.beside(row))
      part -= block.of_row * (block.of_column.transpose() *
                              v.segment(lower_.begin(block.column), lower_.size(block.column)));
    lower_.on_diagonal(row).triangularView<Eigen::Lower>().solveInPlace(part);
  }
  return v;
}

Eigen::VectorXd BlockCholesky::solve(Eigen::VectorXd v) const {
  v = half_solved(std::move(v));
  for (int row = lower_.rows() - 1; row >= 0; --row) {
    auto part = v.segment(lower_.begin(row), lower_.size(row));
    lower_.on_diagonal(row).triangularView<Eigen::Lower>().transpose().solveInPlace(part);
    for (const Coupling& block : lower_.beside(row))
      v.segment(lower_.begin(block.column),
                lower_.size(block.column)) -= block.of_column * (block.of_row.transpose() * part);
  }
  return v;
}

}  // namespace planish::slit_detail
