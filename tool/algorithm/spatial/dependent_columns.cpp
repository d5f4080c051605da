#include "algorithm/spatial/dependent_columns.h"

namespace robcogen::algorithm {
namespace {

Expression dot(const std::vector<Expression>& a, const std::vector<Expression>& b) {
  Expression sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

DependentColumns::DependentColumns(Graph& graph, const std::vector<std::vector<Expression>>& columns) {
  constexpr std::size_t kCofactors = 2;
  if (columns.size() <= kCofactors && columns.size() == columns.front().size())
    invert(graph, columns);
  else
    orthogonalise(graph, columns);
}

void DependentColumns::invert(Graph& graph, const std::vector<std::vector<Expression>>& columns) {
  const Expression one = graph.one();
  if (columns.size() == 1) {
    inverse_ = {{one / columns[0][0]}};
    return;
  }
  const std::vector<Expression>&a = columns[0], &b = columns[1];
  const Expression reciprocal = one / difference_of_products(a[0], b[1], a[1], b[0]);
  inverse_ = {{reciprocal * b[1], -(reciprocal * b[0])}, {-(reciprocal * a[1]), reciprocal * a[0]}};
}

void DependentColumns::orthogonalise(Graph& graph, const std::vector<std::vector<Expression>>& columns) {
  for (std::vector<Expression> left : columns) {
    std::vector<Expression>& factors = triangle_.emplace_back();
    for (const std::vector<Expression>& unit : units_) {
      factors.push_back(dot(unit, left));
      for (std::size_t i = 0; i < left.size(); ++i) left[i] -= factors.back() * unit[i];
    }
    reciprocals_.push_back(graph.one() / sqrt(dot(left, left)));
    for (Expression& e : left) e = reciprocals_.back() * e;
    units_.push_back(std::move(left));
  }
}

std::vector<Expression> DependentColumns::solve(const std::vector<Expression>& rows) const {
  std::vector<Expression> x;
  if (!inverse_.empty()) {
    for (const std::vector<Expression>& row : inverse_) x.push_back(dot(row, rows));
    return x;
  }
  x = in_basis(rows);
  for (std::size_t k = x.size(); k-- > 0;) {
    x[k] = reciprocals_[k] * x[k];
    for (std::size_t i = 0; i < k; ++i) x[i] -= triangle_[k][i] * x[k];
  }
  return x;
}

std::vector<Expression> DependentColumns::in_basis(const std::vector<Expression>& rows) const {
  std::vector<Expression> parts;
  for (const std::vector<Expression>& unit : units_) parts.push_back(dot(unit, rows));
  return parts;
}

std::vector<Expression> DependentColumns::from_basis(const std::vector<Expression>& parts) const {
  std::vector<Expression> rows(units_.front().size());
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row] += parts[k] * units_[k][row];
  return rows;
}

// Q R^-T forces.
std::vector<Expression> DependentColumns::transposed_solve(const std::vector<Expression>& forces) const {
  if (!inverse_.empty()) {
    std::vector<Expression> lambda(inverse_.front().size());
    for (std::size_t d = 0; d < forces.size(); ++d)
      for (std::size_t row = 0; row < lambda.size(); ++row) lambda[row] += inverse_[d][row] * forces[d];
    return lambda;
  }
  std::vector<Expression> y = forces;
  std::vector<Expression> lambda(units_.front().size());
  for (std::size_t k = 0; k < y.size(); ++k) {
    for (std::size_t i = 0; i < k; ++i) y[k] -= triangle_[k][i] * y[i];
    y[k] = reciprocals_[k] * y[k];
    for (std::size_t row = 0; row < lambda.size(); ++row) lambda[row] += y[k] * units_[k][row];
  }
  return lambda;
}

}  // namespace robcogen::algorithm
