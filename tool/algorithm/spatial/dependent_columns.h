// The columns of K of the dependent joints, with solutions of K_d x = rows for any rows.
#pragma once

#include <vector>

#include "algorithm/spatial/vectors.h"

namespace robcogen::algorithm {

// One or two rows of as many joints are solved by cofactors. Otherwise an orthogonal basis of the columns is used
// (modified Gram-Schmidt: Golub and Van Loan 2013, sec. 5.2.8), so that there may be more rows than joints, some of
// them redundant.
class DependentColumns {
 public:
  // A column for each joint.
  DependentColumns(Graph& graph, const std::vector<std::vector<Expression>>& columns);

  // The solution by joint; the nearest one (least squares) if rows contradict one another.
  std::vector<Expression> solve(const std::vector<Expression>& rows) const;
  // lambda with K_d' lambda = forces, by row; the shortest one if rows are redundant.
  std::vector<Expression> transposed_solve(const std::vector<Expression>& forces) const;

  // The parts of rows along an orthogonal basis of the columns, if there are more rows than joints; and back.
  std::vector<Expression> in_basis(const std::vector<Expression>& rows) const;
  std::vector<Expression> from_basis(const std::vector<Expression>& parts) const;

 private:
  std::vector<std::vector<Expression>> inverse_;   // by joint; or empty
  std::vector<std::vector<Expression>> units_;     // Q by columns
  std::vector<std::vector<Expression>> triangle_;  // R by columns, without its diagonal
  std::vector<Expression> reciprocals_;            // of the diagonal

  void invert(Graph& graph, const std::vector<std::vector<Expression>>& columns);
  void orthogonalise(Graph& graph, const std::vector<std::vector<Expression>>& columns);
};

}  // namespace robcogen::algorithm
