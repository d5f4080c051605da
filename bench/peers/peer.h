// Other libraries for rigid-body dynamics, each behind the same few calls: they judge the generated code's results in
// the tests and its speed in the benchmarks. A peer reads the robot from a URDF and shares no code with the generator.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace robcogen::peers {

// A state in the conventions of generated code: joints in the order of Subject::joints, rad and m; spatial vectors
// angular first, in base coordinates about the base's origin; the base acceleration is spatial, gravity not included.
// With a fixed base, the base's vectors are ignored. The base frame coincides with the world frame.
struct State {
  Eigen::VectorXd q, qd, qdd, tau;
  Eigen::Matrix<double, 6, 1> base_velocity, base_acceleration;
};

enum class Quantity {
  inverse_dynamics,  // tau of (q, qd, qdd); floating: (base wrench, tau), the base acceleration given
  forward_dynamics,  // qdd of (q, qd, tau); floating: (base acceleration, qdd), no wrench on the base
  inertia_matrix,    // dense and symmetric; floating: base first
  jacobian,          // 6 x dof, of the origin of Subject::link, with respect to the base, in base axes
  transform,         // 4 x 4, from coordinates of Subject::link to those of the base
};

constexpr bool is_of_link(Quantity quantity) {
  return quantity == Quantity::jacobian || quantity == Quantity::transform;
}

// The robot, and the link of Jacobian and transform.
struct Subject {
  std::string urdf;                 // path
  std::vector<std::string> joints;  // names, in the order of joint vectors
  bool floating_base = false;
  Eigen::Vector3d gravity = {0, 0, -9.81};  // m/s^2, base coordinates
  std::string link;                         // URDF link of Jacobian and transform; empty: neither is wanted
};

class Peer {
 public:
  virtual ~Peer() = default;
  virtual std::string name() const = 0;  // as its users write it: "KDL", "KDL chain", "MuJoCo"
  virtual bool has(Quantity quantity) const = 0;
  // Converts the states to the peer's own representation.
  virtual void prepare(const std::vector<State>& states) = 0;
  // Runs the peer's own computation for one of the prepared states, and nothing else: this is the timed part.
  virtual void run(Quantity quantity, std::size_t state) = 0;
  // The result of the last run, in the conventions above: a column, or a matrix.
  virtual Eigen::MatrixXd result(Quantity quantity) const = 0;
};

// The result of loading one library for one robot.
struct Candidate {
  std::string library;         // "KDL"
  std::unique_ptr<Peer> peer;  // null: `reason` says why
  bool installed = false;      // the library was found when this was compiled
  std::string reason;          // "not installed", "has no floating base", …
};

// One entry for each known library, in a fixed order, installed or not; a library may have several (KDL's chains and
// trees).
std::vector<Candidate> load(const Subject& subject);

}  // namespace robcogen::peers
