// Cholesky's decomposition block by block (Golub and Van Loan, Matrix Computations, 4.2). A block
// beside the diagonal is A_i M A_kᵀ, A the faces of both rows, and so is what a row takes from
// those behind it: A_i M_ik (A_kᵀ S_k⁻¹ A_k) M_jkᵀ A_jᵀ. So only the small middles fill up, nearly
// all work is on the diagonal, and grows linearly with the strips.
#include "block_matrix.hpp"

#include <Eigen/Cholesky>

#include <map>
#include <utility>

namespace planish::slit_detail {
namespace {

/// The sums of the absolute values of a block's rows are no larger than these.
Eigen::VectorXd sums_of(const Eigen::MatrixXd& of_row, const Eigen::MatrixXd& of_column) {
  return of_row.cwiseAbs() * of_column.cwiseAbs().colwise().sum().transpose();
}

auto columns_of(const BlockMatrix& matrix, const BlockMatrix::Part& part) {
  return matrix.face(part.row).middleCols(part.first, part.count);
}

/// How couplings see a row: through its face, or where that is as wide as the row, as it is.
class Faces {
 public:
  explicit Faces(const BlockMatrix& matrix) : matrix_(matrix) {}

  bool is_whole(int row) const { return matrix_.face(row).cols() >= matrix_.size(row); }
  Eigen::Index columns(int row) const {
    return is_whole(row) ? matrix_.size(row) : matrix_.face(row).cols();
  }
  Eigen::MatrixXd face(int row) const {
    if (!is_whole(row)) return matrix_.face(row);
    return Eigen::MatrixXd::Identity(matrix_.size(row), matrix_.size(row));
  }
  void add(Eigen::MatrixXd& to, const BlockMatrix::Coupling& term) const {
    const auto &low = term.low, &high = term.high;
    if (is_whole(low.row) && is_whole(high.row))
      to += columns_of(matrix_, low) * term.middle * columns_of(matrix_, high).transpose();
    else if (is_whole(low.row))
      to.middleCols(high.first, high.count) += columns_of(matrix_, low) * term.middle;
    else if (is_whole(high.row))
      to.middleRows(low.first, low.count) += term.middle * columns_of(matrix_, high).transpose();
    else
      to.block(low.first, high.first, low.count, high.count) += term.middle;
  }

 private:
  const BlockMatrix& matrix_;
};

/// Adds the lower half of face · middle · faceᵀ.
void add_symmetric(Eigen::MatrixXd& to, const Eigen::MatrixXd& face, bool is_whole,
                   const Eigen::MatrixXd& middle) {
  if (is_whole)
    to.triangularView<Eigen::Lower>() += middle;
  else
    to.triangularView<Eigen::Lower>() += (face * middle).eval() * face.transpose();
}

/// Middles of blocks, by column, then by row.
using Middles = std::vector<std::map<int, Eigen::MatrixXd>>;

Middles middles_of(const BlockMatrix& matrix, const Faces& faces) {
  Middles middles(matrix.rows());
  for (int row = 0; row < matrix.rows(); ++row)
    for (const BlockMatrix::Coupling& term : matrix.beside(row)) {
      Eigen::MatrixXd& middle = middles[term.high.row][row];
      if (middle.size() == 0)
        middle = Eigen::MatrixXd::Zero(faces.columns(row), faces.columns(term.high.row));
      faces.add(middle, term);
    }
  return middles;
}

}  // namespace

BlockMatrix::BlockMatrix(std::vector<int> sizes) : sizes_(std::move(sizes)), begins_{0} {
  for (const int size : sizes_) {
    begins_.push_back(begins_.back() + size);
    diagonal_.push_back(Eigen::MatrixXd::Zero(size, size));
    faces_.emplace_back(size, 0);
  }
  beside_.resize(sizes_.size());
}

BlockMatrix::Part BlockMatrix::face_part(int row, const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd& face = faces_[row];
  const Part part{row, face.cols(), columns.cols()};
  face.conservativeResize(Eigen::NoChange, part.first + part.count);
  face.rightCols(part.count) = columns;
  return part;
}

void BlockMatrix::couple(const Part& a, const Part& b, const Eigen::MatrixXd& middle) {
  if (a.row < b.row) return couple(b, a, middle.transpose());
  beside_[a.row].push_back({a, b, middle});
}

void BlockMatrix::couple(int row, int column, const Eigen::MatrixXd& of_row,
                         const Eigen::MatrixXd& of_column) {
  const Part a = face_part(row, of_row), b = face_part(column, of_column);
  couple(a, b, Eigen::MatrixXd::Identity(a.count, b.count));
}

Eigen::VectorXd BlockMatrix::times(const Eigen::VectorXd& v) const {
  Eigen::VectorXd product(v.size());
  std::vector<Eigen::VectorXd> through, back;  // of faces
  for (int row = 0; row < rows(); ++row) {
    product.segment(begin(row), size(row)) = diagonal_[row] * v.segment(begin(row), size(row));
    through.emplace_back(faces_[row].transpose() * v.segment(begin(row), size(row)));
    back.emplace_back(Eigen::VectorXd::Zero(faces_[row].cols()));
  }
  for (int row = 0; row < rows(); ++row)
    for (const auto& [low, high, middle] : beside_[row]) {
      back[low.row].segment(low.first, low.count) += middle * through[high.row].segment(high.first,
                                                                                        high.count);
      back[high.row].segment(high.first, high.count) += middle.transpose() *
                                                        through[low.row].segment(low.first,
                                                                                 low.count);
    }
  for (int row = 0; row < rows(); ++row)
    product.segment(begin(row), size(row)) += faces_[row] * back[row];
  return product;
}

double BlockMatrix::bound() const {
  Eigen::VectorXd sums(dimensions());
  for (int row = 0; row < rows(); ++row)
    sums.segment(begin(row), size(row)) = diagonal_[row].cwiseAbs().rowwise().sum();
  for (int row = 0; row < rows(); ++row)
    for (const auto& [low, high, middle] : beside_[row]) {
      const auto of_low = columns_of(*this, low), of_high = columns_of(*this, high);
      sums.segment(begin(low.row), size(low.row)) += sums_of(of_low, of_high * middle.transpose());
      sums.segment(begin(high.row), size(high.row)) += sums_of(of_high, of_low * middle);
    }
  return sums.size() > 0 ? sums.maxCoeff() : 0.0;
}

std::optional<BlockCholesky> BlockCholesky::of(const BlockMatrix& matrix, double added) {
  const Faces faces(matrix);
  BlockCholesky factors;
  Middles middles = middles_of(matrix, faces);
  std::vector<Eigen::MatrixXd> taken(matrix.rows());  // from the diagonal, as seen by faces
  for (int row = 0; row < matrix.rows(); ++row) {
    factors.begins_.push_back(matrix.begin(row));
    Row& own = factors.rows_.emplace_back();
    own.lower = matrix.on_diagonal(row);
    own.lower.diagonal().array() += added;
    own.face = faces.face(row);
    if (taken[row].size() > 0) add_symmetric(own.lower, own.face, faces.is_whole(row), -taken[row]);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> llt(own.lower);
    if (llt.info() != Eigen::Success) return std::nullopt;
    if (middles[row].empty()) continue;
    own.solved_face = own.lower.triangularView<Eigen::Lower>().solve(own.face);
    const Eigen::MatrixXd square = own.solved_face.transpose() * own.solved_face;
    for (auto& [below, middle] : middles[row])
      own.below.push_back({below, std::move(middle)});
    for (std::size_t i = 0; i < own.below.size(); ++i) {
      const Eigen::MatrixXd seen = own.below[i].middle * square;
      Eigen::MatrixXd& diagonal = taken[own.below[i].row];
      if (diagonal.size() == 0) diagonal = Eigen::MatrixXd::Zero(seen.rows(), seen.rows());
      diagonal += seen * own.below[i].middle.transpose();
      for (std::size_t j = 0; j < i; ++j) {
        Eigen::MatrixXd& fill = middles[own.below[j].row][own.below[i].row];
        const Eigen::MatrixXd& other = own.below[j].middle;
        if (fill.size() == 0) fill = Eigen::MatrixXd::Zero(seen.rows(), other.rows());
        fill -= seen * other.transpose();
      }
    }
  }
  return factors;
}

Eigen::VectorXd BlockCholesky::half_solved(Eigen::VectorXd v) const {
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const Row& own = rows_[row];
    auto part = v.segment(begin(row), own.lower.rows());
    own.lower.triangularView<Eigen::Lower>().solveInPlace(part);
    if (own.below.empty()) continue;
    const Eigen::VectorXd seen = own.solved_face.transpose() * part;
    for (const Below& below : own.below)
      v.segment(begin(below.row), rows_[below.row].lower.rows()) -= rows_[below.row].face *
                                                                    (below.middle * seen);
  }
  return v;
}

Eigen::VectorXd BlockCholesky::solve(Eigen::VectorXd v) const {
  v = half_solved(std::move(v));
  for (std::size_t row = rows_.size(); row-- > 0;) {
    const Row& own = rows_[row];
    auto part = v.segment(begin(row), own.lower.rows());
    Eigen::VectorXd seen = Eigen::VectorXd::Zero(own.solved_face.cols());
    for (const Below& below : own.below)
      seen += below.middle.transpose() *
              (rows_[below.row].face.transpose() *
               v.segment(begin(below.row), rows_[below.row].lower.rows()));
    if (!own.below.empty()) part -= own.solved_face * seen;
    own.lower.triangularView<Eigen::Lower>().transpose().solveInPlace(part);
  }
  return v;
}

}  // namespace planish::slit_detail
