// Generates code for one robot with Pinocchio and CppADCodeGen. It has the arguments and results of this project's
// functions, so that neither side converts:
//     generate_cppadcodegen ROBOT.urdf ROBOT.inc [--floating] [JOINT…]
// The joints are in the order of joint vectors; without any, they are those of the URDF, which `robcogen convert`
// writes in this order. With `--floating`, or a floating joint in the URDF, the base floats.
#include <cmath>
#include <cppad/cg.hpp>
#include <fstream>
#include <iostream>
#include <iterator>
#include <pinocchio/codegen/cppadcg.hpp>
// These headers must follow the one above.
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/parsers/urdf.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Code = CppAD::cg::CG<double>;
using Scalar = CppAD::AD<Code>;
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

struct Robot {
  pinocchio::ModelTpl<Scalar> model;
  std::vector<int> order;      // index in velocities of each of our coordinates, the base's angular ones first
  std::vector<int> places;     // index in positions of each joint
  std::vector<bool> is_angle;  // its position is a cosine and a sine
  bool floating;
  int joints;

  Vector velocities(const Vector& ours) const {
    Vector theirs(model.nv);
    for (int k = 0; k < model.nv; ++k) theirs[order[static_cast<std::size_t>(k)]] = ours[k];
    return theirs;
  }
  // The base frame coincides with the world frame.
  Vector positions(const Vector& ours) const {
    Vector theirs = Vector::Zero(model.nq);
    if (floating) theirs[6] = 1;  // of the quaternion
    for (int k = 0; k < joints; ++k) {
      const int place = places[static_cast<std::size_t>(k)];
      if (is_angle[static_cast<std::size_t>(k)]) {
        theirs[place] = cos(ours[k]);
        theirs[place + 1] = sin(ours[k]);
      } else {
        theirs[place] = ours[k];
      }
    }
    return theirs;
  }
  Vector stacked(const Vector& base, const Vector& joint_values) const {
    Vector all(model.nv);
    all << base, joint_values;
    return velocities(all);
  }
  Vector ours(const Vector& theirs) const {
    Vector result(model.nv);
    for (int k = 0; k < model.nv; ++k) result[k] = theirs[order[static_cast<std::size_t>(k)]];
    return result;
  }
};

// The names of the joints that move one coordinate, in the order of the text.
std::vector<std::string> joints_of(const std::string& urdf) {
  static const std::regex joint(R"re(<joint name="([^"]+)" type="(revolute|continuous|prismatic)")re");
  std::vector<std::string> names;
  for (std::sregex_iterator at(urdf.begin(), urdf.end(), joint), end; at != end; ++at) names.push_back((*at)[1]);
  return names;
}

Robot load(const std::string& path, std::vector<std::string> joints, bool floating) {
  std::ifstream file(path);
  const std::string urdf((std::istreambuf_iterator<char>(file)), {});
  const bool has_floating_joint = urdf.find("\"floating\"") != std::string::npos;
  if (joints.empty()) joints = joints_of(urdf);
  pinocchio::Model model;
  if (floating && !has_floating_joint)
    pinocchio::urdf::buildModelFromXML(urdf, pinocchio::JointModelFreeFlyer(), model);
  else
    pinocchio::urdf::buildModelFromXML(urdf, model);
  floating = floating || has_floating_joint;
  // Rounding errors of the zeros of right angles would become arithmetic.
  for (pinocchio::SE3& placement : model.jointPlacements)
    placement.rotation() = placement.rotation().unaryExpr(
        [](double e) { return std::abs(e - std::round(e)) < 1e-12 ? std::round(e) : e; });
  Robot robot{model.cast<Scalar>(), {}, {}, {}, floating, static_cast<int>(joints.size())};
  // A floating joint comes first; its velocity is a twist, linear first.
  if (floating) robot.order = {3, 4, 5, 0, 1, 2};
  for (const std::string& joint : joints) {
    if (!model.existJointName(joint)) throw std::runtime_error("no joint '" + joint + "' in the URDF");
    const pinocchio::JointModel& of_model = model.joints[model.getJointId(joint)];
    robot.order.push_back(of_model.idx_v());
    robot.places.push_back(of_model.idx_q());
    robot.is_angle.push_back(of_model.nq() == 2);
  }
  if (static_cast<int>(robot.order.size()) != model.nv)
    throw std::runtime_error(
        "the URDF has other joints too, or a joint that follows another, which Pinocchio has no forward dynamics for: "
        "leave them out with robcogen convert --keep");
  return robot;
}

// Takes arguments from a vector, one after the other.
class Arguments {
 public:
  explicit Arguments(const Vector& all) : all_(all) {}
  Vector next(int size) {
    begin_ += size;
    return all_.segment(begin_ - size, size);
  }

 private:
  const Vector& all_;
  int begin_ = 0;
};

template <class Function>
void generate(std::ostream& out, const std::string& name, int inputs, const Function& function) {
  // Any position without special values, because branches of the algorithm are recorded as they are taken here.
  Vector x(inputs);
  for (int i = 0; i < inputs; ++i) x[i] = Scalar(Code(0.1 + 0.01 * i));
  CppAD::Independent(x);
  const Vector y = function(Arguments(x));
  CppAD::ADFun<Code> tape(x, y);
  // Pivots are chosen at this position, so comparisons are removed.
  tape.optimize("no_compare_op");
  CppAD::cg::CodeHandler<double> handler;
  CppAD::vector<Code> variables(static_cast<std::size_t>(inputs));
  handler.makeVariables(variables);
  CppAD::vector<Code> results = tape.Forward(0, variables);
  CppAD::cg::LanguageC<double> language("double");
  language.setGenerateFunction("call");
  CppAD::cg::LangCDefaultVariableNameGenerator<double> names;
  // A namespace for each function, because each repeats declarations.
  out << "namespace " << name << " {\n";
  handler.generateCode(out, language, results, names);
  out << "}\n";
}

void generate_all(std::ostream& out, Robot& robot) {
  pinocchio::DataTpl<Scalar> data(robot.model);
  const int n = robot.joints, base = robot.floating ? 6 : 0, gravity = robot.floating ? 3 : 0;
  const auto set_gravity = [&](Arguments& in) {
    if (robot.floating) robot.model.gravity.linear() = in.next(3);
  };
  generate(out, "rival_inverse_dynamics", 3 * n + 2 * base + gravity, [&](Arguments in) {
    const Vector q = in.next(n), qd = in.next(n), qdd = in.next(n), v = in.next(base), a = in.next(base);
    set_gravity(in);
    return robot.ours(
        pinocchio::rnea(robot.model, data, robot.positions(q), robot.stacked(v, qd), robot.stacked(a, qdd)));
  });
  generate(out, "rival_forward_dynamics", 3 * n + base + gravity, [&](Arguments in) {
    const Vector q = in.next(n), qd = in.next(n), tau = in.next(n), v = in.next(base);
    set_gravity(in);
    return robot.ours(pinocchio::aba(
        robot.model, data, robot.positions(q), robot.stacked(v, qd), robot.stacked(Vector::Zero(base), tau),
        pinocchio::Convention::LOCAL));
  });
  generate(out, "rival_inertia_matrix", n, [&](Arguments in) {
    pinocchio::crba(robot.model, data, robot.positions(in.next(n)), pinocchio::Convention::LOCAL);
    const Matrix H = data.M.selfadjointView<Eigen::Upper>();
    Vector columns(base * base + n * (2 * base + n));
    Eigen::Index k = 0;
    for (const int column : robot.order)
      for (const int row : robot.order) columns[k++] = H(row, column);
    return columns;
  });
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> joints(argv + std::min(argc, 3), argv + argc);
  const bool floating = !joints.empty() && joints.front() == "--floating";
  if (floating) joints.erase(joints.begin());
  if (argc < 3) {
    std::cerr << "usage: generate_cppadcodegen ROBOT.urdf ROBOT.inc [--floating] [JOINT…]\n";
    return 2;
  }
  try {
    Robot robot = load(argv[1], joints, floating);
    std::ofstream out(argv[2]);
    out << "#include <math.h>\n#include <stdio.h>\n\nconst int rival_joints = " << robot.joints
        << ", rival_floating_base = " << (robot.floating ? 1 : 0) << ";\n\n";
    generate_all(out, robot);
    out.close();
    return out ? 0 : 2;
  } catch (const std::exception& e) {
    std::cerr << argv[1] << ": " << e.what() << "\n";
    return 1;
  }
}
