#include "block_matrix.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

// Block by block against Eigen's dense decompositions.

namespace planish::test {
namespace {

using namespace slit_detail;

/// Symmetric, its diagonal raised by a number; one block is empty. Blocks up to `band` rows from
/// the diagonal have ranks from 1 to 3, the last of them stays zero.
BlockMatrix random_matrix(unsigned seed, int band, double diagonal) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto filled = [&](int rows, int columns) {
    Eigen::MatrixXd block(rows, columns);
    for (Eigen::Index i = 0; i < block.size(); ++i)
      block.data()[i] = unit(random);
    return block;
  };
  BlockMatrix matrix({3, 4, 0, 5, 2});
  for (int row = 0; row < matrix.rows(); ++row) {
    const int size = matrix.size(row);
    const Eigen::MatrixXd block = filled(size, size);
    matrix.on_diagonal(row) = block + block.transpose() +
                              diagonal * Eigen::MatrixXd::Identity(size, size);
    for (int column = std::max(0, row - band); column < std::min(row, 3); ++column) {
      const int rank = 1 + (row + column) % 3;
      Eigen::MatrixXd of_row = filled(size, rank), of_column = filled(matrix.size(column), rank);
      if (column % 2 == 0)
        matrix.couple(row, column, std::move(of_row), std::move(of_column));
      else
        matrix.couple(column, row, std::move(of_column), std::move(of_row));
    }
  }
  return matrix;
}

Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(matrix.dimensions(), matrix.dimensions());
  for (int row = 0; row < matrix.rows(); ++row) {
    const auto put = [&](int i, int j, const Eigen::MatrixXd& block) {
      all.block(matrix.begin(i), matrix.begin(j), block.rows(), block.cols()) = block;
    };
    put(row, row, matrix.on_diagonal(row));
    for (const BlockMatrix::Coupling& beside : matrix.beside(row)) {
      const auto columns = [&](const BlockMatrix::Part& part) -> Eigen::MatrixXd {
        return matrix.face(part.row).middleCols(part.first, part.count);
      };
      const Eigen::MatrixXd block = columns(beside.low) * beside.middle *
                                    columns(beside.high).transpose();
      all.block(matrix.begin(row), matrix.begin(beside.high.row), block.rows(),
                block.cols()) += block;
      all.block(matrix.begin(beside.high.row), matrix.begin(row), block.cols(),
                block.rows()) += block.transpose();
    }
  }
  return all;
}

TEST(BlockMatrix, SolvesAsTheDenseOne) {
  for (int band = 0; band < 5; ++band) {
    const BlockMatrix matrix = random_matrix(7, band, 12.0);
    const Eigen::MatrixXd all = dense(matrix);
    const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(14, -1.0, 2.0);
    EXPECT_LE((matrix.times(v) - all * v).norm(), 1e-12);
    // Of a product of one column and one row the bound is Gershgorin's, of others above it.
    EXPECT_GE(matrix.bound(), all.cwiseAbs().rowwise().sum().maxCoeff() - 1e-12);
    if (band == 0) {
      EXPECT_NEAR(matrix.bound(), all.cwiseAbs().rowwise().sum().maxCoeff(), 1e-12);
    }
    for (const double added : {0.0, 3.0}) {
      const auto factors = BlockCholesky::of(matrix, added);
      ASSERT_TRUE(factors);
      const Eigen::MatrixXd damped = all + added * Eigen::MatrixXd::Identity(14, 14);
      const Eigen::LLT<Eigen::MatrixXd> llt(damped);
      EXPECT_LE((factors->solve(v) - llt.solve(v)).norm(), 1e-12);
      EXPECT_LE((factors->half_solved(v) - llt.matrixL().solve(v)).norm(), 1e-12);
    }
  }
}

TEST(BlockMatrix, ThatIsNotPositiveDefiniteIsSeen) {
  const BlockMatrix matrix = random_matrix(3, 2, 0.0);
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense(matrix))
                           .eigenvalues()
                           .minCoeff();
  ASSERT_LT(least, 0.0);
  EXPECT_FALSE(BlockCholesky::of(matrix, 0.0));
  EXPECT_FALSE(BlockCholesky::of(matrix, -least - 1e-6));
  EXPECT_TRUE(BlockCholesky::of(matrix, -least + 1e-6));
}

}  // namespace
}  // namespace planish::test
