// Loads the functions of a CasADi library as CasADi does, by name alone, and compares their results with those of the
// C++ library: sparsity patterns, null pointers, parameters.
//
// casadi LIBRARY LIBRARY_WITH_PARAMETERS
#include <both/leg/leg.h>
#include <dlfcn.h>
#include <legs/leg/leg.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using Int = long long int;

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "casadi: %s\n", what.c_str());
  std::exit(1);
}

struct Shape {
  Int rows = 0, columns = 0;
  std::vector<Int> nonzeros;  // indices into the dense matrix, column by column
};

// A function of the shared library, called only through CasADi's protocol.
class External {
 public:
  External(void* library, const std::string& name) : library_(library), name_(name) {
    for (Int i = 0; i < call<Int()>("_n_in"); ++i) in_.push_back(shape("_sparsity_in", i));
    for (Int i = 0; i < call<Int()>("_n_out"); ++i) out_.push_back(shape("_sparsity_out", i));
    require(call<const Int*(Int)>("_sparsity_in", Int(in_.size())) == nullptr, name + ": a pattern behind the last");
    require(call<const char*(Int)>("_name_out", Int(-1)) == nullptr, name + ": a name before the first");
  }
  std::string name_in(Int i) const { return call<const char*(Int)>("_name_in", i); }
  std::string name_out(Int i) const { return call<const char*(Int)>("_name_out", i); }
  const std::vector<Shape>& in() const { return in_; }
  const std::vector<Shape>& out() const { return out_; }

  // Returns the results as dense matrices.
  std::vector<Eigen::MatrixXd> operator()(const std::vector<const double*>& arguments, bool wants_results = true)
      const {
    Int sizes[4] = {};
    require(call<int(Int*, Int*, Int*, Int*)>("_work", sizes, sizes + 1, sizes + 2, sizes + 3) == 0, name_ + "_work");
    require(sizes[0] >= Int(in_.size()) && sizes[1] >= Int(out_.size()), name_ + ": too few pointers");
    std::vector<double> w(std::size_t(sizes[3]), NAN);
    std::vector<std::vector<double>> memory;
    std::vector<double*> results;
    for (const Shape& s : out_) memory.emplace_back(s.nonzeros.size() + 1, NAN);
    for (std::vector<double>& m : memory) results.push_back(wants_results ? m.data() : nullptr);
    std::vector<const double*> given = arguments;
    given.resize(std::size_t(sizes[0]));
    results.resize(std::size_t(sizes[1]));
    require(
        call<int(const double**, double**, Int*, double*, int)>(
            "", given.data(), results.data(), nullptr, w.data(), 0) == 0,
        name_ + " failed");
    std::vector<Eigen::MatrixXd> all;
    for (std::size_t r = 0; r < out_.size(); ++r) {
      require(std::isnan(memory[r].back()), name_ + " wrote behind the result");
      all.push_back(Eigen::MatrixXd::Zero(out_[r].rows, out_[r].columns));
      for (std::size_t k = 0; k < out_[r].nonzeros.size(); ++k) all.back().data()[out_[r].nonzeros[k]] = memory[r][k];
    }
    return all;
  }

 private:
  void* library_;
  std::string name_;
  std::vector<Shape> in_, out_;

  template <class F, class... A>
  std::invoke_result_t<F*, A...> call(const std::string& end, A... a) const {
    void* const symbol = dlsym(library_, (name_ + end).c_str());
    require(symbol != nullptr, name_ + end + " is missing");
    return reinterpret_cast<F*>(symbol)(a...);
  }
  Shape shape(const std::string& end, Int i) const {
    const Int* s = call<const Int*(Int)>(end, i);
    require(s != nullptr && s[0] >= 0 && s[1] >= 0, name_ + end);
    Shape shape{s[0], s[1], {}};
    if (s[2] == 1) {
      for (Int k = 0; k < s[0] * s[1]; ++k) shape.nonzeros.push_back(k);
      return shape;
    }
    const Int *begin = s + 2, *row = begin + s[1] + 1;
    require(begin[0] == 0, name_ + end + ": the first column does not begin at 0");
    for (Int c = 0; c < s[1]; ++c)
      for (Int k = begin[c]; k < begin[c + 1]; ++k) {
        require(row[k] >= 0 && row[k] < s[0] && (k == begin[c] || row[k] > row[k - 1]), name_ + end + ": rows");
        shape.nonzeros.push_back(c * s[0] + row[k]);
      }
    return shape;
  }
};

void require_equal(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, const std::string& what) {
  require(a.rows() == b.rows() && a.cols() == b.cols(), what + ": its shape");
  // Both are compiled from the same formulas, with and without fused products.
  require((a - b).cwiseAbs().maxCoeff() < 1e-12 * (1 + b.cwiseAbs().maxCoeff()), what + ": its values");
}

}  // namespace

int main(int argc, char** argv) {
  require(argc == 3, "two arguments");
  void* const library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
  require(library != nullptr, argv[1]);
  const Eigen::Vector3d q(0.3, -0.8, 1.1), qd(1, 2, -3), qdd(-4, 2, 5), none = Eigen::Vector3d::Zero();

  const External id(library, "both_leg_casadi_inverse_dynamics");
  require(id.in().size() == 3 && id.out().size() == 1, "inverse dynamics: its arguments");
  require(id.name_in(0) == "q" && id.name_in(2) == "qdd" && id.name_out(0) == "tau", "inverse dynamics: names");
  require(id.in()[1].rows == 3 && id.in()[1].columns == 1, "inverse dynamics: the shape of qd");
  require_equal(id({q.data(), qd.data(), qdd.data()})[0], both::leg::inverse_dynamics(q, qd, qdd), "tau");
  require_equal(
      id({q.data(), nullptr, nullptr})[0], both::leg::inverse_dynamics(q, none, none), "tau of null pointers");
  id({q.data(), qd.data(), qdd.data()}, false);

  const External inertia(library, "both_leg_casadi_joint_space_inertia");
  require_equal(inertia({q.data()})[0], both::leg::joint_space_inertia(q), "H");
  const External jacobian(library, "both_leg_casadi_fr_base_J_fr_foot");
  require_equal(jacobian({q.data()})[0], both::leg::jacobians::fr_base_J_fr_foot(q), "J");
  // Not all 6 x 3 elements: the slider neither turns nor leaves the vertical; the hip and the knee turn about one axis.
  require(jacobian.out()[0].nonzeros.size() < 12, "the pattern of J has elements that are zero");

  void* const legs = dlopen(argv[2], RTLD_NOW | RTLD_LOCAL);
  require(legs != nullptr, argv[2]);
  const External parametric(legs, "legs_leg_casadi_inverse_dynamics");
  legs::leg::ParameterArray values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.3 + 0.2 * double(i);
  const legs::leg::Parameters<double> parameters(values);
  require(parametric.in()[0].rows == Int(values.size()), "the number of parameters");
  require_equal(
      parametric({values.data(), q.data(), qd.data(), qdd.data()})[0],
      legs::leg::inverse_dynamics(parameters, q, qd, qdd), "tau with parameters");
  return 0;
}
