// The checks of regressors: they pass for correct matrices, made column by column, and find wrong ones.
#include <gtest/gtest.h>

#include "robcogen/reference/check_identification.h"
#include "sample_robots.h"

namespace robcogen::reference::check_identification_test {
namespace {

// A robot whose only mass property is one of the inertial parameters, without drives.
class UnitRobot {
 public:
  UnitRobot(const Robot& robot, int link, int parameter)
      : links_(robot.links.begin(), robot.links.end()),
        joints_(robot.joints.begin(), robot.joints.end()),
        robot_(robot) {
    for (reflection::Link& l : links_) l.mass = 0, set(l.com, -1), set(l.inertia, -1);
    for (reflection::Joint& joint : joints_) joint.drive = {};
    reflection::Link& own = links_[static_cast<std::size_t>(link)];
    if (parameter < 4) own.mass = 1, set(own.com, parameter - 1);
    if (parameter >= 4) set(own.inertia, parameter - 4);
    robot_.links.data = links_.data();
    robot_.joints.data = joints_.data();
  }
  UnitRobot(const UnitRobot&) = delete;
  UnitRobot& operator=(const UnitRobot&) = delete;
  const Robot& robot() const { return robot_; }

 private:
  template <int n>
  static void set(double (&numbers)[n], int one) {
    for (int k = 0; k < n; ++k) numbers[k] = k == one ? 1 : 0;
  }

  std::vector<reflection::Link> links_;
  std::vector<reflection::Joint> joints_;
  Robot robot_;
};

// Correct regressors. A first moment needs a mass, whose own effect is subtracted.
class RightRegressors {
 public:
  explicit RightRegressors(const Robot& robot) : robot_(robot) {}
  virtual ~RightRegressors() = default;

  virtual Matrix<double> regressor(const Motion<double>& m, const Arguments& arguments) const {
    return columns([&](const Robot& unit) {
      return cut(robot_.floating_base, generalized_forces(unit, cast<Real>(m), loads_of(arguments)));
    });
  }
  virtual Matrix<double> drive_regressor(const Motion<double>& m) const {
    const int n = robot_.dof(), first = robot_.floating_base ? 6 : 0;
    Matrix<double> Y(first + n, 5 * n);
    for (int j = 0; j < n; ++j) {
      const double sign = m.qd(j) < 0 ? -1 : 1, values[] = {m.qdd(j), m.qd(j), sign, m.q(j), 1};
      for (int k = 0; k < 5; ++k) Y(first + j, 5 * j + k) = values[k];
    }
    return Y;
  }
  virtual Vector<double> inertial_parameters() const { return inertial_parameters_of(robot_).cast<double>(); }
  virtual Vector<double> drive_parameters() const { return drive_parameters_of(robot_, true).cast<double>(); }
  // All parameters serve as base parameters.
  virtual Matrix<double> base_regressor(const Motion<double>& m, const Arguments& arguments) const {
    return RightRegressors::regressor(m, arguments);
  }
  virtual Vector<double> base_parameters(const Vector<double>& all, const Arguments&) const { return all; }
  virtual Matrix<double> energy_regressor(const Motion<double>& m, const Arguments& arguments) const {
    return columns([&](const Robot& unit) {
      const Motion<Real> motion = cast<Real>(m);
      return Vector<Real>{kinetic_energy(unit, motion), potential_energy(unit, motion.q, loads_of(arguments).gravity)};
    });
  }
  virtual Matrix<double> slotine_li_regressor(
      const Motion<double>& m,
      const Motion<double>& r,
      const Arguments& arguments) const {
    return columns([&](const Robot& unit) { return reference_forces(unit, m, r, loads_of(arguments)); });
  }

 protected:
  static Loads<Real> loads_of(const Arguments& arguments) {
    return loads<Real>(arguments.gravity != nullptr ? *arguments.gravity : Vector<double>{0, 0, -9.81});
  }

  template <class Value>
  Matrix<double> columns(const Value& value) const {
    std::vector<Vector<Real>> all;
    for (int link = first_moving_link(robot_); link < robot_.links.size; ++link) {
      const Vector<Real> mass = value(UnitRobot(robot_, link, 0).robot());
      for (int p = 0; p < 10; ++p) {
        const Vector<Real> column = value(UnitRobot(robot_, link, p).robot());
        all.push_back(p >= 1 && p <= 3 ? column - mass : column);
      }
    }
    Matrix<double> Y(all.front().rows(), static_cast<int>(all.size()));
    for (int k = 0; k < Y.cols(); ++k) Y.set_block(0, k, all[static_cast<std::size_t>(k)].template cast<double>());
    return Y;
  }

  // H a + C r + gravity forces. Of all valid matrices C, half of dH/dt plus the skew matrix that adds the rest of the
  // forces.
  Vector<Real> reference_forces(
      const Robot& unit,
      const Motion<double>& m,
      const Motion<double>& r,
      const Loads<Real>& acting) const {
    constexpr Real kStep = 1e-5L;
    const Motion<Real> now = cast<Real>(m), reference = cast<Real>(r);
    const auto inertia = [&](Real step) -> Matrix<Real> {
      const Vector<Real> q = now.q + step * now.qd;
      return joint_space_inertia(unit, q);
    };
    const Matrix<Real> half =
        Real(1) / (24 * kStep) *
        (Real(8) * (inertia(kStep) - inertia(-kStep)) - (inertia(2 * kStep) - inertia(-2 * kStep)));
    const bool floating = robot_.floating_base;
    const Vector<Real> v = coordinates(floating, now.base_velocity, now.qd),
                       v_r = coordinates(floating, reference.base_velocity, reference.qd);
    const Forces<Real> forces = coriolis_forces(unit, now);
    const Vector<Real> rest = coordinates(floating, forces.base_wrench, forces.tau) - half * v;
    const Matrix<Real> skew = 1 / dot(v, v) * (rest * transpose(v) - v * transpose(rest));
    Motion<Real> still = now;
    still.qd = Vector<Real>(now.qd.rows());
    still.base_velocity = Vector<Real>(6);
    still.qdd = reference.qdd;
    still.base_acceleration = reference.base_acceleration;
    return cut(floating, generalized_forces(unit, still, acting)) + (half + skew) * v_r;
  }

  Robot robot_;
};

std::string failures(const RightRegressors& subject, const Robot& robot) {
  Checks checks;
  std::mt19937_64 engine(7);
  const Sample s = random_sample(engine, robot);
  const Case c(robot, s, 0);
  check_parameters_of_regressors(subject, c, checks);
  check_regressor(subject, c, checks);
  check_base_regressor(subject, c, checks);
  check_energy_regressor(subject, c, checks);
  check_slotine_li_regressor(subject, c, checks);
  return checks.failure_report();
}

template <class Subject>
std::string failures(bool floating) {
  const Tables tables = crooked_tree(floating);
  const Robot robot = tables.robot();
  return failures(Subject(robot), robot);
}

template <class Wrong>
void expect_found(const std::vector<std::string>& names) {
  for (const bool floating : {false, true}) {
    expect_failures(failures<Wrong>(floating), names);
  }
}

TEST(IdentificationChecks, PassWhatIsRight) {
  EXPECT_EQ(failures<RightRegressors>(false), "");
  EXPECT_EQ(failures<RightRegressors>(true), "");
}

TEST(IdentificationChecks, FindProductsOfInertiaOfTheWrongSign) {
  struct Wrong : RightRegressors {
    using RightRegressors::RightRegressors;
    Matrix<double> regressor(const Motion<double>& m, const Arguments& arguments) const override {
      Matrix<double> Y = RightRegressors::regressor(m, arguments);
      for (int k = 7; k < Y.cols(); k += 10) Y.set_block(0, k, -1.0 * Y.col(k));
      return Y;
    }
    Matrix<double> base_regressor(const Motion<double>& m, const Arguments& arguments) const override {
      return regressor(m, arguments);
    }
  };
  expect_found<Wrong>({"regressor ", "regressor (gravity)", "base_regressor ", "base_regressor (gravity)"});
}

TEST(IdentificationChecks, FindParametersInAnotherOrder) {
  struct Wrong : RightRegressors {
    using RightRegressors::RightRegressors;
    Vector<double> inertial_parameters() const override {
      Vector<double> pi = RightRegressors::inertial_parameters();
      std::swap(pi(5), pi(6));
      return pi;
    }
  };
  expect_found<Wrong>({"inertial_parameters"});
}

TEST(IdentificationChecks, FindWrongParametersOfDrives) {
  struct Wrong : RightRegressors {
    using RightRegressors::RightRegressors;
    Vector<double> drive_parameters() const override {
      Vector<double> pi = RightRegressors::drive_parameters();
      pi(0) += 1;
      return pi;
    }
  };
  expect_found<Wrong>({"drive_parameters"});
}

TEST(IdentificationChecks, FindAPotentialOfTheWrongSign) {
  struct Wrong : RightRegressors {
    using RightRegressors::RightRegressors;
    Matrix<double> energy_regressor(const Motion<double>& m, const Arguments& arguments) const override {
      Matrix<double> Y = RightRegressors::energy_regressor(m, arguments);
      for (int k = 0; k < Y.cols(); ++k) Y(1, k) = -Y(1, k);
      return Y;
    }
  };
  expect_found<Wrong>({"energy_regressor ", "energy_regressor (gravity)"});
}

// A Coriolis matrix that is right for the velocity itself, but for which dH/dt - 2 C is not skew symmetric.
TEST(IdentificationChecks, FindACoriolisMatrixThatIsNotSkew) {
  struct Wrong : RightRegressors {
    using RightRegressors::RightRegressors;
    Matrix<double> slotine_li_regressor(const Motion<double>& m, const Motion<double>& r, const Arguments& arguments)
        const override {
      Motion<double> scaled = r;
      const Vector<double> v = coordinates(robot_.floating_base, m.base_velocity, m.qd),
                           v_r = coordinates(robot_.floating_base, r.base_velocity, r.qd);
      const double along = dot(v, v_r) / dot(v, v);
      scaled.qd = along * m.qd;
      scaled.base_velocity = along * m.base_velocity;
      return RightRegressors::slotine_li_regressor(m, scaled, arguments);
    }
  };
  expect_found<Wrong>({"slotine_li_regressor: dH/dt - 2 C is skew symmetric"});
}

}  // namespace
}  // namespace robcogen::reference::check_identification_test
