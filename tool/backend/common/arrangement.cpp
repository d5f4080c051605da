#include "backend/common/arrangement.h"

#include <algorithm>
#include <utility>

#include "backend/common/fit_lines.h"
#include "backend/common/value_names.h"
#include "support/index.h"
#include "symbolic/stages.h"

namespace robcogen::backend {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

// Whether Dialect::binds_parameters applies to inputs of this role.
bool is_bound(symbolic::Role role) {
  using symbolic::Role;
  return role == Role::parameters || role == Role::joint_sine || role == Role::joint_cosine;
}

std::vector<KernelArray> claim_parameters(const Program& program, const Dialect& dialect, NameScope& scope) {
  std::vector<std::vector<std::string>> elements;
  for (const symbolic::InputArray& array : program.inputs) {
    elements.emplace_back();
    if (!dialect.names_variables || array.role != symbolic::Role::variables) continue;
    std::vector<std::string> wanted;
    for (const std::string& label : array.elements)
      wanted.push_back(shortened(label, dialect.name_limit, dialect.is_reserved));
    elements.back() = claim_all(scope, wanted);
  }
  std::vector<KernelArray> result;
  for (std::size_t p = 0; p < program.inputs.size(); ++p)
    result.push_back(
        {scope.claim(program.inputs[p].name), false, true, std::move(elements[p]), 1,
         program.inputs[p].role == symbolic::Role::parameters});
  for (const symbolic::OutputArray& array : program.outputs)
    result.push_back({symbolic::is_read_and_written(array.name) ? array.name : scope.claim(array.name), true});
  return result;
}

class ArrangementBuilder {
 public:
  ArrangementBuilder(const Program& program, const Dialect& dialect)
      : program_(program),
        dialect_(dialect),
        arranged_{line_plan(program, dialect), program, dialect, NameScope(dialect.is_reserved, dialect.used_names)} {
    arranged_.spellings.resize(program.statements.size());
    arranged_.expressions.resize(program.statements.size());
    for (const symbolic::Constant& constant : program.constants)
      arranged_.constants.push_back(dialect.literal(constant.number(), arranged_.texts));
  }

  Arrangement run() {
    declare_parameters();
    if (dialect_.binds_parameters) bind_parameters();
    name_values();
    fit_lines(arranged_);
    return std::move(arranged_);
  }

 private:
  const Program& program_;
  const Dialect& dialect_;
  Arrangement arranged_;
  std::vector<std::string> input_labels_;  // by flat index

  const Statement& statement(std::size_t i) const { return program_.statements[i]; }

  void declare_parameters() {
    arranged_.parameters = claim_parameters(program_, dialect_, arranged_.scope);
    for (std::size_t p = 0; p < program_.inputs.size(); ++p) {
      const std::vector<std::string>& labels = program_.inputs[p].elements;
      const auto first = arranged_.inputs_used.begin() + static_cast<std::ptrdiff_t>(input_labels_.size());
      arranged_.parameters[p].used = std::find(first, first + static_cast<std::ptrdiff_t>(labels.size()), true) !=
                                     first + static_cast<std::ptrdiff_t>(labels.size());
      const std::vector<std::string> names = element_names(program_.inputs[p], arranged_.parameters[p]);
      arranged_.input_names.insert(arranged_.input_names.end(), names.begin(), names.end());
      arranged_.input_sources.resize(arranged_.input_names.size(), arranged_.parameters[p].name);
      input_labels_.insert(input_labels_.end(), labels.begin(), labels.end());
    }
    for (const symbolic::Block& load : arranged_.blocks.loads) arranged_.parameters[at(load.array)].used = true;
    for (std::size_t p = 0; p < program_.outputs.size(); ++p)
      arranged_.parameters[program_.inputs.size() + p].used = !program_.outputs[p].values.empty();
  }

  std::vector<std::string> element_names(const symbolic::InputArray& input, const KernelArray& parameter) const {
    if (!parameter.elements.empty()) return parameter.elements;
    std::vector<std::string> names;
    if (input.role == symbolic::Role::parameters && dialect_.members) {
      for (const std::string& member : dialect_.members(input.elements))
        names.push_back(parameter.name + dialect_.member_access + member);
    } else {
      const std::string array = parameter.name + (parameter.is_structure ? dialect_.member_array : "");
      for (std::size_t k = 0; k < input.elements.size(); ++k) names.push_back(dialect_.element(array, k));
    }
    return names;
  }

  std::string element(const KernelArray& array, std::size_t k) const { return dialect_.element(array.name, k); }
  std::string shortened(const std::string& name) const {
    return backend::shortened(name, dialect_.name_limit, dialect_.is_reserved);
  }

  void bind_parameters() {
    std::size_t index = 0;
    for (const symbolic::InputArray& input : program_.inputs) {
      for (std::size_t k = 0; k < input.elements.size(); ++k, ++index) {
        if (!is_bound(input.role) || !arranged_.inputs_used[index]) continue;
        std::string name = arranged_.scope.claim(shortened(input_labels_[index]));
        Line binding{Line::Kind::binding, {name}, arranged_.input_names[index]};
        binding.names = {arranged_.input_sources[index]};
        arranged_.bindings.push_back(std::move(binding));
        arranged_.input_names[index] = arranged_.input_sources[index] = std::move(name);
      }
    }
  }

  // Lines that are too long take parts out later: which ones does not change a name.
  void name_values() {
    std::vector<bool> is_line;
    for (const Place place : arranged_.places)
      is_line.push_back(
          place == Place::own || place == Place::sums || place == Place::summed || place == Place::loaded);
    const std::vector<std::string> names = value_names(program_, is_line);
    for (auto& [key, angle] : arranged_.angles) {
      const auto& [kind, index, lane] = key;
      std::string subject = kind == Operand::Kind::input       ? input_labels_[at(index)]
                            : kind == Operand::Kind::statement ? names[at(index)]
                                                               : names[at(angle.first)];
      if (lane >= 0) subject += "_" + std::to_string(lane);
      // One line holds both names and that of the argument.
      const std::size_t limit = kind == Operand::Kind::input ? dialect_.name_limit : dialect_.name_limit * 5 / 6;
      const auto claim = [&](const std::string& name) {
        return arranged_.scope.claim(backend::shortened(name, limit, dialect_.is_reserved));
      };
      if (angle.sine) angle.sine_name = claim("s_" + subject);
      if (angle.cosine) angle.cosine_name = claim("c_" + subject);
    }
    std::vector<std::string> wanted;
    wanted.reserve(names.size());
    for (const std::string& name : names) wanted.push_back(shortened(name));
    arranged_.names = claim_all(arranged_.scope, std::move(wanted));
    for (const symbolic::Block& load : arranged_.blocks.loads)
      arranged_.load_names.push_back(arranged_.scope.claim(program_.inputs[at(load.array)].name + "_lanes"));
    for (std::size_t i = 0; i < arranged_.names.size(); ++i) {
      const Statement& s = statement(i);
      arranged_.spellings[i].width = s.width;
      if (arranged_.places[i] == Place::loaded) {
        const auto& [load, column] = arranged_.blocks.loaded.at(i);
        arranged_.spellings[i].text = arranged_.texts.add({dialect_.element(arranged_.load_names[load], column)});
        continue;
      }
      if (arranged_.places[i] != Place::angle) {
        arranged_.spellings[i].text = arranged_.names[i];
        continue;
      }
      arranged_.spellings[i] = angle_function(s);
    }
  }

  Spelling angle_function(const Statement& s) {
    const AngleKey key = supplier(arranged_, s.a);
    const Angle& angle = arranged_.angles.at(key);
    Spelling result;
    result.text = s.op == Op::sine ? angle.sine_name : angle.cosine_name;
    result.width = width_of(program_, {key.kind, key.index, false, key.lane});
    if (key.lane != s.a.lane) result = lane_of(arranged_, result, s.a.lane);
    result.negative = s.op == Op::sine && s.a.negative;
    return result;
  }
};

}  // namespace

std::vector<KernelArray> parameters(const Program& program, const Dialect& dialect) {
  NameScope scope(dialect.is_reserved, dialect.used_names);
  return claim_parameters(program, dialect, scope);
}

Arrangement arrange(const Program& program, const Dialect& dialect) {
  return ArrangementBuilder(program, dialect).run();
}

}  // namespace robcogen::backend
