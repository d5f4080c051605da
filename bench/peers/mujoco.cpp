// MuJoCo: recursive Newton-Euler, composite rigid bodies and a sparse factorization. It reads URDF itself.
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "libraries.h"
#include "order.h"
#include "urdf_text.h"

namespace robcogen::peers {

namespace {

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
  void operator()(mjVFS* files) const {
    mj_deleteVFS(files);
    delete files;
  }
};
using ModelPtr = std::unique_ptr<mjModel, Deleter>;
using DataPtr = std::unique_ptr<mjData, Deleter>;
using FilesPtr = std::unique_ptr<mjVFS, Deleter>;

// MuJoCo writes warnings into a file of the working directory unless a handler takes them. Important ones are visible
// in the results.
void ignore(const char*) {}

// Links on fixed joints are fused, as MuJoCo does by default. The only shape left in the URDF is a point at the origin
// of the subject's link, which survives the fusion. A floating joint is added if the URDF has none.
std::string text_for_mujoco(const Subject& subject) {
  std::string urdf = dynamics_text(subject.urdf);
  if (!subject.link.empty()) {
    const char* point = "<visual><geometry><sphere radius=\"0.01\"/></geometry></visual>";
    urdf = with_link_elements(urdf, subject.link, point);
  }
  std::string elements = "<mujoco><compiler fusestatic=\"true\" discardvisual=\"false\" inertiafromgeom=\"false\"/>";
  elements += "</mujoco>";
  if (subject.floating_base && urdf.find("\"floating\"") == std::string::npos) {
    elements += "<link name=\"world\"/><joint name=\"floating base\" type=\"floating\"><parent link=\"world\"/>";
    elements += "<child link=\"" + root_link(urdf) + "\"/></joint>";
  }
  return with_elements(urdf, elements);
}

ModelPtr model_of(const Subject& subject) {
  mju_user_warning = ignore;
  const std::string urdf = text_for_mujoco(subject);
  const FilesPtr files(new mjVFS);
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "robot.urdf", static_cast<int>(urdf.size()));
  std::memcpy(files->filedata[0], urdf.data(), urdf.size());
  char error[1000] = "";
  ModelPtr model(mj_loadXML("robot.urdf", files.get(), error, sizeof error));
  mj_freeLastXML();
  if (!model) throw std::runtime_error(error);
  std::copy(subject.gravity.data(), subject.gravity.data() + 3, model->opt.gravity);
  return model;
}

int free_joint(const mjModel& model) {
  for (int j = 0; j < model.njnt; ++j) {
    if (model.jnt_type[j] == mjJNT_FREE) return j;
  }
  throw std::runtime_error("makes no floating base of the URDF");
}

// The velocity of a free joint is the velocity of the origin, then the angular velocity.
Order order_of(const mjModel& model, const Subject& subject) {
  Order order;
  if (subject.floating_base) {
    const int base = model.jnt_dofadr[free_joint(model)];
    for (const int row : {3, 4, 5, 0, 1, 2}) order.push_back(base + row);
  }
  for (const std::string& name : subject.joints) {
    const int joint = mj_name2id(&model, mjOBJ_JOINT, name.c_str());
    if (joint < 0) throw std::runtime_error("finds no joint " + name + " in the URDF");
    order.push_back(model.jnt_dofadr[joint]);
  }
  if (order.size() != static_cast<std::size_t>(model.nv)) throw std::runtime_error("finds other joints in the URDF");
  return order;
}

// The difference between the acceleration of a free joint, which is that of the point at the base's origin, and the
// spatial acceleration (Featherstone 2008, sec. 2.11).
Eigen::Matrix<double, 6, 1> excess_acceleration(const State& s) {
  const Eigen::Vector3d w = s.base_velocity.head<3>(), v = s.base_velocity.tail<3>();
  Eigen::Matrix<double, 6, 1> excess;
  excess << Eigen::Vector3d::Zero(), w.cross(v);
  return excess;
}

struct Arguments {
  Eigen::VectorXd qpos, qvel, qacc, tau;
  Eigen::Matrix<double, 6, 1> excess;
};

class Mujoco : public Peer {
 public:
  explicit Mujoco(const Subject& subject)
      : model_(model_of(subject)),
        data_(mj_makeData(model_.get())),
        floating_(subject.floating_base),
        order_(order_of(*model_, subject)),
        has_link_(!subject.link.empty()),
        vector_(model_->nv),
        J_(6, model_->nv) {}

  std::string name() const override { return "MuJoCo"; }

  bool has(Quantity quantity) const override { return !is_of_link(quantity) || has_link_; }

  void prepare(const std::vector<State>& states) override {
    const auto converted = [&](const Eigen::Matrix<double, 6, 1>& base, const Eigen::VectorXd& joints) {
      return to_library(order_, coordinates(floating_, base, joints));
    };
    states_.clear();
    for (const State& s : states) {
      const Eigen::Matrix<double, 6, 1> excess = excess_acceleration(s);
      states_.push_back(
          {positions(s.q), converted(s.base_velocity, s.qd), converted(s.base_acceleration + excess, s.qdd),
           converted(Eigen::Matrix<double, 6, 1>::Zero(), s.tau), excess});
    }
  }

  // Runs only the stages of MuJoCo that lead from the state to the quantity: mj_forward and mj_inverse would also look
  // for contacts and compute sensors, tendons, actuators and the constraints' forces.
  void run(Quantity quantity, std::size_t state) override {
    const Arguments& s = states_[state];
    state_ = state;
    copy(s.qpos, data_->qpos);
    mj_kinematics(model_.get(), data_.get());
    if (quantity != Quantity::transform) mj_comPos(model_.get(), data_.get());
    switch (quantity) {
      case Quantity::inverse_dynamics:
        copy(s.qvel, data_->qvel);
        copy(s.qacc, data_->qacc);
        mj_comVel(model_.get(), data_.get());
        mj_rne(model_.get(), data_.get(), 1, vector_.data());
        break;
      case Quantity::forward_dynamics:
        copy(s.qvel, data_->qvel);
        mj_crb(model_.get(), data_.get());
        mj_factorM(model_.get(), data_.get());
        mj_comVel(model_.get(), data_.get());
        mj_rne(model_.get(), data_.get(), 0, vector_.data());
        vector_ = s.tau - vector_;
        mj_solveM(model_.get(), data_.get(), vector_.data(), vector_.data(), 1);
        break;
      case Quantity::inertia_matrix:
        mj_crb(model_.get(), data_.get());
        break;
      case Quantity::jacobian:
        mj_jacGeom(model_.get(), data_.get(), J_.data() + 3 * model_->nv, J_.data(), 0);
        break;
      case Quantity::transform:
        break;
    }
  }

  Eigen::MatrixXd result(Quantity quantity) const override {
    switch (quantity) {
      case Quantity::jacobian:
        return jacobian();
      case Quantity::transform:
        return pose();
      case Quantity::inertia_matrix:
        return inertia_matrix();
      case Quantity::inverse_dynamics:
        return vector_from_library(order_, vector_);
      case Quantity::forward_dynamics:
        break;
    }
    Eigen::MatrixXd acceleration = vector_from_library(order_, vector_);
    if (floating_) acceleration.topRows<6>() -= states_[state_].excess;
    return acceleration;
  }

 private:
  static void copy(const Eigen::VectorXd& from, mjtNum* to) { std::copy(from.data(), from.data() + from.size(), to); }

  // The base is at the origin: position 0 0 0 and quaternion 1 0 0 0.
  Eigen::VectorXd positions(const Eigen::VectorXd& q) const {
    Eigen::VectorXd qpos = Eigen::VectorXd::Zero(model_->nq);
    if (floating_) qpos(model_->jnt_qposadr[free_joint(*model_)] + 3) = 1;
    const std::size_t first = order_.size() - static_cast<std::size_t>(q.size());
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const int joint = model_->dof_jntid[order_[first + static_cast<std::size_t>(j)]];
      qpos(model_->jnt_qposadr[joint]) = q(j);
    }
    return qpos;
  }

  // MuJoCo's matrix is sparse.
  Eigen::MatrixXd inertia_matrix() const {
    Eigen::MatrixXd H(model_->nv, model_->nv);
    mj_fullM(model_.get(), H.data(), data_->qM);
    return matrix_from_library(order_, H);
  }

  // The pose of the only shape.
  Eigen::MatrixXd pose() const {
    Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
    X.topLeftCorner<3, 3>() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->geom_xmat);
    X.topRightCorner<3, 1>() = Eigen::Map<const Eigen::Vector3d>(data_->geom_xpos);
    return X;
  }

  Eigen::MatrixXd jacobian() const {
    const Eigen::MatrixXd ordered = J_(Eigen::all, order_);
    return ordered.rightCols(model_->nv - (floating_ ? 6 : 0));
  }

  ModelPtr model_;
  DataPtr data_;
  bool floating_;
  Order order_;
  bool has_link_;
  std::vector<Arguments> states_;
  std::size_t state_ = 0;   // of the last run
  Eigen::VectorXd vector_;  // result of the last run
  Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor> J_;
};

}  // namespace

std::unique_ptr<Peer> load_mujoco(const Subject& subject) {
  return std::make_unique<Mujoco>(subject);
}

}  // namespace robcogen::peers
