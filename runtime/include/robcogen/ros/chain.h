// A chain of links of a generated robot, by the names of a robot description: poses and Jacobians of its links for
// vectors of its joints. What the plugins for ROS 2 share; it does not depend on ROS.
//
//     robcogen::ros::Chain<arm::Robot> chain;
//     const std::string problem = chain.select(arm::reflection::robot, "base_link", "tool0", {});
//     if (!problem.empty()) …
//     const Eigen::Isometry3d X = chain.pose(chain.positions(q), chain.find("tool0"));
//
// After selection nothing allocates or changes: any number of threads may use a chain.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "robcogen/matrix.h"
#include "robcogen/positions.h"
#include "robcogen/reflection.h"

namespace robcogen::ros {

// Whether the generator gives this name to an element that a robot description calls `theirs`: an underscore replaces
// each character that an identifier cannot have, and precedes a digit at the beginning. Names beyond ASCII are not
// converted.
inline bool is_name_of(std::string_view ours, std::string_view theirs) noexcept {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (!theirs.empty() && is_digit(theirs.front())) {
    if (ours.empty() || ours.front() != '_') return false;
    ours.remove_prefix(1);
  }
  const auto is_legal = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
  };
  return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(), [&](char a, char b) {
    return a == (is_legal(b) ? b : '_');
  });
}

// Whether a frame is that of a link that a robot description calls `theirs`: 0 if it is not, and the more, the
// likelier. A frame of a document is `fr_` and the name of its link; a link of a URDF is a frame with the name of the
// link, which has a suffix where the frame of another link has this name.
inline int is_frame_of(std::string_view ours, std::string_view theirs) noexcept {
  constexpr std::string_view kPrefix = "fr_", kSuffix = "_frame";
  if (is_name_of(ours, theirs)) return 2;
  if (ours.substr(0, kPrefix.size()) != kPrefix) return 0;
  if (is_name_of(ours.substr(kPrefix.size()), theirs)) return 1;
  const std::size_t size = ours.size() - std::min(ours.size(), kSuffix.size());
  return ours.substr(size) == kSuffix && is_name_of(ours.substr(0, size), theirs) ? 3 : 0;
}

// The frame of a link among those of the tables; -1 if there is none.
inline int find_frame(const reflection::Robot& robot, std::string_view link) noexcept {
  int found = -1, best = 0;
  for (int f = 0; f < robot.frames.size; ++f) {
    const int rank = is_frame_of(robot.frames[f].name, link);
    if (rank > best) found = f, best = rank;
  }
  return found;
}

// The pose of a frame in its link.
inline Eigen::Isometry3d pose_in_link(const reflection::Frame& frame) noexcept {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  const double* r = frame.rotation;
  X.linear() = (Eigen::AngleAxisd(r[0], Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(r[1], Eigen::Vector3d::UnitY()) *
                Eigen::AngleAxisd(r[2], Eigen::Vector3d::UnitZ()))
                   .toRotationMatrix();
  X.translation() = Eigen::Vector3d(frame.translation[0], frame.translation[1], frame.translation[2]);
  return X;
}

// `'a', 'b', 'c'`.
template <class Names>
std::string quoted_list(const Names& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "'" : ", '") + std::string(name) + "'";
  return text;
}

template <class R>
class Chain {
 public:
  static constexpr int kDof = R::kDof;
  using JointState = typename R::JointState;

  static_assert(kPositionCount<R> == kDof, "robots with spherical joints, or with loops in q, have no plugins for ROS");
  static_assert(kDof > 0, "a robot without joints has no plugins for ROS");

  // Selects the joints that move `tip` with respect to `base`, in their order on the path from `base` to `tip`; an
  // empty `base` is the root. If `joints` is not empty, vectors have its order; it must name all of these joints, and
  // may name others of the robot. Returns what is wrong; an empty text if nothing is.
  std::string select(
      const reflection::Robot& tables,
      const std::string& base,
      const std::string& tip,
      const std::vector<std::string>& joints,
      const R& robot = R()) {
    begin(tables, robot);
    list_links();
    int from = -1;
    for (const auto& [name, frame] : {std::pair<const std::string&, int*>(base, &from), {tip, &tip_}}) {
      *frame = find(name);
      if (*frame < 0 && !(frame == &from && name.empty())) return no_function(name);
    }
    base_ = from < 0 ? Link{} : links_[static_cast<std::size_t>(from)];
    // A coupled joint beyond the base may follow a joint before it, whose position the vectors would lack.
    if (tables.couplings.size > 0 && base_.joints().size > 0)
      return "the base '" + base +
             "' moves with respect to the root, which is not possible for a robot with coupled joints";
    const Link& end = links_[static_cast<std::size_t>(tip_)];
    std::vector<int> path;
    for (const int j : base_.joints())
      if (!end.has(j)) path.insert(path.begin(), j);
    for (const int j : end.joints())
      if (!base_.has(j)) path.push_back(j);
    if (path.empty())
      return "link '" + tip + "' does not move with respect to " + (base.empty() ? "the root" : "'" + base + "'");
    const std::string problem = joints.empty() ? set_order(path) : set_order(path, joints);
    if (problem.empty()) keep_links();
    return problem;
  }

  // Selects all joints, in the order of the model or of `joints`, which must name all of them.
  std::string select_all(
      const reflection::Robot& tables,
      const std::vector<std::string>& joints,
      const R& robot = R()) {
    begin(tables, robot);
    std::vector<int> all;
    for (int j = 0; j < kDof; ++j) all.push_back(j);
    return joints.empty() ? set_order(all) : set_order(all, joints);
  }

  // Forgets an earlier selection.
  void begin(const reflection::Robot& tables, const R& robot) {
    tables_ = &tables;
    robot_ = robot;
    joints_.clear();
    place_.fill(-1);
  }

  // Lists the links whose pose and Jacobian the library has with respect to the root, or that are fixed to it.
  void list_links() {
    links_.clear();
    const auto is_on_root = [&](int frame) { return tables_->frames[frame].link == 0; };
    for (int f = 0; f < tables_->frames.size; ++f) {
      Link link;
      link.frame = f;
      if (is_on_root(f)) {
        link.constant = pose_in_link(tables_->frames[f]);
        links_.push_back(link);
        continue;
      }
      for (int t = 0; t < tables_->transforms.size && link.transform < 0; ++t) {
        const reflection::Transform& transform = tables_->transforms[t];
        if (transform.right != f || !is_on_root(transform.left) || !transform.homogeneous.exists()) continue;
        link.transform = t;
        link.constant = pose_in_link(tables_->frames[transform.left]);
      }
      for (const reflection::Jacobian& jacobian : tables_->jacobians) {
        if (link.jacobian || jacobian.right != f || !is_on_root(jacobian.left)) continue;
        link.jacobian = &jacobian;
        link.axes = pose_in_link(tables_->frames[jacobian.left]).linear();
      }
      if (link.transform >= 0 && link.jacobian) links_.push_back(link);
    }
  }

  // Number of elements of the vectors, and the joint that each belongs to.
  int size() const noexcept { return static_cast<int>(joints_.size()); }
  const std::vector<int>& joints() const noexcept { return joints_; }
  std::vector<std::string> joint_names() const {
    std::vector<std::string> names;
    for (const int j : joints_) names.emplace_back(tables_->joints[j].name);
    return names;
  }

  const R& robot() const noexcept { return robot_; }
  const reflection::Robot& tables() const noexcept { return *tables_; }
  int tip() const noexcept { return tip_; }
  // The pose of the base in the root, at positions at which it does not depend on them.
  Eigen::Isometry3d base_in_root() const noexcept { return in_root(base_, JointState::Zero()); }
  bool base_moves() const noexcept { return base_.joints().size > 0; }

  // The index of a link that only joints of the chain move with respect to its base; -1 if there is none.
  int find(std::string_view link) const noexcept {
    const int frame = find_frame(*tables_, link);
    for (std::size_t k = 0; k < links_.size(); ++k)
      if (links_[k].frame == frame) return static_cast<int>(k);
    return -1;
  }
  std::string no_link(const std::string& name) const {
    return "link '" + name + "' is not among those that the chain moves: " + link_names();
  }

  // Joint positions of the robot from a vector of the chain; other joints are at zero. Also for velocities.
  template <class Vector>
  JointState positions(const Vector& q) const noexcept {
    JointState result = JointState::Zero();
    for (std::size_t k = 0; k < joints_.size(); ++k) result[joints_[k]] = q[static_cast<decltype(q.size())>(k)];
    return result;
  }

  // The pose of a link in the base.
  Eigen::Isometry3d pose(const JointState& q, int link) const noexcept {
    const Eigen::Isometry3d X = in_root(links_[static_cast<std::size_t>(link)], q);
    return base_.is_root() ? X : Eigen::Isometry3d(in_root(base_, q).inverse(Eigen::Isometry) * X);
  }

  // Sets J, 6 x size(), to the Jacobian of the origin of a link with respect to the base, in axes of the base. Unlike
  // elsewhere in this library, its linear rows come first, as in ROS.
  template <class Matrix>
  void jacobian(const JointState& q, int link, Matrix& J) const noexcept {
    const Link& end = links_[static_cast<std::size_t>(link)];
    J.setZero();
    const Eigen::Isometry3d B = in_root(base_, q);
    const Eigen::Vector3d arm = base_.joints().size == 0 ? Eigen::Vector3d::Zero().eval()
                                                         : (in_root(end, q).translation() - B.translation()).eval();
    add_columns(end, base_, q, B.linear(), Eigen::Vector3d::Zero(), 1, J);
    // The base turns and moves, which a link seen from it does the other way.
    add_columns(base_, end, q, B.linear(), arm, -1, J);
  }

 private:
  struct Link {
    int frame = -1;
    int transform = -1;  // -1: the pose is constant
    const reflection::Jacobian* jacobian = nullptr;
    // The pose in the root, if it is constant, or that of the left frames of the functions.
    Eigen::Isometry3d constant = Eigen::Isometry3d::Identity();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

    bool is_root() const noexcept { return frame < 0; }
    reflection::Table<int> joints() const noexcept {
      return jacobian ? reflection::Table<int>{jacobian->columns, jacobian->column_count}
                      : reflection::Table<int>{nullptr, 0};
    }
    bool has(int joint) const noexcept {
      const auto all = joints();
      return std::find(all.begin(), all.end(), joint) != all.end();
    }
  };

  const reflection::Robot* tables_ = nullptr;
  R robot_{};
  std::vector<int> joints_;
  std::array<int, static_cast<std::size_t>(kDof)> place_{};  // in the vectors, of joints of the path; -1: other joints
  std::vector<Link> links_;
  Link base_;
  int tip_ = -1;

  // Without the frames of the base and of joints on it, which descriptions do not have.
  std::string link_names() const {
    std::vector<std::string> names;
    for (const Link& link : links_) {
      const std::string name = tables_->frames[link.frame].name;
      if (link.transform >= 0 || name.rfind("fr_", 0) != 0) names.push_back(name);
    }
    return quoted_list(names);
  }

  std::string no_function(const std::string& name) const {
    const std::string robot = tables_->name;
    if (find_frame(*tables_, name) < 0)
      return "robot '" + robot + "' has no link '" + name + "'; its links are " + link_names();
    return "the library of robot '" + robot + "' has no transform and Jacobian of link '" + name +
           "': name it in FRAMES of robcogen_add_robot, or use FRAMES *; it has those of " + link_names();
  }

  std::string set_order(const std::vector<int>& path) {
    joints_ = path;
    for (std::size_t k = 0; k < path.size(); ++k) place_[static_cast<std::size_t>(path[k])] = static_cast<int>(k);
    return "";
  }

  std::string set_order(const std::vector<int>& path, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      int joint = 0;
      while (joint < kDof && !is_name_of(tables_->joints[joint].name, name)) ++joint;
      if (joint == kDof) {
        std::vector<std::string> known;
        for (int j = 0; j < kDof; ++j) known.emplace_back(tables_->joints[j].name);
        return "robot '" + std::string(tables_->name) + "' has no joint '" + name + "'; its joints are " +
               quoted_list(known);
      }
      if (std::find(joints_.begin(), joints_.end(), joint) != joints_.end())
        return "joint '" + name + "' is listed twice";
      joints_.push_back(joint);
    }
    for (const int j : path) {
      const auto at = std::find(joints_.begin(), joints_.end(), j);
      if (at == joints_.end())
        return "joint '" + std::string(tables_->joints[j].name) + "' is missing among the joints";
      place_[static_cast<std::size_t>(j)] = static_cast<int>(at - joints_.begin());
    }
    return "";
  }

  // Keeps the links that only joints of the path move with respect to the base.
  void keep_links() {
    const int frame = links_[static_cast<std::size_t>(tip_)].frame;
    const auto depends_on = [&](const Link& a, const Link& b) {
      for (const int j : a.joints())
        if (!b.has(j) && place_[static_cast<std::size_t>(j)] < 0) return true;
      return false;
    };
    links_.erase(
        std::remove_if(
            links_.begin(), links_.end(),
            [&](const Link& link) { return depends_on(link, base_) || depends_on(base_, link); }),
        links_.end());
    for (std::size_t k = 0; k < links_.size(); ++k)
      if (links_[k].frame == frame) tip_ = static_cast<int>(k);
  }

  const double* cache() const noexcept {
    if constexpr (HasParameters<R>::value)
      return robot_.parameters.data();
    else
      return nullptr;
  }
  template <class T, class = void>
  struct HasParameters : std::false_type {};
  template <class T>
  struct HasParameters<T, std::void_t<decltype(std::declval<const T&>().parameters.data())>> : std::true_type {};

  Eigen::Isometry3d in_root(const Link& link, const JointState& q) const noexcept {
    if (link.transform < 0) return link.constant;
    Eigen::Isometry3d X;
    tables_->transforms[link.transform].homogeneous(cache(), q.data(), X.matrix().data());
    return link.constant * X;
  }

  // Adds `sign` times the columns of `moved`, except those of joints that also move `other`, in axes of the base B; the
  // linear rows are those of the point at `arm` from the origin.
  template <class Matrix>
  void add_columns(
      const Link& moved,
      const Link& other,
      const JointState& q,
      const Eigen::Matrix3d& B,
      const Eigen::Vector3d& arm,
      double sign,
      Matrix& J) const noexcept {
    if (!moved.jacobian) return;
    Eigen::Matrix<double, 6, kDof> columns;
    moved.jacobian->kernel(cache(), q.data(), columns.data());
    for (int c = 0; c < moved.jacobian->column_count; ++c) {
      const int joint = moved.jacobian->columns[c], place = place_[static_cast<std::size_t>(joint)];
      if (place < 0 || other.has(joint)) continue;
      const Eigen::Vector3d w = moved.axes * columns.col(c).template head<3>();
      const Eigen::Vector3d v = moved.axes * columns.col(c).template tail<3>() + w.cross(arm);
      J.col(place).template head<3>() += sign * (B.transpose() * v);
      J.col(place).template tail<3>() += sign * (B.transpose() * w);
    }
  }
};

}  // namespace robcogen::ros
