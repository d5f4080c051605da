// MuJoCo as the judge of robots with loops. It holds the loops of the same tree closed by soft constraints, which
// approach the exact solution of this project as closely as required.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "document_tree.h"
#include "interpreted_robot.h"
#include "runge_kutta.h"

namespace robcogen::oracles {
namespace {

using numeric::InterpretedRobot;
using reference::Matrix;
using reference::Motion;
using reference::Vector;

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

model::KinematicTree robot_of(const std::string& name) {
  model::KinematicTree tree = numeric::tree_of_robot(ROBCOGEN_ROBOTS_DIR, name);
  tree.uses_passive_forces = false;
  return tree;
}

// The tree in MJCF: every joint is a degree of freedom, and loops are equality constraints.
class MjcfWriter {
 public:
  explicit MjcfWriter(const reflection::Robot& robot) : robot_(robot) {}

  std::string run() const {
    std::string text =
        "<mujoco><compiler angle=\"radian\" eulerseq=\"xyz\" autolimits=\"false\"/>"
        "<option gravity=\"0 0 -9.81\" tolerance=\"0\" iterations=\"200\" jacobian=\"dense\"/>"
        "<worldbody>" +
        inside(0) + "</worldbody>";
    std::string tendons, constraints;
    for (const reflection::Loop& loop : robot_.loops) {
      if (loop.type == reflection::LoopType::distance) {
        tendons += fmt::format("<spatial name=\"{}\">", loop.name);
        for (const int frame : loop.frames) tendons += fmt::format("<site site=\"{}\"/>", robot_.frames[frame].name);
        tendons += "</spatial>";
        constraints += fmt::format("<tendon tendon1=\"{}\" polycoef=\"0 0 0 0 0\"/>", loop.name);
      } else {
        const auto body = [&](int end) { return robot_.links[robot_.frames[loop.frames[end]].link].name; };
        constraints += fmt::format("<connect body1=\"{}\" body2=\"{}\" anchor=\"0 0 0\"/>", body(0), body(1));
      }
    }
    return text + "<tendon>" + tendons + "</tendon><equality>" + constraints + "</equality></mujoco>";
  }

 private:
  const reflection::Robot& robot_;

  static std::string three(const double (&v)[3]) { return fmt::format("{} {} {}", v[0], v[1], v[2]); }

  std::string inside(int link) const {
    std::string text;
    for (const reflection::Loop& loop : robot_.loops)
      for (const int index : loop.frames) {
        const reflection::Frame& frame = robot_.frames[index];
        if (frame.link == link && loop.type == reflection::LoopType::distance)
          text += fmt::format("<site name=\"{}\" pos=\"{}\"/>", frame.name, three(frame.translation));
      }
    for (const reflection::Joint& joint : robot_.joints)
      if (joint.parent == link) text += body(joint);
    return text;
  }

  std::string body(const reflection::Joint& joint) const {
    const reflection::Link& link = robot_.links[joint.child];
    const Matrix<double> I = reference::central_inertia<double>(link);
    return fmt::format(
               "<body name=\"{}\" pos=\"{}\" euler=\"{}\"><joint name=\"{}\" type=\"{}\" axis=\"0 0 1\" "
               "armature=\"{}\"/><inertial pos=\"{}\" mass=\"{}\" fullinertia=\"{} {} {} {} {} {}\"/>",
               link.name, three(joint.translation), three(joint.rotation), joint.name,
               joint.type == JointType::prismatic ? "slide" : "hinge", joint.drive.armature, three(link.com), link.mass,
               I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)) +
           inside(joint.child) + "</body>";
  }
};

class LoopsInMujoco : public testing::TestWithParam<std::string> {
 protected:
  LoopsInMujoco() {
    mju_user_warning = [](const char*) {};
    const std::string text = MjcfWriter(tables_).run(), file = "looped.xml";
    mjVFS files;
    mj_defaultVFS(&files);
    mj_makeEmptyFileVFS(&files, file.c_str(), static_cast<int>(text.size()));
    std::copy(text.begin(), text.end(), static_cast<char*>(files.filedata[0]));
    char error[1000] = "";
    model_.reset(mj_loadXML(file.c_str(), &files, error, sizeof error));
    mj_deleteVFS(&files);
    if (!model_) throw std::runtime_error(error + text);
    // Constraints are in the order of the file. The anchors are set to the frames, because MuJoCo derives the second
    // one from the drawn position, in which loops need not be closed.
    int tendon = 0;
    for (int k = 0; k < model_->neq; ++k) {
      mjtNum* data = model_->eq_data + k * mjNEQDATA;
      const reflection::Loop& loop = tables_.loops[k];
      if (model_->eq_type[k] == mjEQ_TENDON)
        data[0] = loop.length - model_->tendon_length0[tendon++];
      else
        for (int i = 0; i < 6; ++i) data[i] = tables_.frames[loop.frames[i / 3]].translation[i % 3];
    }
    data_.reset(mj_makeData(model_.get()));
  }

  // Sets the share of each constraint that holds, independent of its error; the rest is soft.
  void hold(double share, double frequency) {
    for (int k = 0; k < model_->neq; ++k) {
      for (int i = 0; i < 2; ++i) model_->eq_solimp[k * mjNIMP + i] = share;
      model_->eq_solref[k * mjNREF] = -frequency * frequency;
      model_->eq_solref[k * mjNREF + 1] = -2 * frequency;
    }
  }

  int address(int joint) const {
    return model_->jnt_dofadr[mj_name2id(model_.get(), mjOBJ_JOINT, tables_.joints[joint].name)];
  }

  // Sets the positions and velocities of all joints.
  void set(const Motion<double>& motion) {
    Motion<double> at_loops = motion;
    const reference::AtLoops closed(tables_, at_loops);
    const Vector<double> q = reference::joint_positions(closed.robot(), motion.q);
    const Vector<double> qd = reference::joint_rates(closed.robot(), motion.qd);
    for (int j = 0; j < tables_.joints.size; ++j) {
      data_->qpos[address(j)] = q(j);
      data_->qvel[address(j)] = qd(j);
    }
  }

  Vector<double> of_coordinates(const mjtNum* by_joint) const {
    Vector<double> result(tables_.dof());
    for (int c = 0; c < result.rows(); ++c) result(c) = by_joint[address(c)];
    return result;
  }

  Vector<double> acceleration(const Motion<double>& motion, const Vector<double>& tau) const {
    return robot_.forward_dynamics(motion, tau, {&gravity_, nullptr});
  }

  Vector<double> gravity_{0, 0, -9.81};
  InterpretedRobot robot_{robot_of(GetParam()), {}, numeric::all_steps(), {}, {}, {"forward_dynamics"}};
  reflection::Robot tables_ = robot_.tables();
  std::unique_ptr<mjModel, Deleter> model_;
  std::unique_ptr<mjData, Deleter> data_;
};

// At rest, the constraints act as the loops do except for their softness: accelerations approach the exact ones as the
// softness vanishes, and extrapolation from three of them gives the exact ones.
TEST_P(LoopsInMujoco, AccelerateAsItsSoftConstraintsDoInTheLimit) {
  constexpr double kSoft = 1e-2, kExtrapolated = 1e-6;
  std::mt19937_64 engine(5);
  for (int state = 0; state < 8; ++state) {
    reference::Sample sample;
    reference::draw(engine, tables_, sample);
    const Motion<double> motion = reference::at_rest(sample.motion.q);
    const Vector<double> tau = reference::uniform_vector(engine, tables_.dof(), 10.0);
    const Vector<double> expected = acceleration(motion, tau);
    // `times` is a multiple of the softness: once, twice and three times.
    const auto found = [&](int times) {
      mj_resetData(model_.get(), data_.get());
      set(motion);
      for (int c = 0; c < tables_.dof(); ++c) data_->qfrc_applied[address(c)] = tau(c);
      constexpr double kLeast = 1.0001e-4;
      hold(1 / (1 + times * kLeast), 100.0);
      mj_forward(model_.get(), data_.get());
      return of_coordinates(data_->qacc);
    };
    const Vector<double> once = found(1), limit = 3.0 * once - 3.0 * found(2) + found(3);
    const double scale = reference::largest(expected);
    EXPECT_LT(reference::largest(once - expected), kSoft * scale);
    EXPECT_LT(reference::largest(limit - expected), kExtrapolated * scale);
  }
}

// Half a second of motion under gravity, by Runge-Kutta steps in both programs. Springs keep the loops away from flat
// positions.
TEST_P(LoopsInMujoco, MoveAsItsStiffConstraintsLetThem) {
  constexpr double kNear = 1e-5;
  Motion<double> motion = reference::at_rest(Vector<double>(tables_.dof()));
  for (int c = 0; c < tables_.dof(); ++c) motion.qd(c) = c % 2 == 0 ? 0.6 : -0.4;
  mj_resetData(model_.get(), data_.get());
  set(motion);
  hold(0.9999, 1000.0);
  model_->opt.integrator = mjINT_RK4;
  model_->opt.timestep = 1e-4;
  const double stiffness = GetParam() == "palletiser" ? 400.0 : 30.0;
  for (int c = 0; c < tables_.dof(); ++c)
    model_->jnt_stiffness[mj_name2id(model_.get(), mjOBJ_JOINT, tables_.joints[c].name)] = stiffness;
  const auto of = [&](const Vector<double>& q, const Vector<double>& qd) {
    Motion<double> m = reference::at_rest(q);
    m.qd = qd;
    return acceleration(m, -stiffness * q);
  };
  double farthest = 0, worst = 0;
  for (int step = 0; step < 500; ++step) {
    numeric::runge_kutta_step(1e-3, of, motion.q, motion.qd);
    for (int k = 0; k < 10; ++k) mj_step(model_.get(), data_.get());
    farthest = std::max(farthest, reference::largest(motion.q));
    worst = std::max(worst, reference::largest(of_coordinates(data_->qpos) - motion.q));
  }
  EXPECT_GT(farthest, 0.01);
  EXPECT_LT(worst, kNear * farthest);
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    LoopsInMujoco,
    testing::Values("five_bar", "four_bar_leg", "palletiser", "achilles_leg"),
    [](const auto& robot) { return robot.param; });

}  // namespace
}  // namespace robcogen::oracles
