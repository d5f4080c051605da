// Computes stiffness and damping of joints from `springdamper`.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "import/mjcf/read.h"
#include "import/mjcf/vector3.h"
#include "support/index.h"

namespace robcogen::import::from_mjcf {

namespace {

Matrix3 evaluated(const model::Placement& placement) {
  Matrix3 result;
  const auto R = model::rotation_matrix(placement);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) result[i][k] = model::evaluate(R[i][k]);
  return result;
}

Vector3 evaluated(const std::array<model::Quantity, 3>& v) {
  return {model::evaluate(v[0]), model::evaluate(v[1]), model::evaluate(v[2])};
}

// A direction in which a body moves, in axes of the world: the velocity of its points is v + w x p.
struct Freedom {
  std::size_t body = 0;  // that moves, with all that it carries
  Vector3 w = {}, v = {};
  double armature = 0.0;
};

struct Mass {
  double mass = 0.0;
  Vector3 center = {};
  Matrix3 tensor = {};  // about the center, in axes of the world
};

// The joint-space inertia of the robot in the pose of the file.
class InertiaMatrix {
 public:
  explicit InertiaMatrix(const Document& document) : document_(document) {
    poses_.resize(document.bodies.size());
    first_.resize(document.bodies.size());
    for (std::size_t b = 0; b < document.bodies.size(); ++b) {
      const Body& body = document.bodies[b];
      poses_[b] = body.parent < 0 ? body.pose : poses_[at(body.parent)] * body.pose;
      if (document.robot.has[b]) add_freedoms(b);
    }
    add_masses();
    factorize();
  }

  // The mean of the elements of the inverse on its diagonal, for the freedoms of a joint.
  double mean_of_inverse(std::size_t body, std::size_t joint) const {
    const auto [begin, count] = first_[body][joint];
    double sum = 0.0;
    for (std::size_t i = begin; i < begin + count; ++i) sum += element_of_inverse(i);
    return sum / static_cast<double>(count);
  }

 private:
  struct Range {
    std::size_t begin = 0, count = 0;
  };

  void add_freedoms(std::size_t b) {
    const Body& body = document_.bodies[b];
    const Vector3 origin = evaluated(poses_[b].translation);
    if (body.floats())
      for (std::size_t i = 0; i < 3; ++i) {
        Vector3 axis = {};
        axis[i] = 1.0;
        freedoms_.push_back({b, {}, axis, 0.0});
        freedoms_.push_back({b, axis, cross(origin, axis), 0.0});
      }
    for (const Joint& joint : body.joints) {
      const bool is_ball = joint.type == model::JointType::spherical;
      const Rotation to_axis = is_ball ? Rotation() : rotation_to_axis(joint.axis);
      const model::Placement placement = placement_of(poses_[b] * joint.frame * Pose{quantities(joint.pos), to_axis});
      const Matrix3 R = evaluated(placement);
      const Vector3 point = evaluated(placement.translation);
      const double armature = model::evaluate(joint.drive.armature);
      const std::size_t begin = freedoms_.size();
      for (std::size_t i = is_ball ? 0 : 2; i < 3; ++i) {
        const Vector3 axis = {R[0][i], R[1][i], R[2][i]};
        if (joint.type == model::JointType::prismatic)
          freedoms_.push_back({b, {}, axis, armature});
        else
          freedoms_.push_back({b, axis, cross(point, axis), armature});
      }
      first_[b].push_back({begin, freedoms_.size() - begin});
    }
  }

  static Mass evaluated_mass(const Part& part, const Pose& body) {
    Mass result;
    const model::Placement placement = placement_of(body * part.pose);
    const Matrix3 R = evaluated(placement);
    result.mass = part.mass.value();
    result.center = evaluated(placement.translation);
    const double xy = part.xy.value(), xz = part.xz.value(), yz = part.yz.value();
    const Matrix3 own = {{{part.xx.value(), xy, xz}, {xy, part.yy.value(), yz}, {xz, yz, part.zz.value()}}};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) result.tensor[i][k] = dot(R[i], own * R[k]);
    return result;
  }

  void add_masses() {
    const std::size_t n = freedoms_.size();
    H_.assign(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i) H_[i][i] = freedoms_[i].armature;
    for (std::size_t b = 0; b < document_.bodies.size(); ++b)
      for (const Part& part : document_.bodies[b].parts) add_mass(b, evaluated_mass(part, poses_[b]));
  }

  void add_mass(std::size_t b, const Mass& mass) {
    for (std::size_t i = 0; i < freedoms_.size(); ++i) {
      if (!carries(freedoms_[i].body, b)) continue;
      const Vector3 momentum_arm = velocity(freedoms_[i], mass.center), spin = mass.tensor * freedoms_[i].w;
      for (std::size_t k = 0; k <= i; ++k)
        if (carries(freedoms_[k].body, b))
          H_[i][k] += mass.mass * dot(momentum_arm, velocity(freedoms_[k], mass.center)) + dot(spin, freedoms_[k].w);
    }
  }

  static Vector3 velocity(const Freedom& freedom, const Vector3& point) { return freedom.v + cross(freedom.w, point); }

  bool carries(std::size_t ancestor, std::size_t body) const {
    for (int b = static_cast<int>(body); b >= 0; b = document_.bodies[at(b)].parent)
      if (at(b) == ancestor) return true;
    return false;
  }

  // H = L L^T, in place.
  void factorize() {
    for (std::size_t i = 0; i < H_.size(); ++i)
      for (std::size_t k = 0; k <= i; ++k) {
        double sum = H_[i][k];
        for (std::size_t j = 0; j < k; ++j) sum -= H_[i][j] * H_[k][j];
        H_[i][k] = i == k ? std::sqrt(sum) : sum / H_[k][k];
      }
  }

  double element_of_inverse(std::size_t i) const {
    std::vector<double> x(H_.size());
    double sum = 0.0;
    for (std::size_t r = i; r < H_.size(); ++r) {
      x[r] = r == i ? 1.0 : 0.0;
      for (std::size_t j = i; j < r; ++j) x[r] -= H_[r][j] * x[j];
      x[r] /= H_[r][r];
      sum += x[r] * x[r];
    }
    return sum;
  }

  const Document& document_;
  std::vector<Pose> poses_;                // by body
  std::vector<std::vector<Range>> first_;  // by body and joint: its freedoms
  std::vector<Freedom> freedoms_;
  std::vector<std::vector<double>> H_;  // the lower triangle
};

}  // namespace

void resolve_spring_dampers(Document& document, Diagnostics& diagnostics) {
  std::optional<InertiaMatrix> inertia;
  std::vector<std::pair<Joint*, double>> joints;
  for (std::size_t b = 0; b < document.bodies.size(); ++b)
    for (std::size_t j = 0; j < document.bodies[b].joints.size(); ++j) {
      Joint& joint = document.bodies[b].joints[j];
      if (!joint.spring_damper || !document.robot.has[b] || diagnostics.has_errors()) continue;
      if (joint.type == model::JointType::spherical) {
        diagnostics.error("spring-damper", joint.spring_damper->place, "springs of ball joints are not supported");
        return;
      }
      if (!inertia) inertia.emplace(document);
      const double of_inverse = inertia->mean_of_inverse(b, j);
      if (!std::isfinite(of_inverse) || of_inverse <= 0.0) {
        diagnostics
            .error(
                "spring-damper", joint.spring_damper->place, "'springdamper' needs a mass, but the joint carries none")
            .hint = "write stiffness=\"...\" and damping=\"...\"";
        return;
      }
      joints.emplace_back(&joint, 1.0 / of_inverse);
    }
  for (const auto& [joint, moved] : joints) {
    const double time = joint->spring_damper->time_constant.value(),
                 ratio = joint->spring_damper->damping_ratio.value();
    joint->drive.stiffness = model::Quantity(moved / (time * time * ratio * ratio));
    joint->drive.damping = model::Quantity(2.0 * moved / time);
    joint->places.stiffness = joint->places.damping = joint->spring_damper->place;
  }
  for (Body& body : document.bodies)
    for (Joint& joint : body.joints) joint.drive.damping = joint.drive.damping + joint.added_damping;
}

}  // namespace robcogen::import::from_mjcf
