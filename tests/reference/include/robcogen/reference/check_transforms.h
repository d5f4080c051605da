// Checks of coordinate transforms without a robot: each against its product of primitives, multiplied out as matrices
// in long double, and against identities between transforms.
#pragma once

#include "robcogen/reference/check_partial_derivatives.h"
#include "robcogen/reference/checks.h"
#include "robcogen/reference/composition.h"
#include "robcogen/reference/samples.h"
#include "robcogen/transform_tables.h"

namespace robcogen::reference {

// The values of a model's parameters and variables in one sample.
struct ModelValues {
  std::vector<double> parameters;
  std::vector<double> variables;
};

// Variables are within about a turn; parameters are positive, like lengths.
inline ModelValues random_values(std::mt19937_64& engine, const reflection::Transforms& model) {
  constexpr double kAngle = 3.2, kHalf = 0.75;
  ModelValues values;
  for (int i = 0; i < model.parameter_count; ++i) values.parameters.push_back(1 + uniform(engine, kHalf));
  for (int i = 0; i < model.variable_count; ++i) values.variables.push_back(uniform(engine, kAngle));
  return values;
}

// The amounts of a transform's factors.
inline std::vector<reflection::Amount> amounts(
    const reflection::ProductOfFactors& transform,
    const ModelValues& values) {
  const auto all = [](const std::vector<double>& numbers) {
    std::vector<reflection::Amount> result;
    for (const double number : numbers) result.emplace_back(number);
    return result;
  };
  std::vector<reflection::Amount> result(static_cast<std::size_t>(transform.factors.size));
  transform.amounts(all(values.parameters).data(), all(values.variables).data(), result.data());
  return result;
}

// The 4 x 4 matrix of one primitive.
inline Matrix<Real> primitive(const reflection::Factor& factor, Real value) {
  Matrix<Real> m = Matrix<Real>::identity(4);
  if (!factor.rotation) {
    m(factor.axis, 3) = value;
    return m;
  }
  const int i = (factor.axis + 1) % 3, j = (factor.axis + 2) % 3;
  m(i, i) = m(j, j) = std::cos(value);
  m(j, i) = std::sin(value);
  m(i, j) = -std::sin(value);
  return m;
}

// A transform multiplied out. `size` is the scale of rounding errors: the largest of the amounts and of the lengths in
// partial products.
struct MultipliedOut {
  Matrix<Real> pose = Matrix<Real>::identity(4);
  Real size = 1;
};

inline MultipliedOut multiplied_out(const reflection::ProductOfFactors& transform, const ModelValues& values) {
  MultipliedOut expected;
  const std::vector<reflection::Amount> all = amounts(transform, values);
  for (int i = 0; i < transform.factors.size; ++i) {
    const reflection::Amount& a = all[static_cast<std::size_t>(i)];
    expected.pose = expected.pose * primitive(transform.factors[i], a.value);
    expected.size = worst_of({expected.size, a.size, largest(expected.pose)});
  }
  return expected;
}

// Reads elements by their indices, as a user does, so that a wrong storage order is found.
template <class EigenMatrix>
Matrix<double> copy_of(const EigenMatrix& m) {
  Matrix<double> result(static_cast<int>(m.rows()), static_cast<int>(m.cols()));
  for (int i = 0; i < result.rows(); ++i)
    for (int j = 0; j < result.cols(); ++j) result(i, j) = m(i, j);
  return result;
}

// Records the errors of all transforms for these values. A transform with an amount that is NaN, such as a root of a
// negative length, is skipped: `checked` marks the transforms that were compared.
inline void check_transforms(
    const reflection::Transforms& model,
    const ModelValues& values,
    int sample,
    std::vector<bool>& checked,
    Checks& checks) {
  std::vector<TransformForms> all;
  std::vector<FramePair> pairs;
  for (int i = 0; i < model.transforms.size; ++i) {
    const reflection::ProductOfFactors& t = model.transforms[i];
    const MultipliedOut expected = multiplied_out(t, values);
    if (!std::isfinite(expected.size)) continue;
    checked[static_cast<std::size_t>(i)] = true;
    const double *p = values.parameters.data(), *v = values.variables.data();
    pairs.push_back({t.left, t.right});
    const TransformForms& X =
        all.emplace_back(TransformForms{copy_of(t.homogeneous(p, v)), copy_of(t.motion(p, v)), copy_of(t.force(p, v))});
    const auto record = [&](const char* name, Real error) {
      checks.record(name, kTransform, error / (expected.size * expected.size), sample);
    };
    record("transforms::homogeneous", transform_error(X.homogeneous, expected.pose));
    record("transforms::motion", transform_error(X.motion, motion_form(expected.pose)));
    record("transforms::force", transform_error(X.force, force_form(expected.pose)));
    check_duality(X, sample, checks);
  }
  check_composition(pairs, all, sample, checks);
}

inline Checks check_transforms(const reflection::Transforms& model, std::uint64_t seed, int samples) {
  Checks checks;
  std::mt19937_64 engine(seed);
  std::vector<bool> checked(static_cast<std::size_t>(model.transforms.size), false);
  for (int i = 0; i < samples; ++i) check_transforms(model, random_values(engine, model), i, checked, checks);
  const bool all = std::find(checked.begin(), checked.end(), false) == checked.end();
  checks.record("every transform has values to compare", kTransform, all ? 0 : 1, samples - 1);
  const auto inputs_of = [&](const reflection::Function& f) {
    std::vector<double> inputs(static_cast<std::size_t>(f.inputs));
    for (double& x : inputs) x = 1 + uniform(engine, 0.75);
    return inputs;
  };
  check_partial_derivatives(model.functions, model.derivatives, inputs_of, move_number, {}, {}, samples, checks);
  return checks;
}

}  // namespace robcogen::reference
