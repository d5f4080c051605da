#include "rivals/rivals.h"

#include "rivals/rival.h"

namespace robcogen::rivals {
namespace {

using peers::Quantity;

class GeneratedPeer : public peers::Peer {
 public:
  GeneratedPeer(const Rival& rival, const peers::Subject& subject) : rival_(rival), gravity_(subject.gravity) {}

  std::string name() const override { return rival_.name; }
  bool has(Quantity quantity) const override { return !is_of_link(quantity); }

  void prepare(const std::vector<peers::State>& states) override {
    const auto count = static_cast<Eigen::Index>(states.size());
    const auto all = [&](const auto& of_state, Eigen::Index size) {
      Eigen::MatrixXd columns(size, count);
      for (Eigen::Index i = 0; i < count; ++i) columns.col(i) = of_state(states[static_cast<std::size_t>(i)]);
      return columns;
    };
    const Eigen::Index n = rival_.joints;
    const Eigen::MatrixXd q = all([](const peers::State& s) { return s.q; }, n);
    const Eigen::MatrixXd qd = all([](const peers::State& s) { return s.qd; }, n);
    const Eigen::MatrixXd qdd = all([](const peers::State& s) { return s.qdd; }, n);
    const Eigen::MatrixXd tau = all([](const peers::State& s) { return s.tau; }, n);
    const Eigen::MatrixXd velocity = all([](const peers::State& s) { return s.base_velocity; }, 6);
    const Eigen::MatrixXd acceleration = all([](const peers::State& s) { return s.base_acceleration; }, 6);
    rival_.prepare(
        {states.size(), q.data(), qd.data(), qdd.data(), tau.data(), velocity.data(), acceleration.data(),
         gravity_.data()});
  }

  void run(Quantity quantity, std::size_t state) override { rival_.run(function(quantity), state); }

  Eigen::MatrixXd result(Quantity quantity) const override {
    const Eigen::Index size = rival_.joints + (rival_.floating_base ? 6 : 0);
    Eigen::MatrixXd values(size, quantity == Quantity::inertia_matrix ? size : 1);
    rival_.result(function(quantity), values.data());
    return values;
  }

 private:
  const Rival& rival_;
  Eigen::Vector3d gravity_;

  static Function function(Quantity quantity) {
    if (quantity == Quantity::inverse_dynamics) return Function::inverse_dynamics;
    return quantity == Quantity::forward_dynamics ? Function::forward_dynamics : Function::inertia_matrix;
  }
};

}  // namespace

peers::Candidate candidate(const Rival& rival, const peers::Subject& subject) {
  peers::Candidate result;
  result.library = rival.name;
  result.installed = true;
  if (rival.joints != static_cast<int>(subject.joints.size()) || rival.floating_base != subject.floating_base)
    result.reason = "was generated from another robot";
  else
    result.peer = std::make_unique<GeneratedPeer>(rival, subject);
  return result;
}

}  // namespace robcogen::rivals
