// Converts expressions of a document to quantities of the model, and collects parameters and named constants.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "import/names.h"
#include "language/common/frames_document.h"
#include "model/quantity.h"

namespace robcogen::import {

// The meaning of a name without a declaration: a parameter in robots, a variable in motions and transforms.
enum class PlainName { parameter, variable };

// Reads expressions. The kind of a parameter follows from where it is used: a length or an angle in placements,
// otherwise inertial. `PI` in upper or lower case is the constant, unless a parameter of exactly this name is declared.
class QuantityReader {
 public:
  QuantityReader(
      std::shared_ptr<const Source> source,
      Diagnostics& diagnostics,
      PlainName plain_name = PlainName::parameter)
      : source_(std::move(source)), diagnostics_(diagnostics), plain_name_(plain_name) {}

  // Declares the parameters of a group, which may be used as `group.name` and as `name`. Reports names that were
  // declared before.
  void declare_group(const language::ParameterGroup& group);

  // Stores the constants (`<g=9.81>`) and the parameters (`p:length`, `Pi[3.1]`) that an expression declares; they may
  // be used anywhere in the document. Reports a constant with two values.
  void declare_names_in(const language::Expression& expression);

  // Converts an expression. `kind` is the kind of parameters in this place. Reports a parameter of two kinds or with
  // two default values, an unknown constant, and an expression whose value is not finite or too large for a robot (with
  // parameters: for all their values). A constant close to zero becomes zero.
  model::Quantity read(const language::Expression& expression, model::ParameterKind kind);

  // Whether the expressions declare a parameter of this name, or those read so far use one.
  bool knows_parameter(const std::string& name) const {
    return parameter_indices_.contains(name) || with_default_.contains(name) || parameters_by_spelling_.contains(name);
  }

  // Warns about names that may be parameters by accident. Must be called after all expressions were read.
  void report_accidents() const { uses_.report(diagnostics_); }

  Place place(const Span& span) const { return {source_, span}; }
  Place place(const language::Expression& expression) const { return place(expression.span); }

  // First the parameters of groups, as declared; then the others in the order of their first use.
  const std::vector<model::Parameter>& parameters() const { return parameters_; }
  // In the order of their first use.
  const std::vector<std::string>& variables() const { return variables_; }

  // Warns about an angle (rad) of more than this many turns, unless it is a multiple of PI. Parameters have the default
  // values that the expression gives them.
  void check_angle(const language::Expression& expression, const model::Quantity& angle, double turns = 1.0);

 private:
  model::Quantity finite(const language::Expression& expression, model::ParameterKind kind);
  model::Quantity operate(const language::Expression& expression, model::ParameterKind kind);
  void join_kind(int index, model::ParameterKind kind, const Place& place);
  void set_default(model::Parameter& parameter, double value, const Place& place);
  void declare_constant(const language::Expression& expression);
  model::Quantity name(const language::Expression& expression, model::ParameterKind kind);
  model::Quantity member(const language::Expression& expression, model::ParameterKind kind);
  model::Quantity variable(const language::Expression& expression);
  model::Quantity parameter(const language::Expression& expression, model::ParameterKind kind);
  void add_parameter(const std::string& name, model::ParameterKind kind, const Place& place);
  model::Quantity constant(const language::Expression& expression);
  // The smallest magnitude over the trial values of the parameters; infinite if no value is finite.
  double least_magnitude(const model::Quantity& q) const;
  // The value of an expression after an error in it was reported.
  model::Quantity fault(const Diagnostic& reported);

  struct Constant {
    model::Quantity value;
    Place place;
  };

  std::shared_ptr<const Source> source_;
  Diagnostics& diagnostics_;
  std::vector<model::Parameter> parameters_;
  std::vector<std::string> variables_;
  std::vector<std::vector<double>> trials_;           // sets of values of all parameters
  std::vector<std::vector<double>> variable_trials_;  // sets of values of all variables
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
  std::set<std::string> with_default_;                   // parameters that have a default value at some use
  std::set<std::string> unused_;                         // grouped parameters that have not been used yet
  std::map<std::string, Place> parameters_by_spelling_;  // `p:name`, or `name[…]` where plain names are variables
  std::map<std::string, int> variable_indices_;
  std::set<std::string> ambiguous_;  // names that were reported as both variables and parameters
};

}  // namespace robcogen::import
