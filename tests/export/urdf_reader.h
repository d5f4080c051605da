// A URDF as an independent program reads it: urdfdom reads it, the formulas are those of any textbook.
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

namespace robcogen::test {

class UrdfReader {
 public:
  // Throws when urdfdom refuses the text.
  explicit UrdfReader(const std::string& text);

  // The warnings and errors of urdfdom.
  const std::string& complaints() const { return complaints_; }
  const urdf::ModelInterface& model() const { return *model_; }
  // The root, or the floating link on it.
  const urdf::Link& base() const { return *base_; }

  using Positions = std::map<std::string, double>;  // by joint
  // base_X_link of all links below the base.
  std::map<std::string, Eigen::Isometry3d> poses(const Positions& q) const;
  // The sum of J' M J over all links, where J takes (base twist, velocities of `joints` in this order) to the twist at
  // the centre of mass, angular first, base coordinates: (6 + n) x (6 + n).
  Eigen::MatrixXd inertia_matrix(const std::vector<std::string>& joints, const Positions& q) const;

 private:
  void add_poses(
      const urdf::Link& link,
      const Eigen::Isometry3d& pose,
      const Positions& q,
      std::map<std::string, Eigen::Isometry3d>& poses) const;

  urdf::ModelInterfaceSharedPtr model_;
  urdf::LinkConstSharedPtr base_;
  std::string complaints_;
};

}  // namespace robcogen::test
