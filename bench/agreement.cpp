#include "agreement.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace robcogen::bench {

namespace {

double largest(const Eigen::MatrixXd& m) {
  return m.size() == 0 ? 0 : m.cwiseAbs().maxCoeff();
}

// Infinite where the two cannot be compared.
double difference(const Eigen::MatrixXd& ours, const Eigen::MatrixXd& theirs) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (ours.rows() != theirs.rows() || ours.cols() != theirs.cols()) return kInfinite;
  if (!ours.allFinite() || !theirs.allFinite()) return kInfinite;
  const double absolute = largest(ours - theirs);
  return absolute == 0 ? 0 : absolute / largest(ours);
}

// Columns as rows, so that a vector is one line.
std::string printed(const Eigen::MatrixXd& m) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(10);
  text << (m.cols() == 1 ? Eigen::MatrixXd(m.transpose()) : m);
  return text.str();
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
  }
  return "";
}

std::vector<std::string> disagreements(peers::Peer& peer, const std::vector<Computed>& computed, std::size_t states) {
  std::vector<std::string> messages;
  for (const Computed& ours : computed) {
    if (!peer.has(ours.quantity)) continue;
    double worst = 0;
    std::ostringstream message;
    message.imbue(std::locale::classic());
    for (std::size_t i = 0; i < states; ++i) {
      peer.run(ours.quantity, i);
      const Eigen::MatrixXd expected = ours.result(i);
      const Eigen::MatrixXd actual = peer.result(ours.quantity);
      const double relative = difference(expected, actual);
      if (relative <= kAgreement || relative <= worst) continue;
      worst = relative;
      message.str("");
      message << peer.name() << " disagrees in " << name(ours.quantity) << ": relative difference " << relative
              << " at state " << i << ", at most " << kAgreement << " is rounding\n"
              << ours.function << ":\n"
              << printed(expected) << "\n"
              << peer.name() << ":\n"
              << printed(actual) << "\n";
    }
    if (worst > 0) messages.push_back(message.str());
  }
  return messages;
}

}  // namespace robcogen::bench
