#include "agreement.h"

#include <limits>
#include <locale>
#include <sstream>

namespace robcogen::bench {

namespace {

// A column of a matrix as "a, b, c".
std::string printed(const Eigen::MatrixXd& m, Eigen::Index column) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(12);
  for (Eigen::Index row = 0; row < m.rows(); ++row) text << (row == 0 ? "" : ", ") << m(row, column);
  return text.str();
}

// The relative difference, which is infinite if the two cannot be compared, and a message about it.
struct Difference {
  double relative = 0;
  std::string text;
};

Difference difference(const Eigen::MatrixXd& ours, const Eigen::MatrixXd& theirs, double agreement) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::ostringstream text;
  text.imbue(std::locale::classic());
  if (ours.rows() != theirs.rows() || ours.cols() != theirs.cols()) {
    text << theirs.rows() << " x " << theirs.cols() << " and not " << ours.rows() << " x " << ours.cols();
    return {kInfinite, text.str()};
  }
  if (ours.size() == 0) return {};
  if (!ours.allFinite()) return {kInfinite, "the generated code's result is not finite"};
  if (!theirs.allFinite()) return {kInfinite, "not finite"};
  Eigen::Index row = 0, column = 0;
  const double absolute = (ours - theirs).cwiseAbs().maxCoeff(&row, &column);
  const double relative = absolute == 0 ? 0 : absolute / ours.cwiseAbs().maxCoeff();
  text << "relative difference " << relative << ", at most " << agreement << " is rounding; row " << row
       << " of column " << column << "\n  generated code: " << printed(ours, column)
       << "\n  peer:           " << printed(theirs, column);
  return {relative, text.str()};
}

}  // namespace

const char* name(peers::Quantity quantity) {
  switch (quantity) {
    case peers::Quantity::inverse_dynamics:
      return "inverse_dynamics";
    case peers::Quantity::forward_dynamics:
      return "forward_dynamics";
    case peers::Quantity::inertia_matrix:
      return "inertia_matrix";
    case peers::Quantity::jacobian:
      return "jacobian";
    case peers::Quantity::transform:
      return "transform";
  }
  return "";
}

std::vector<std::string> disagreements(
    peers::Peer& peer,
    const std::vector<Computed>& computed,
    std::size_t states,
    double agreement) {
  std::vector<std::string> messages;
  for (const Computed& ours : computed) {
    if (!peer.has(ours.quantity)) continue;
    double worst = agreement;
    std::string message;
    for (std::size_t i = 0; i < states; ++i) {
      peer.run(ours.quantity, i);
      const Difference d = difference(ours.result(i), peer.result(ours.quantity), agreement);
      if (d.relative <= worst) continue;
      worst = d.relative;
      message = peer.name() + " disagrees in " + name(ours.quantity) + " (" + ours.function + ") at state " +
                std::to_string(i) + ": " + d.text;
    }
    if (!message.empty()) messages.push_back(message);
  }
  return messages;
}

}  // namespace robcogen::bench
