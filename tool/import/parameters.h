// From expressions of a document to quantities of the model, collecting parameters and named constants on the way.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "language/common/expression.h"
#include "model/quantity.h"

namespace robcogen::import {

// Identifiers of a robot document become parameters by where they stand; `PI` in any case is the constant.
class QuantityReader {
 public:
  QuantityReader(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : source_(std::move(source)), diagnostics_(diagnostics) {}

  // Notes the constants that an expression declares (`<g=9.81>`), which may be used anywhere in the document. Reports a
  // constant that is given two values.
  void declare_constants(const language::Expression& expression);

  // `kind` is what a parameter would be in this place. Reports a parameter of two kinds or with two defaults, an
  // unknown constant, and what has no finite value, or none that a robot can have: for constants as such, with
  // parameters whatever values they take. A constant next to nothing is zero.
  model::Quantity read(const language::Expression& expression, model::ParameterKind kind);

  // In the order of their first use.
  const std::vector<model::Parameter>& parameters() const { return parameters_; }

 private:
  model::Quantity finite(const language::Expression& expression, model::ParameterKind kind);
  model::Quantity operate(const language::Expression& expression, model::ParameterKind kind);
  model::Quantity parameter(const language::Expression& expression, model::ParameterKind kind);
  model::Quantity constant(const language::Expression& expression);
  // The least magnitude that it takes for the values that parameters are tried with; infinite when it has none.
  double least_magnitude(const model::Quantity& q) const;
  // What an expression is taken to be once its fault was reported.
  model::Quantity fault(const Diagnostic& reported);
  Place place(const language::Expression& expression) const { return {source_, expression.span}; }

  struct Constant {
    model::Quantity value;
    Place place;
  };

  std::shared_ptr<const Source> source_;
  Diagnostics& diagnostics_;
  std::vector<model::Parameter> parameters_;
  std::vector<std::vector<double>> trials_;  // sets of values of all parameters
  int faults_ = 0;
  std::map<std::string, int> kinematics_parameters_;
  std::map<std::string, int> dynamics_parameters_;
  std::map<std::string, Constant> constants_;
  std::set<int> two_units_;  // parameters that were reported as both lengths and angles
};

}  // namespace robcogen::import
