// Dense matrices of any size in plain loops.
//
// Each robot's self-check compiles this, so it must compile quickly; and the reference of generated code should not
// depend on the library on which the generated interface is built.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

namespace robcogen::reference {

// Column-major. A vector is a matrix of one column. The scalar is real, or complex where no order is needed.
template <class Scalar>
class Matrix {
 public:
  Matrix() = default;  // a vector without elements

  // All elements are zero.
  explicit Matrix(int rows, int cols = 1)
      : rows_(rows), cols_(cols), values_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols)) {}

  // A vector of these elements.
  Matrix(std::initializer_list<Scalar> elements) : rows_(static_cast<int>(elements.size())), values_(elements) {}

  static Matrix identity(int size) {
    Matrix m(size, size);
    for (int i = 0; i < size; ++i) m(i, i) = Scalar(1);
    return m;
  }

  int rows() const { return rows_; }
  int cols() const { return cols_; }
  bool empty() const { return values_.empty(); }
  Scalar* data() { return values_.data(); }
  const Scalar* data() const { return values_.data(); }
  const std::vector<Scalar>& values() const { return values_; }

  Scalar& operator()(int i, int j = 0) { return values_[index(i, j)]; }
  const Scalar& operator()(int i, int j = 0) const { return values_[index(i, j)]; }

  Matrix block(int i, int j, int rows, int cols) const {
    Matrix m(rows, cols);
    for (int c = 0; c < cols; ++c) {
      for (int r = 0; r < rows; ++r) m(r, c) = (*this)(i + r, j + c);
    }
    return m;
  }
  void set_block(int i, int j, const Matrix& m) {
    for (int c = 0; c < m.cols_; ++c) {
      for (int r = 0; r < m.rows_; ++r) (*this)(i + r, j + c) = m(r, c);
    }
  }
  Matrix col(int j) const { return block(0, j, rows_, 1); }
  Matrix head(int n) const { return block(0, 0, n, cols_); }
  Matrix tail(int n) const { return block(rows_ - n, 0, n, cols_); }

  template <class Other>
  Matrix<Other> cast() const {
    return mapped([](const Scalar& x) { return static_cast<Other>(x); });
  }

  // Applies f to each element.
  template <class Function>
  auto mapped(const Function& f) const {
    Matrix<decltype(f(Scalar()))> m(rows_, cols_);
    std::transform(values_.begin(), values_.end(), m.data(), f);
    return m;
  }

  Matrix& operator+=(const Matrix& b) {
    assert(rows_ == b.rows_ && cols_ == b.cols_);
    for (std::size_t k = 0; k < values_.size(); ++k) values_[k] += b.values_[k];
    return *this;
  }
  Matrix& operator*=(const Scalar& s) {
    for (Scalar& x : values_) x *= s;
    return *this;
  }
  friend Matrix operator+(Matrix a, const Matrix& b) { return a += b; }
  friend Matrix operator*(const Scalar& s, Matrix a) { return a *= s; }
  friend Matrix operator-(Matrix a) { return a *= Scalar(-1); }
  friend Matrix operator-(const Matrix& a, const Matrix& b) { return a + -b; }
  friend Matrix operator*(const Matrix& a, const Matrix& b) {
    assert(a.cols_ == b.rows_);
    Matrix m(a.rows_, b.cols_);
    // Adds whole columns, without checking each index: random robots spend most of their time here.
    for (int j = 0; j < b.cols_; ++j) {
      Scalar* sum = m.column(j);
      for (int k = 0; k < a.cols_; ++k) {
        const Scalar* column = a.column(k);
        const Scalar factor = b(k, j);
        for (int i = 0; i < a.rows_; ++i) sum[i] += column[i] * factor;
      }
    }
    return m;
  }

 private:
  Scalar* column(int j) { return data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(rows_); }
  const Scalar* column(int j) const { return data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(rows_); }

  std::size_t index(int i, int j) const {
    assert(0 <= i && i < rows_ && 0 <= j && j < cols_);
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(i);
  }

  int rows_ = 0;
  int cols_ = 1;
  std::vector<Scalar> values_;
};

template <class Scalar>
using Vector = Matrix<Scalar>;

template <class Scalar>
Matrix<Scalar> transpose(const Matrix<Scalar>& a) {
  Matrix<Scalar> m(a.cols(), a.rows());
  for (int j = 0; j < a.cols(); ++j) {
    for (int i = 0; i < a.rows(); ++i) m(j, i) = a(i, j);
  }
  return m;
}

// The magnitude of each element.
template <class Scalar>
Matrix<Scalar> magnitude(const Matrix<Scalar>& a) {
  return a.mapped([](const Scalar& x) { return std::abs(x); });
}

// The largest magnitude of an element; zero if there is no element, NaN if an element is NaN.
template <class Scalar>
Scalar largest(const Matrix<Scalar>& a) {
  Scalar result(0);
  for (int j = 0; j < a.cols(); ++j) {
    for (int i = 0; i < a.rows(); ++i) {
      const Scalar x = std::abs(a(i, j));
      if (std::isnan(x)) return x;
      result = std::max(result, x);
    }
  }
  return result;
}

template <class Scalar>
Scalar dot(const Vector<Scalar>& a, const Vector<Scalar>& b) {
  assert(a.rows() == b.rows());
  Scalar sum(0);
  for (int i = 0; i < a.rows(); ++i) sum += a(i) * b(i);
  return sum;
}

template <class Scalar>
Vector<Scalar> cross(const Vector<Scalar>& a, const Vector<Scalar>& b) {
  return {a(1) * b(2) - a(2) * b(1), a(2) * b(0) - a(0) * b(2), a(0) * b(1) - a(1) * b(0)};
}

// Stacks a above b.
template <class Scalar>
Matrix<Scalar> stacked(const Matrix<Scalar>& a, const Matrix<Scalar>& b) {
  Matrix<Scalar> m(a.rows() + b.rows(), a.cols());
  m.set_block(0, 0, a);
  m.set_block(a.rows(), 0, b);
  return m;
}

// Solves A x = b, for a square A and any number of right-hand sides: Gaussian elimination with row pivoting.
template <class Scalar>
Matrix<Scalar> solve(Matrix<Scalar> A, Matrix<Scalar> b) {
  const int n = A.rows();
  const auto swap_rows = [](Matrix<Scalar>& m, int i, int k) {
    for (int j = 0; j < m.cols(); ++j) std::swap(m(i, j), m(k, j));
  };
  const auto subtract_row = [](Matrix<Scalar>& m, int from, int row, const Scalar& factor) {
    for (int j = 0; j < m.cols(); ++j) m(from, j) -= factor * m(row, j);
  };
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i) {
      if (std::abs(A(i, k)) > std::abs(A(pivot, k))) pivot = i;
    }
    swap_rows(A, k, pivot);
    swap_rows(b, k, pivot);
    for (int i = k + 1; i < n; ++i) {
      const Scalar factor = A(i, k) / A(k, k);
      subtract_row(A, i, k, factor);
      subtract_row(b, i, k, factor);
    }
  }
  for (int k = n - 1; k >= 0; --k) {
    for (int j = 0; j < b.cols(); ++j) b(k, j) /= A(k, k);
    for (int i = 0; i < k; ++i) subtract_row(b, i, k, A(i, k));
  }
  return b;
}

// True if a symmetric matrix has a Cholesky factor.
template <class Scalar>
bool positive_definite(Matrix<Scalar> A) {
  for (int k = 0; k < A.rows(); ++k) {
    if (!(A(k, k) > 0)) return false;
    for (int i = k + 1; i < A.rows(); ++i) {
      for (int j = k + 1; j <= i; ++j) A(i, j) -= A(i, k) * A(j, k) / A(k, k);
    }
  }
  return true;
}

}  // namespace robcogen::reference
