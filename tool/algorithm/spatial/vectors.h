// Vectors and matrices over symbolic scalars.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "support/index.h"
#include "symbolic/expression.h"

namespace robcogen::algorithm {

using symbolic::Expression;
using symbolic::Graph;

struct Vector3 {
  std::array<Expression, 3> element;
  Expression& operator[](std::size_t i) { return element[i]; }
  const Expression& operator[](std::size_t i) const { return element[i]; }
};

struct Matrix3 {
  std::array<Vector3, 3> row;
  Vector3& operator[](std::size_t i) { return row[i]; }
  const Vector3& operator[](std::size_t i) const { return row[i]; }
};

Vector3 operator+(const Vector3& a, const Vector3& b);
Vector3 operator-(const Vector3& a, const Vector3& b);
Vector3 operator-(const Vector3& a);
Vector3 operator*(const Expression& k, const Vector3& a);
Vector3& operator+=(Vector3& a, const Vector3& b);
Vector3& operator-=(Vector3& a, const Vector3& b);
Expression dot(const Vector3& a, const Vector3& b);
Vector3 cross(const Vector3& a, const Vector3& b);
Vector3 multiply(const Matrix3& m, const Vector3& v);
bool is_zero(const Vector3& v);

// [p]x with [p]x v = p x v.
Matrix3 skew(const Vector3& p);
Matrix3 operator+(const Matrix3& a, const Matrix3& b);
Matrix3 operator*(const Matrix3& a, const Matrix3& b);
Matrix3 transposed(const Matrix3& m);

// a b + c d, a b - c d. C++ leaves open which operand of an operator is evaluated first, and the order in which nodes
// are created decides the text of equal programs: these functions go from left to right with every compiler.
Expression sum_of_products(const Expression& a, const Expression& b, const Expression& c, const Expression& d);
Expression difference_of_products(const Expression& a, const Expression& b, const Expression& c, const Expression& d);

// A square matrix of any size, stored by columns; zero until set.
class SquareMatrix {
 public:
  explicit SquareMatrix(int size) : SquareMatrix(size, std::vector<Expression>(at(size * size))) {}
  SquareMatrix(int size, std::vector<Expression> columns) : size_(size), columns_(std::move(columns)) {}

  int size() const { return size_; }
  Expression& operator()(int row, int column) { return columns_[at(row + column * size_)]; }
  const Expression& operator()(int row, int column) const { return columns_[at(row + column * size_)]; }
  const std::vector<Expression>& columns() const { return columns_; }

 private:
  int size_;
  std::vector<Expression> columns_;
};

// A matrix by columns.
using Columns = std::vector<std::vector<Expression>>;

Vector3 unit_vector(Graph& graph, std::size_t axis);

}  // namespace robcogen::algorithm
