// An independent reader of URDFs: urdfdom parses the text, and the formulas are textbook ones.
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
  // Throws if urdfdom refuses the text.
  explicit UrdfReader(const std::string& text);

  // urdfdom's warnings and errors.
  const std::string& complaints() const { return complaints_; }
  const urdf::ModelInterface& model() const { return *model_; }
  // The root link, or the floating link on it.
  const urdf::Link& base() const { return *base_; }

  using Positions = std::map<std::string, double>;  // by joint
  // base_X_link for all links below the base.
  std::map<std::string, Eigen::Isometry3d> poses(const Positions& q) const;
  // The sum of J' M J over all links; J maps (base twist, velocities of `joints` in this order) to the twist at the
  // centre of mass, angular first, in base coordinates: (6 + n) x (6 + n).
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
