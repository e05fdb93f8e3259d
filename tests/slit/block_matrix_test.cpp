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

/// Symmetric, its diagonal raised by a number; one block is empty.
BlockMatrix random_matrix(unsigned seed, int band, double diagonal) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  BlockMatrix matrix({3, 4, 0, 5, 2}, band);
  for (int row = 0; row < matrix.rows(); ++row)
    for (int column = std::max(0, row - band); column <= row; ++column) {
      Eigen::MatrixXd& block = matrix.at(row, column);
      for (Eigen::Index i = 0; i < block.size(); ++i)
        block.data()[i] = unit(random);
      if (row != column) continue;
      block = (block + block.transpose()).eval();
      block.diagonal().array() += diagonal;
    }
  return matrix;
}

Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(matrix.dimensions(), matrix.dimensions());
  for (int row = 0; row < matrix.rows(); ++row)
    for (int column = std::max(0, row - matrix.band()); column <= row; ++column) {
      all.block(matrix.begin(row), matrix.begin(column), matrix.size(row),
                matrix.size(column)) = matrix.at(row, column);
      all.block(matrix.begin(column), matrix.begin(row), matrix.size(column),
                matrix.size(row)) = matrix.at(row, column).transpose();
    }
  return all;
}

TEST(BlockMatrix, SolvesAsTheDenseOne) {
  for (int band = 0; band < 5; ++band) {
    const BlockMatrix matrix = random_matrix(7, band, 12.0);
    const Eigen::MatrixXd all = dense(matrix);
    const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(14, -1.0, 2.0);
    EXPECT_LE((matrix.times(v) - all * v).norm(), 1e-12);
    EXPECT_NEAR(matrix.bound(), all.cwiseAbs().rowwise().sum().maxCoeff(), 1e-12);
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
