// Iterative LQR (Li and Todorov 2004, with the regularisation and the line search of Tassa, Erez and Todorov, IROS
// 2012) for systems of fixed sizes. It finds the best inputs of a motion from a state to a goal, and the feedback that
// keeps the motion on its trajectory.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace optimal_control {

template <int n, int m>
struct Linearisation {
  Eigen::Matrix<double, n, n> A;  // derivative of the next state by this state
  Eigen::Matrix<double, n, m> B;  // derivative of the next state by the input
};

// The cost is the sum of 1/2 (x - goal)^T state (x - goal) + 1/2 u^T input u over all steps, and 1/2 (x - goal)^T end
// (x - goal) of the last state. Weights are diagonal.
template <int n, int m>
struct Weights {
  Eigen::Matrix<double, n, 1> goal, state, end;
  Eigen::Matrix<double, m, 1> input;
};

template <int n, int m>
struct Trajectory {
  std::vector<Eigen::Matrix<double, n, 1>> x;  // one more state than inputs
  std::vector<Eigen::Matrix<double, m, 1>> u;
  std::vector<Eigen::Matrix<double, m, n>> feedback;  // u changes by feedback times the change of x
  std::vector<double> costs;                          // of the first trajectory and after each iteration
  bool is_converged = false;
};

// `next(x, u, linearisation)` returns the next state, and linearises if the pointer is not null. The iteration starts
// with the inputs of `trajectory` from its first state. It has converged if an iteration gains less than the fraction
// `tolerance` of the cost.
template <int n, int m, class Next>
class IterativeLqr {
 public:
  using X = Eigen::Matrix<double, n, 1>;
  using U = Eigen::Matrix<double, m, 1>;

  IterativeLqr(const Next& next, const Weights<n, m>& weights, Trajectory<n, m> start)
      : next_(next), weights_(weights), best_(std::move(start)) {
    best_.x.resize(best_.u.size() + 1);
    for (std::size_t k = 0; k < best_.u.size(); ++k) best_.x[k + 1] = next_(best_.x[k], best_.u[k], nullptr);
    best_.feedback.assign(best_.u.size(), Eigen::Matrix<double, m, n>::Zero());
    best_.costs = {cost(best_.x, best_.u)};
  }

  Trajectory<n, m> solve(int max_iterations, double tolerance) {
    double regularisation = 1;
    for (int i = 0; i < max_iterations; ++i) {
      const double before = best_.costs.back();
      if (backward(regularisation) && forward()) {
        regularisation = std::max(regularisation / 3, 1e-9);
        best_.is_converged = before - best_.costs.back() < tolerance * before;
        if (best_.is_converged) break;
      } else {
        regularisation *= 4;
        if (regularisation > 1e10) break;
      }
    }
    return best_;
  }

 private:
  double cost(const std::vector<X>& x, const std::vector<U>& u) const {
    const auto half_square = [](const auto& weight, const auto& v) { return weight.dot(v.cwiseAbs2()) / 2; };
    double sum = half_square(weights_.end, X(x.back() - weights_.goal));
    for (std::size_t k = 0; k < u.size(); ++k)
      sum += half_square(weights_.state, X(x[k] - weights_.goal)) + half_square(weights_.input, u[k]);
    return sum;
  }

  // Computes gains from a quadratic model of the cost to go, from the end to the start. Returns false if the model has
  // no minimum.
  bool backward(double regularisation) {
    X Vx = weights_.end.cwiseProduct(best_.x.back() - weights_.goal);
    Eigen::Matrix<double, n, n> Vxx = weights_.end.asDiagonal();
    change_.resize(best_.u.size());
    gains_.resize(best_.u.size());
    for (std::size_t k = best_.u.size(); k-- > 0;) {
      Linearisation<n, m> f;
      next_(best_.x[k], best_.u[k], &f);
      const X Qx = weights_.state.cwiseProduct(best_.x[k] - weights_.goal) + f.A.transpose() * Vx;
      const U Qu = weights_.input.cwiseProduct(best_.u[k]) + f.B.transpose() * Vx;
      Eigen::Matrix<double, n, n> Qxx = f.A.transpose() * Vxx * f.A;
      Qxx.diagonal() += weights_.state;
      Eigen::Matrix<double, m, m> Quu = f.B.transpose() * Vxx * f.B;
      Quu.diagonal() += weights_.input;
      const Eigen::Matrix<double, m, n> Qux = f.B.transpose() * Vxx * f.A;
      Eigen::Matrix<double, m, m> regular = Quu;
      regular.diagonal() += regularisation * weights_.input;
      const Eigen::LLT<Eigen::Matrix<double, m, m>> factor(regular);
      if (factor.info() != Eigen::Success) return false;
      const U d = change_[k] = -factor.solve(Qu);
      const Eigen::Matrix<double, m, n> K = gains_[k] = -factor.solve(Qux);
      Vx = Qx + K.transpose() * (Quu * d + Qu) + Qux.transpose() * d;
      Vxx = Qxx + K.transpose() * Quu * K + K.transpose() * Qux + Qux.transpose() * K;
      Vxx = ((Vxx + Vxx.transpose()) / 2).eval();
    }
    return true;
  }

  // Takes the largest of a sequence of decreasing changes that lowers the cost. Returns false if none does.
  bool forward() {
    for (double share = 1; share > 1e-4; share /= 2) {
      std::vector<X> x = best_.x;
      std::vector<U> u = best_.u;
      for (std::size_t k = 0; k < u.size(); ++k) {
        u[k] += share * change_[k] + gains_[k] * (x[k] - best_.x[k]);
        x[k + 1] = next_(x[k], u[k], nullptr);
      }
      const double value = cost(x, u);
      if (!(value < best_.costs.back())) continue;
      best_.x = std::move(x);
      best_.u = std::move(u);
      best_.feedback = gains_;
      best_.costs.push_back(value);
      return true;
    }
    return false;
  }

  const Next& next_;
  Weights<n, m> weights_;
  Trajectory<n, m> best_;
  std::vector<U> change_;
  std::vector<Eigen::Matrix<double, m, n>> gains_;
};

}  // namespace optimal_control
