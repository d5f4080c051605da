// Whole-body control: joint forces that make a robot on feet fulfil its tasks, with forces of the ground that stay
// within their friction cones.
//
// Tasks are desired accelerations that are linear in the accelerations a of the base and the joints: of the centre of
// mass and the angular momentum (Orin, Goswami, Lee 2013), of the base's orientation, of feet in the air, of the
// joints. The controller minimises the weighted squares of their errors, subject to the dynamics of the base and to
// feet that stick to the ground. Forces are combinations, with coefficients x >= 0, of the edges of friction cones,
// plus a least vertical force.
#pragma once

#include <cmath>

#include "body.h"
#include "motion_program.h"

namespace whole_body {

// The goal of the robot, in the world.
template <Body B>
struct Goal {
  Vector3d com, com_velocity = Vector3d::Zero(), com_acceleration = Vector3d::Zero();
  typename B::Robot::JointState posture = B::posture();
  // Contacts stick to the ground if they hold; the origins of others follow a motion in the air. The base stays level.
  struct Foot {
    bool holds = true;
    Vector3d position = Vector3d::Zero(), velocity = Vector3d::Zero(), acceleration = Vector3d::Zero();
  };
  std::array<Foot, B::kContacts> feet;
};

struct Settings {
  double friction = 0.5;  // of the cones from which forces are chosen
  // Frequencies (1/s) of the errors of tasks, which are critically damped, and weights of their accelerations.
  double com_frequency = 6, com_weight = 100;
  double momentum_decay = 5, momentum_weight = 1;  // of the angular momentum
  double base_frequency = 12, base_weight = 30;
  double posture_frequency = 6, posture_weight = 0.1;
  double foot_frequency = 40, foot_weight = 300;
  double hold_decay = 30;      // 1/s, of velocities of feet that hold
  double force_weight = 1e-6;  // of squares of the coefficients of edges
  double least_force = 20;     // N, vertical, of each contact that holds; without it, the contact would slide easily
};

template <Body B>
class Controller {
 public:
  using S = Sizes<B>;
  using Robot = typename B::Robot;
  using JointState = typename Robot::JointState;
  using Coordinates = typename S::Coordinates;

  explicit Controller(const Settings& settings) : settings_(settings) {
    edges_.setZero();
    for (int point = 0; point < S::kPoints; ++point)
      for (int k = 0; k < kEdges; ++k) {
        const double angle = 2 * M_PI * k / kEdges;
        edges_.template block<3, 1>(3 * point, kEdges * point + k) << settings.friction * std::cos(angle),
            settings.friction * std::sin(angle), 1;
      }
  }

  struct Command {
    JointState tau;                  // N m
    Coordinates acceleration;        // expected, of the base (spatial), then of the joints
    typename S::PointVector forces;  // expected, of the ground on the points (N), world axes
    robcogen::Wrench missing;        // on the base, not provided by the forces because of rounding
    bool is_best;
  };

  Command operator()(const StateOf<B>& state, const Goal<B>& goal) {
    const Robot robot;
    const typename Robot::JointTrigonometry at(state.q);
    const auto gravity = gravity_in_base(state);
    const ContactPoints<B> points(state);
    const Contacts contacts{
        robot.contact_jacobian(at), robot.contact_velocity(at, state.qd, state.base_velocity),
        robot.contact_bias(at, state.qd, state.base_velocity)};

    MotionProgram program(S::kCoordinates, 6 + S::kRows);
    add_balance(program, robot, at, state, goal);
    add_feet(program, state, goal, contacts);
    program.add_task(
        settings_.posture_weight,
        towards<JointState>(settings_.posture_frequency, goal.posture - state.q, JointState(-state.qd)));

    // The dynamics of the base: H a + bias = J' f.
    typename S::PointVector least = S::PointVector::Zero();
    Edges edges = edges_;
    for (int c = 0; c < B::kContacts; ++c) {
      const int first = 3 * B::kPointsPerContact * c;
      if (goal.feet[static_cast<std::size_t>(c)].holds)
        for (int k = 0; k < B::kPointsPerContact; ++k)
          least[first + 3 * k + 2] = settings_.least_force / B::kPointsPerContact;
      else
        edges.template middleRows<3 * B::kPointsPerContact>(first).setZero();
    }
    const Eigen::Matrix<double, 6, 3 * S::kPoints> on_base =
        contacts.J.template leftCols<6>().transpose() * points.map.transpose();
    const auto bias = robot.bias_forces(at, state.qd, state.base_velocity, gravity).base_wrench;
    const typename Robot::InertiaMatrix H = robot.joint_space_inertia(at);
    program.hold(0, H.template topRows<6>(), on_base * least - bias.vector());
    const auto solution = program.solve(on_base * edges, settings_.force_weight, x_);

    const typename S::PointVector forces = least + edges * x_;
    const auto needed = robot.inverse_dynamics_with_contacts(
        at, state.qd, JointState(solution.a.template tail<S::kDof>()), state.base_velocity,
        robcogen::SpatialAcceleration(solution.a.template head<6>()), points.map.transpose() * forces, gravity);
    return {needed.tau, solution.a, forces, needed.base_wrench, solution.is_best};
  }

 private:
  static constexpr int kEdges = 4;  // of a friction cone
  static_assert(S::kPoints * kEdges <= kMaxVariables && S::kCoordinates <= kMaxCoordinates && 6 + S::kRows <= kMaxHeld);
  using Edges = Eigen::Matrix<double, 3 * S::kPoints, S::kPoints * kEdges>;

  struct Contacts {
    Eigen::Matrix<double, S::kRows, S::kCoordinates> J;
    typename S::Rows velocity, bias;
  };

  // An acceleration that removes an error and a velocity error with critical damping.
  template <class Vector>
  static Vector towards(double frequency, const Vector& error, const Vector& velocity_error) {
    return frequency * frequency * error + 2 * frequency * velocity_error;
  }

  // Adds tasks of the centre of mass, the angular momentum and the orientation of the base, in base axes.
  void add_balance(
      MotionProgram& program,
      const Robot& robot,
      const typename Robot::JointTrigonometry& at,
      const StateOf<B>& state,
      const Goal<B>& goal) const {
    // The rate of the linear momentum divided by the mass is the acceleration of the centre of mass.
    const auto& pose = state.pose;
    const Eigen::Matrix<double, 6, S::kCoordinates> momentum = robot.centroidal_momentum_matrix(at);
    const Eigen::Matrix<double, 6, 1> bias = robot.centroidal_momentum_bias(at, state.qd, state.base_velocity);
    const Eigen::Matrix<double, 6, 1> now = momentum * velocity_of<B>(state);
    const Vector3d com = pose.position() + pose.to_world_axes(robot.center_of_mass(at));
    const Vector3d velocity = pose.to_world_axes(now.tail<3>() / B::kMass);
    const Vector3d acceleration =
        goal.com_acceleration +
        towards<Vector3d>(settings_.com_frequency, goal.com - com, goal.com_velocity - velocity);
    program.add_task(
        settings_.com_weight, momentum.template bottomRows<3>() / B::kMass,
        pose.to_base_axes(acceleration) - bias.tail<3>() / B::kMass);
    // The rate of the angular momentum becomes an acceleration, by an inertia of the mass at a distance of some 0.3 m.
    constexpr double kInertia = 0.1 * B::kMass;
    program.add_task(
        settings_.momentum_weight, momentum.template topRows<3>() / kInertia,
        (-settings_.momentum_decay * now.head<3>() - bias.head<3>()) / kInertia);

    const auto level = robcogen::BasePose::from_rotation(Matrix3d::Identity(), pose.position());
    const Vector3d turn = difference(pose, level).angular(), spin = state.base_velocity.angular();
    program.add_task(
        settings_.base_weight, Eigen::Matrix<double, 3, S::kCoordinates>::Identity(),
        towards<Vector3d>(settings_.base_frequency, turn, -spin));
  }

  // Feet that hold do not accelerate; those in the air follow their motion.
  void add_feet(MotionProgram& program, const StateOf<B>& state, const Goal<B>& goal, const Contacts& contacts) const {
    const auto& pose = state.pose;
    const auto frames = B::contact_frames(state.q);
    for (std::size_t c = 0; c < goal.feet.size(); ++c) {
      const auto& foot = goal.feet[c];
      const int first = static_cast<int>(c) * S::kRowsPerContact, linear = first + S::kRowsPerContact - 3;
      if (foot.holds) {
        program.hold(
            6 + first, contacts.J.template middleRows<S::kRowsPerContact>(first),
            -settings_.hold_decay * contacts.velocity.template segment<S::kRowsPerContact>(first) -
                contacts.bias.template segment<S::kRowsPerContact>(first));
        continue;
      }
      const Vector3d place = pose.position() + pose.to_world_axes(frames[c].template topRightCorner<3, 1>());
      const Vector3d velocity = pose.to_world_axes(contacts.velocity.template segment<3>(linear));
      const Vector3d acceleration =
          foot.acceleration +
          towards<Vector3d>(settings_.foot_frequency, foot.position - place, foot.velocity - velocity);
      program.add_task(
          settings_.foot_weight, contacts.J.template middleRows<3>(linear),
          pose.to_base_axes(acceleration) - contacts.bias.template segment<3>(linear));
    }
  }

  Settings settings_;
  Edges edges_;  // forces by unit coefficients, world axes
  NonnegativeVector x_ = NonnegativeVector::Zero(S::kPoints * kEdges);
};

}  // namespace whole_body
