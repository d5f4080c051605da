// Reflection tables that own their data: robots that tests make at run time.
#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <string>
#include <vector>

#include "robcogen/reflection.h"

namespace robcogen::reference {

using Triple = std::array<double, 3>;

// The tables grow link by link. `robot` is a view that is valid as long as the tables live and do not grow.
class Tables {
 public:
  explicit Tables(const std::string& name, bool floating_base = false) : floating_base_(floating_base) {
    name_ = stored(name);
  }
  Tables(const Tables&) = delete;
  Tables& operator=(const Tables&) = delete;
  Tables(Tables&&) = default;
  Tables& operator=(Tables&&) = default;

  // Mass properties of a link, about the link origin; products of inertia have positive sign.
  struct Body {
    double mass = 0;
    Triple com{};
    std::array<double, 6> inertia{};
  };

  // The first link is the base. Returns the link's index.
  int add_link(const std::string& name, const Body& body) {
    links_.push_back({stored(name), -1, body.mass, {}, {}});
    std::copy(body.com.begin(), body.com.end(), links_.back().com);
    std::copy(body.inertia.begin(), body.inertia.end(), links_.back().inertia);
    return static_cast<int>(links_.size()) - 1;
  }

  // Returns the joint's index.
  int add_joint(
      const std::string& name,
      JointType type,
      int parent,
      int child,
      const Triple& translation = {},
      const Triple& rotation = {}) {
    joints_.push_back({stored(name), type, parent, child, {}, {}});
    std::copy(translation.begin(), translation.end(), joints_.back().translation);
    std::copy(rotation.begin(), rotation.end(), joints_.back().rotation);
    // For a spherical joint, this is its first component.
    int& parent_joint = links_[static_cast<std::size_t>(child)].parent_joint;
    if (parent_joint < 0) parent_joint = static_cast<int>(joints_.size()) - 1;
    return static_cast<int>(joints_.size()) - 1;
  }

  void set_pitch(int joint, double pitch) { joints_[static_cast<std::size_t>(joint)].pitch = pitch; }
  void set_assembled(int joint, double position) { joints_[static_cast<std::size_t>(joint)].assembled = position; }
  void set_drive(int joint, const JointDrive& drive) { joints_[static_cast<std::size_t>(joint)].drive = drive; }

  // Couples the last joints in their order: the next one follows the others by these factors.
  void add_coupling(const std::vector<double>& factors, double offset, double assembled = 0) {
    const std::vector<double>& kept = factors_.emplace_back(factors);
    couplings_.push_back({kept.data(), offset, assembled});
  }

  // Factors are those of all joints, in order.
  void add_tendon(
      const std::string& name,
      const std::vector<double>& factors,
      double stiffness,
      double damping,
      double rest) {
    const std::vector<double>& kept = factors_.emplace_back(factors);
    tendons_.push_back({stored(name), kept.data(), stiffness, damping, rest});
  }

  // Frames are given by index. Joints that follow through loops have couplings whose factors are NaN.
  void add_loop(const std::string& name, reflection::LoopType type, int first, int second, double length) {
    loops_.push_back({stored(name), type, {first, second}, length});
  }

  // Adds a coupled joint whose position is an element of q.
  void add_follower(int joint, double assembled) { followers_.push_back({joint, assembled}); }

  // Returns the frame's index.
  int add_frame(const std::string& name, int link, const Triple& translation = {}, const Triple& rotation = {}) {
    frames_.push_back({stored(name), link, {}, {}});
    std::copy(translation.begin(), translation.end(), frames_.back().translation);
    std::copy(rotation.begin(), rotation.end(), frames_.back().rotation);
    return static_cast<int>(frames_.size()) - 1;
  }

  void add_contact(int frame, bool is_surface) { contacts_.push_back({frame, is_surface}); }

  // Frames are given by index; there are no kernels.
  void add_transform(const std::string& name, int left, int right) {
    transforms_.push_back({stored(name), left, right, nullptr, nullptr, nullptr});
  }
  void add_jacobian(const std::string& name, int left, int right, const std::vector<int>& columns) {
    const std::vector<int>& kept = columns_.emplace_back(columns);
    jacobians_.push_back({stored(name), left, right, kept.data(), static_cast<int>(kept.size()), nullptr});
  }

  // `columns` are those of a Jacobian; other quantities have one column.
  void add_frame_function(
      const std::string& name,
      reflection::FrameQuantity quantity,
      int left,
      int right,
      const std::vector<int>& columns) {
    const std::vector<int>& kept = columns_.emplace_back(columns);
    const int column_count = reflection::is_jacobian(quantity) ? static_cast<int>(kept.size()) : 1;
    frame_functions_.push_back({stored(name), quantity, left, right, kept.data(), column_count, nullptr});
  }

  reflection::Robot robot() const {
    reflection::Robot robot = {name_,         floating_base_,    view(links_),     view(joints_),
                               view(frames_), view(transforms_), view(jacobians_), view(frame_functions_),
                               {nullptr, 0}};
    robot.couplings = view(couplings_);
    robot.contacts = view(contacts_);
    robot.loops = view(loops_);
    robot.followers = view(followers_);
    robot.tendons = view(tendons_);
    return robot;
  }

 private:
  const char* stored(const std::string& text) { return names_.emplace_back(text).c_str(); }

  template <class T>
  static reflection::Table<T> view(const std::vector<T>& items) {
    return {items.data(), static_cast<int>(items.size())};
  }

  bool floating_base_ = false;
  const char* name_ = nullptr;
  std::deque<std::string> names_;  // a deque: growing and moving keep the strings in place
  std::vector<reflection::Link> links_;
  std::vector<reflection::Joint> joints_;
  std::vector<reflection::Frame> frames_;
  std::vector<reflection::Transform> transforms_;
  std::deque<std::vector<int>> columns_;
  std::deque<std::vector<double>> factors_;
  std::vector<reflection::Coupling> couplings_;
  std::vector<reflection::Contact> contacts_;
  std::vector<reflection::Loop> loops_;
  std::vector<reflection::Follower> followers_;
  std::vector<reflection::Tendon> tendons_;
  std::vector<reflection::Jacobian> jacobians_;
  std::vector<reflection::FrameFunction> frame_functions_;
};

}  // namespace robcogen::reference
