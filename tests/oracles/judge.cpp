#include "judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace robcogen::oracles {

namespace {

using peers::Quantity;

// Largest error relative to the largest element of the quantity, for two programs in double precision, some dozens of
// links, and light links on heavy ones. An error in a model is millions of times larger.
constexpr double kAgreement = 1e-9;
constexpr int kStates = 100;
constexpr std::uint64_t kSeed = 31;

struct Library {
  std::string name;
  std::string package;  // Debian's
  std::vector<Quantity> quantities;
};

const std::vector<Quantity> kAll = {
    Quantity::inverse_dynamics, Quantity::forward_dynamics, Quantity::inertia_matrix, Quantity::jacobian};

const std::vector<Library> kLibraries = {
    {"KDL", "liborocos-kdl-dev", {Quantity::inverse_dynamics, Quantity::jacobian}},
    {"KDL chain", "liborocos-kdl-dev", kAll},
    {"DART", "libdart-utils-urdf-dev", kAll},
    {"MuJoCo", "libmujoco-dev", kAll}};

const char* name(Quantity quantity) {
  switch (quantity) {
    case Quantity::inverse_dynamics:
      return "inverse dynamics";
    case Quantity::forward_dynamics:
      return "forward dynamics";
    case Quantity::inertia_matrix:
      return "inertia matrix";
    case Quantity::transform:  // checked by `bench` before it measures
      return "transform";
    case Quantity::jacobian:
      break;
  }
  return "Jacobian";
}

// ---- States, and the expected results.

struct State {
  reference::Motion<double> motion;
  reference::Vector<double> tau;
};

std::vector<State> random_states(const reflection::Robot& robot) {
  constexpr double kForce = 20;  // N or N m
  std::mt19937_64 engine(kSeed);
  std::vector<State> states;
  for (int i = 0; i < kStates; ++i) {
    const reference::Motion<double> motion = reference::random_sample(engine, robot).motion;
    states.push_back({motion, reference::uniform_vector(engine, robot.joints.size, kForce)});
  }
  return states;
}

peers::State converted(const State& s) {
  const reference::Motion<double>& m = s.motion;
  return {
      to_eigen(m.q),
      to_eigen(m.qd),
      to_eigen(m.qdd),
      to_eigen(s.tau),
      to_eigen(m.base_velocity),
      to_eigen(m.base_acceleration)};
}

std::vector<peers::State> converted(const std::vector<State>& states) {
  std::vector<peers::State> result;
  for (const State& s : states) result.push_back(converted(s));
  return result;
}

// Has a column for each joint, which is zero if the joint is not in the chain.
Eigen::MatrixXd full_jacobian(const Judged& robot, int index, const reference::Vector<double>& q) {
  const reflection::Jacobian& what = robot.tables.jacobians[index];
  const Eigen::MatrixXd narrow = to_eigen(robot.jacobian(index, q));
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(6, q.rows());
  for (int i = 0; i < what.column_count; ++i) J.col(what.columns[i]) = narrow.col(i);
  return J;
}

// ---- Frames of the robot and links of its URDF.

bool is_base(const reflection::Frame& frame) {
  const auto is_zero = [](double x) { return x == 0; };
  return frame.link == 0 && std::all_of(frame.translation, frame.translation + 3, is_zero) &&
         std::all_of(frame.rotation, frame.rotation + 3, is_zero);
}

// In the URDF a user frame is a link; the frame fr_<link> of a link is that link.
std::string urdf_link(const reflection::Robot& robot, const reflection::Frame& frame) {
  for (const reflection::Link& link : robot.links) {
    if (frame.name == std::string("fr_") + link.name) return link.name;
  }
  return frame.name;
}

// ---- Judgement.

template <class Decision>
const Decision* find(const std::vector<Decision>& decisions, const std::string& library, const std::string& robot) {
  for (const Decision& d : decisions) {
    if (d.library == library && d.robot == robot) return &d;
  }
  return nullptr;
}

std::string urdf_name(const Judged& robot, const std::string& name) {
  const auto found = robot.urdf_names.find(name);
  return found == robot.urdf_names.end() ? name : found->second;
}

peers::Candidate load(
    const Library& library,
    const Judged& robot,
    const reference::Vector<double>& gravity,
    const std::string& link) {
  peers::Subject subject;
  subject.urdf = robot.urdf;
  for (const reflection::Joint& joint : robot.tables.joints) subject.joints.push_back(urdf_name(robot, joint.name));
  subject.floating_base = robot.tables.floating_base;
  subject.gravity = to_eigen(gravity);
  subject.link = urdf_name(robot, link);
  for (peers::Candidate& candidate : peers::load(subject)) {
    if (candidate.library == library.name) return std::move(candidate);
  }
  throw std::logic_error("no library " + library.name);
}

// The worst error of all states; NaN if a result is not finite or has another shape.
double worst_error(
    peers::Peer& peer,
    Quantity quantity,
    const std::vector<State>& states,
    const std::function<Eigen::MatrixXd(const State&)>& expected) {
  peer.prepare(converted(states));
  double worst = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    peer.run(quantity, i);
    const Eigen::MatrixXd theirs = peer.result(quantity), ours = expected(states[i]);
    if (theirs.rows() != ours.rows() || theirs.cols() != ours.cols()) return std::nan("");
    if (!theirs.allFinite() || !ours.allFinite()) return std::nan("");
    const double error = (theirs - ours).cwiseAbs().maxCoeff();
    if (error > 0) worst = std::max(worst, error / ours.cwiseAbs().maxCoeff());
  }
  return worst;
}

class JudgeTest : public testing::Test {
 public:
  JudgeTest(Library library, std::function<Judged()> make, const Refusal* refusal, double tolerance)
      : library_(std::move(library)), make_(std::move(make)), refusal_(refusal), tolerance_(tolerance) {}

  void TestBody() override {
    const Judged robot = make_();
    const std::vector<State> states = random_states(robot.tables);
    const reference::Vector<double> standard{0, 0, -9.81}, other{3, -1, 7};
    for (const reference::Vector<double>& gravity : {standard, other}) {
      const auto peer = agreed_load(robot, gravity, "");
      if (!peer) return;
      for (const Quantity quantity : library_.quantities) {
        if (quantity == Quantity::jacobian) continue;
        expect_agreement(*peer, quantity, "", states, [&](const State& s) {
          return robot.dynamics(quantity, s.motion, s.tau, gravity);
        });
      }
    }
    for (int j = 0; j < robot.tables.jacobians.size; ++j) {
      const reflection::Jacobian& jacobian = robot.tables.jacobians[j];
      if (!is_base(robot.tables.frames[jacobian.left])) continue;
      const auto peer = agreed_load(robot, standard, urdf_link(robot.tables, robot.tables.frames[jacobian.right]));
      if (!peer) return;
      expect_agreement(*peer, Quantity::jacobian, jacobian.name, states, [&](const State& s) {
        return full_jacobian(robot, j, s.motion.q);
      });
    }
  }

 private:
  // Returns nullptr if there is nothing to judge with. If that is a fault, it has been reported.
  std::unique_ptr<peers::Peer> agreed_load(
      const Judged& robot,
      const reference::Vector<double>& gravity,
      const std::string& link) {
    peers::Candidate candidate = load(library_, robot, gravity, link);
    if (!candidate.installed) {
      report_missing();
      return nullptr;
    }
    if (refusal_ == nullptr) {
      EXPECT_TRUE(candidate.peer) << library_.name << " refuses unexpectedly: " << candidate.reason;
      return std::move(candidate.peer);
    }
    EXPECT_FALSE(candidate.peer) << library_.name << " is expected to refuse: " << refusal_->reason;
    EXPECT_NE(candidate.reason.find(refusal_->reason), std::string::npos) << candidate.reason;
    return nullptr;
  }

  void report_missing() const {
    const std::string message = library_.name + " is missing; Debian's package is " + library_.package;
    if (library_.name == "DART" ? REQUIRE_DART : REQUIRE_ORACLES) FAIL() << message;
    GTEST_SKIP() << message;
  }

  void expect_agreement(
      peers::Peer& peer,
      Quantity quantity,
      const std::string& which,
      const std::vector<State>& states,
      const std::function<Eigen::MatrixXd(const State&)>& expected) const {
    ASSERT_TRUE(peer.has(quantity)) << name(quantity) << " " << which;
    const double error = worst_error(peer, quantity, states, expected);
    std::printf("%s, %s %s: %.1e\n", library_.name.c_str(), name(quantity), which.c_str(), error);
    EXPECT_LE(error, tolerance_) << name(quantity) << " " << which;
  }

  Library library_;
  std::function<Judged()> make_;
  const Refusal* refusal_;
  double tolerance_;
};

}  // namespace

void register_tests(const std::string& robot, const std::function<Judged()>& make, const Decisions& decisions) {
  for (const Library& library : kLibraries) {
    std::string test = library.name;
    std::replace(test.begin(), test.end(), ' ', '_');
    const Refusal* refusal = find(decisions.refusals, library.name, robot);
    const Tolerance* tolerance = find(decisions.tolerances, library.name, robot);
    testing::RegisterTest(robot.c_str(), test.c_str(), nullptr, nullptr, __FILE__, __LINE__, [=] {
      return new JudgeTest(library, make, refusal, tolerance == nullptr ? kAgreement : tolerance->relative);
    });
  }
}

}  // namespace robcogen::oracles
