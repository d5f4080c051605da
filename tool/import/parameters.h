// From expressions of a document to quantities of the model, collecting parameters and named constants on the way.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "import/names.h"
#include "language/common/frames_document.h"
#include "model/quantity.h"

namespace robcogen::import {

// What a name is that no declaration and no spelling makes anything else: robots have parameters, motions and
// transforms have variables.
enum class PlainName { parameter, variable };

// Parameters are of the kind of the place where they stand: a length or an angle, or, in mass properties alone, of
// these. `PI` in any case is the constant, unless a parameter of exactly this name is declared.
class QuantityReader {
 public:
  QuantityReader(
      std::shared_ptr<const Source> source,
      Diagnostics& diagnostics,
      PlainName plain_name = PlainName::parameter)
      : source_(std::move(source)), diagnostics_(diagnostics), plain_name_(plain_name) {}

  // Declares the parameters of a group, which may be used as `group.name` and as `name`. Reports what was declared
  // before.
  void declare_group(const language::ParameterGroup& group);

  // Notes the constants (`<g=9.81>`) and the parameters (`p:length`, `Pi[3.1]`) that an expression declares, which may
  // be used anywhere in the document. Reports a constant that is given two values.
  void declare_names_in(const language::Expression& expression);

  // `kind` is what a parameter would be in this place. Reports a parameter of two kinds or with two defaults, an
  // unknown constant, and what has no finite value, or none that a robot can have: for constants as such, with
  // parameters whatever values they take. A constant next to nothing is zero.
  model::Quantity read(const language::Expression& expression, model::ParameterKind kind);

  // Warns of names that may be parameters by accident; to be called when all has been read.
  void report_accidents() const { uses_.report(diagnostics_); }

  // Those of groups first, as declared; then in the order of their first use.
  const std::vector<model::Parameter>& parameters() const { return parameters_; }
  // In the order of their first use.
  const std::vector<std::string>& variables() const { return variables_; }

 private:
  model::Quantity finite(const language::Expression& expression, model::ParameterKind kind);
  model::Quantity operate(const language::Expression& expression, model::ParameterKind kind);
  void join_kind(int index, model::ParameterKind kind, const Place& place);
  void set_default(model::Parameter& parameter, double value, const Place& place);
  void check_angle(const language::Expression& expression, const Number& angle);
  void declare_constant(const language::Expression& expression);
  model::Quantity name(const language::Expression& expression, model::ParameterKind kind);
  model::Quantity member(const language::Expression& expression, model::ParameterKind kind);
  model::Quantity variable(const language::Expression& expression);
  model::Quantity parameter(const language::Expression& expression, model::ParameterKind kind);
  void add_parameter(const std::string& name, model::ParameterKind kind, const Place& place);
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
  std::vector<std::string> variables_;
  std::vector<std::vector<double>> trials_;           // sets of values of all parameters
  std::vector<std::vector<double>> variable_trials_;  // and of all variables
  int faults_ = 0;
  NameUses uses_;
  std::map<std::string, int> parameter_indices_;
  std::map<std::string, Constant> constants_;
  std::set<int> two_units_;  // parameters that were reported as both lengths and angles
  PlainName plain_name_;
  struct Group {
    Place place;
    std::vector<std::string> parameters;
  };
  std::map<std::string, Group> groups_;
  std::set<std::string> grouped_;                        // parameters of groups
  std::set<std::string> with_default_;                   // parameters that a use gives a default
  std::set<std::string> unused_;                         // those of them that were not used yet
  std::map<std::string, Place> parameters_by_spelling_;  // `p:name`
  std::map<std::string, int> variable_indices_;
  std::set<std::string> ambiguous_;  // names that were reported as both variables and parameters
};

}  // namespace robcogen::import
