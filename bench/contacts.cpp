// Forward dynamics of the quadruped on its feet, generated and by MuJoCo: the same result, then the time of a call.
//
//     contacts <URDF>
//
// In MuJoCo the feet are tied to the world by equality constraints, which are soft: constraint forces obey
// (J M^-1 J' + R) f = reference acceleration - J M^-1 (forces - bias). R is the compliance of the generated function,
// and the reference acceleration is its contact acceleration, except for velocity terms. Both are taken from MuJoCo, so
// that the results agree to rounding. Exit status 1: they do not.
#include "contacts.h"

#include <mujoco/mujoco.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace robcogen::bench {
namespace {

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using ModelPtr = std::unique_ptr<mjModel, Deleter>;
using DataPtr = std::unique_ptr<mjData, Deleter>;

ModelPtr load(const std::string& path) {
  char error[1000] = "";
  ModelPtr model(mj_loadXML(path.c_str(), nullptr, error, sizeof error));
  if (!model) throw std::runtime_error(error);
  return model;
}

// Loads the URDF in MuJoCo, and adds the feet to the text that MuJoCo writes of it.
ModelPtr model_with_feet(const std::string& urdf, const std::string& scratch) {
  {
    const ModelPtr model = load(urdf);
    char error[1000] = "";
    if (mj_saveLastXML(scratch.c_str(), model.get(), error, sizeof error) == 0) throw std::runtime_error(error);
    mj_freeLastXML();
  }
  std::ifstream in(scratch);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  in.close();
  std::string feet = "<equality>";
  for (const char* leg : {"LF", "RF", "LH", "RH"})
    feet += std::string("<connect body1=\"") + leg + "_lowerleg\" anchor=\"0.33 0 0\"/>";
  text.insert(text.rfind("</mujoco>"), feet + "</equality>");
  std::ofstream(scratch) << text;
  ModelPtr model = load(scratch);
  mj_freeLastXML();
  model->opt.disableflags |= mjDSBL_CONTACT | mjDSBL_LIMIT | mjDSBL_WARMSTART;
  model->opt.tolerance = 0;
  model->opt.iterations = 20;
  return model;
}

class Comparison {
 public:
  Comparison(const std::string& urdf, const Active& active)
      : active_(active), model_(model_with_feet(urdf, urdf + ".mujoco.xml")), data_(mj_makeData(model_.get())) {
    std::vector<const char*> names;  // after the floating joint
    for (int j = 1; j < model_->njnt; ++j) names.push_back(mj_id2name(model_.get(), mjOBJ_JOINT, j));
    const auto match = match_joints(quadruped::kJointNames, names);
    if (!match.order) throw std::runtime_error(std::string(match.name));
    order_.emplace(*match.order);
  }

  // A state in which the feet are where they are tied, with the accelerations and compliances of MuJoCo's constraints.
  Call call(std::mt19937_64& engine) {
    Call c = random_call(engine);
    set(c);
    namespace homogeneous = quadruped::transforms::homogeneous;
    const Eigen::Matrix4d feet[] = {
        homogeneous::fr_trunk_X_fr_LF_foot(c.state.q), homogeneous::fr_trunk_X_fr_RF_foot(c.state.q),
        homogeneous::fr_trunk_X_fr_LH_foot(c.state.q), homogeneous::fr_trunk_X_fr_RH_foot(c.state.q)};
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector4d place = c.state.pose.homogeneous() * feet[k].col(3);
      std::copy(place.data(), place.data() + 3, model_->eq_data + mjNEQDATA * k + 3);
      model_->eq_active[k] = active_[k] != 0;
    }
    mj_forward(model_.get(), data_.get());
    // The velocity terms, which MuJoCo leaves out; its base acceleration is that of the origin, not the spatial one.
    const Rows bias = quadruped::contact_bias(c.state.q, c.state.qd, c.state.base_velocity);
    const Twist& velocity = c.state.base_velocity;
    const Eigen::Vector3d excess = velocity.angular().cross(velocity.linear());
    for (int k = 0, row = 0; k < 4; ++k) {
      auto wanted = c.contact_acceleration.segment<3>(3 * k);
      auto compliance = c.compliance.segment<3>(3 * k);
      wanted.setZero();
      compliance.setZero();
      if (active_[k] == 0) continue;
      const Eigen::Map<const Eigen::Vector3d> reference(data_->efc_aref + row), R(data_->efc_R + row);
      wanted = c.state.pose.to_base_axes(reference) + bias.segment<3>(3 * k) - excess;
      compliance = R;
      row += 3;
    }
    return c;
  }

  void set(const Call& c) {
    to_mujoco(c.state, *order_, data_->qpos, data_->qvel);
    std::fill(data_->qfrc_applied, data_->qfrc_applied + 6, 0);
    order_->to(c.tau, data_->qfrc_applied + 6);
  }

  void run_theirs(const Call& c) {
    set(c);
    mj_forward(model_.get(), data_.get());
  }

  // The difference of the accelerations, relative to the largest.
  double difference(const Call& c) {
    const auto ours = run_generated(c, active_);
    run_theirs(c);
    const auto base = classical_from_spatial(ours.base_acceleration, c.state.base_velocity);
    Eigen::Matrix<double, 6 + kDof, 1> expected = Eigen::Matrix<double, 6 + kDof, 1>::Zero();
    expected.head<6>() << c.state.pose.to_world_axes(base.linear()), base.angular();
    order_->to(ours.qdd, expected.data() + 6);
    const Eigen::Map<const Eigen::Matrix<double, 6 + kDof, 1>> theirs(data_->qacc);
    return (theirs - expected).cwiseAbs().maxCoeff() / (1 + expected.cwiseAbs().maxCoeff());
  }

  // Times are measured with MuJoCo's default tolerance.
  void prepare_timing() {
    model_->opt.tolerance = 1e-8;
    model_->opt.iterations = 100;
    model_->opt.disableflags &= ~mjDSBL_WARMSTART;
  }

 private:
  Active active_;
  ModelPtr model_;
  DataPtr data_;
  std::optional<JointOrder<kDof>> order_;
};

}  // namespace
}  // namespace robcogen::bench

int main(int argc, char** argv) {
  using namespace robcogen::bench;
  return compare<Comparison>(
      "contacts", "MuJoCo", {Active(0, 0, 0, 0), Active(0, 1, 0, 0), Active(1, 0, 0, 1), Active(1, 1, 1, 1)}, argc,
      argv);
}
