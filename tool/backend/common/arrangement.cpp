#include "backend/common/arrangement.h"

#include <algorithm>
#include <utility>

#include "support/index.h"
#include "symbolic/line_names.h"

namespace robcogen::backend {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

bool has_expression(Place place) {
  return place == Place::inside || place == Place::own || place == Place::output || place == Place::sums;
}

// By Dialect::binds_parameters.
bool is_bound(symbolic::Role role) {
  using symbolic::Role;
  return role == Role::parameters || role == Role::joint_sine || role == Role::joint_cosine;
}

std::vector<Parameter> claim_parameters(const Program& program, const Dialect& dialect, NameScope& scope) {
  std::vector<std::vector<std::string>> elements;
  for (const symbolic::InputArray& array : program.inputs) {
    elements.emplace_back();
    if (!dialect.names_variables || array.role != symbolic::Role::variables) continue;
    std::vector<std::string> wanted;
    for (const std::string& label : array.elements)
      wanted.push_back(shortened(label, dialect.name_limit, dialect.is_reserved));
    elements.back() = claim_all(scope, wanted);
  }
  std::vector<Parameter> result;
  for (std::size_t p = 0; p < program.inputs.size(); ++p)
    result.push_back({scope.claim(program.inputs[p].name), false, true, std::move(elements[p])});
  for (const symbolic::OutputArray& array : program.outputs) result.push_back({scope.claim(array.name), true});
  return result;
}

class ArrangementBuilder {
 public:
  ArrangementBuilder(const Program& program, const Dialect& dialect, const std::vector<std::string>& names)
      : program_(program),
        dialect_(dialect),
        statement_names_(names),
        arranged_{program, dialect, NameScope(dialect.is_reserved, dialect.used_names)} {
    arranged_.places.resize(program.statements.size(), Place::nowhere);
    arranged_.spellings.resize(program.statements.size());
    arranged_.expressions.resize(program.statements.size());
    arranged_.stores.resize(program.statements.size());
    for (const symbolic::Constant& constant : program.constants)
      arranged_.constants.push_back(dialect.literal(constant.number(), arranged_.texts));
  }

  Arrangement run() {
    declare_parameters();
    if (dialect_.stores) arranged_.blocks = block_plan(program_);
    find_uses();
    share_angles_of_lanes();
    find_pairs_of_sums();
    if (dialect_.binds_parameters) bind_parameters();
    find_angles_together();
    name_values();
    for (std::size_t i = 0; i < arranged_.places.size(); ++i)
      if (has_expression(arranged_.places[i])) fit(i);
    return std::move(arranged_);
  }

 private:
  const Program& program_;
  const Dialect& dialect_;
  const std::vector<std::string>& statement_names_;
  Arrangement arranged_;
  std::vector<std::string> input_labels_;  // by flat index
  std::vector<bool> inputs_used_;          // by flat index
  std::vector<int> users_;                 // by statement: of several, the first

  const Statement& statement(std::size_t i) const { return program_.statements[i]; }

  void declare_parameters() {
    arranged_.parameters = claim_parameters(program_, dialect_, arranged_.scope);
    for (std::size_t p = 0; p < program_.inputs.size(); ++p) {
      arranged_.parameters[p].used = false;
      const std::vector<std::string>& labels = program_.inputs[p].elements;
      const std::vector<std::string> names = element_names(program_.inputs[p], arranged_.parameters[p]);
      arranged_.input_names.insert(arranged_.input_names.end(), names.begin(), names.end());
      arranged_.input_sources.resize(arranged_.input_names.size(), arranged_.parameters[p].name);
      input_labels_.insert(input_labels_.end(), labels.begin(), labels.end());
    }
    for (std::size_t p = 0; p < program_.outputs.size(); ++p)
      arranged_.parameters[program_.inputs.size() + p].used = !program_.outputs[p].values.empty();
  }

  std::vector<std::string> element_names(const symbolic::InputArray& input, const Parameter& parameter) const {
    if (!parameter.elements.empty()) return parameter.elements;
    std::vector<std::string> names;
    if (input.role == symbolic::Role::parameters && dialect_.members) {
      for (const std::string& member : dialect_.members(input.elements))
        names.push_back(parameter.name + dialect_.member_access + member);
    } else {
      for (std::size_t k = 0; k < input.elements.size(); ++k) names.push_back(element(parameter, k));
    }
    return names;
  }

  std::string element(const Parameter& array, std::size_t k) const { return dialect_.element(array.name, k); }
  std::string shortened(const std::string& name) const {
    return backend::shortened(name, dialect_.name_limit, dialect_.is_reserved);
  }

  void find_uses() {
    std::vector<int> uses(arranged_.places.size(), 0);  // by statements that are needed
    users_.resize(arranged_.places.size(), -1);
    std::vector<bool> inputs_used(arranged_.input_names.size(), false);
    std::vector<bool> apart(arranged_.places.size(), false);  // a lane of it is read, or it is spread to lanes
    const auto use = [&](const Operand& o, int user) {
      if (o.kind == Operand::Kind::input) inputs_used[at(o.index)] = true;
      if (!is_statement(o)) return;
      ++uses[at(o.index)];
      users_[at(o.index)] = user;
      const Statement& reader = statement(at(user));
      if (o.lane >= 0 ||
          (reader.op != Op::gather && reader.op != Op::sum_lanes && reader.width != width_of(program_, o)))
        apart[at(o.index)] = true;
    };
    for (std::size_t p = 0; p < program_.outputs.size(); ++p) {
      const std::vector<Operand>& values = program_.outputs[p].values;
      for (std::size_t k = 0; k < values.size(); ++k) {
        const Operand& o = values[k];
        if (o.kind == Operand::Kind::input) inputs_used[at(o.index)] = true;
        if (is_statement(o) && !is_in_block(arranged_, p, k))
          arranged_.stores[at(o.index)].push_back({element(output_parameter(arranged_, p), k), p, o.negative, o.lane});
      }
    }
    for (std::size_t i = arranged_.places.size(); i-- > 0;) {
      const bool is_column = dialect_.stores && arranged_.blocks.is_column[i];
      if (uses[i] == 0 && arranged_.stores[i].empty() && !is_column) continue;
      const Statement& s = statement(i);
      note_width(s.width);
      if (const auto column = arranged_.blocks.loaded.find(i); column != arranged_.blocks.loaded.end()) {
        arranged_.places[i] = Place::loaded;
        arranged_.parameters[at(arranged_.blocks.loads[column->second.first].array)].used = true;
        continue;
      }
      for_each_operand(s, [&](const Operand& o) { use(o, static_cast<int>(i)); });
      arranged_.places[i] =
          (apart[i] || is_column) && !is_angle_function(s.op) ? Place::own : place(i, uses[i], users_[i]);
      if (arranged_.places[i] == Place::angle) note_angle(i);
    }
    std::size_t element = 0;
    for (std::size_t p = 0; p < program_.inputs.size(); ++p)
      for (std::size_t k = 0; k < program_.inputs[p].elements.size(); ++k)
        if (inputs_used[element++]) arranged_.parameters[p].used = true;
    inputs_used_ = std::move(inputs_used);
  }

  // Sums of lanes that follow each other are defined two by two.
  void find_pairs_of_sums() {
    const auto is_sum_of_lanes = [&](std::size_t i) {
      return statement(i).op == Op::sum_lanes && arranged_.places[i] != Place::nowhere;
    };
    for (std::size_t i = 0; i + 1 < arranged_.places.size(); ++i) {
      if (!is_sum_of_lanes(i) || !is_sum_of_lanes(i + 1)) continue;
      const Operand &a = statement(i).a, &b = statement(i + 1).a;
      if (width_of(program_, a) != width_of(program_, b)) continue;
      arranged_.places[i] = Place::sums;
      arranged_.places[i + 1] = Place::summed;
      if (users_[at(b.index)] == static_cast<int>(i + 1)) users_[at(b.index)] = static_cast<int>(i);
      ++i;
    }
  }

  void note_width(int width) {
    std::vector<int>& widths = arranged_.widths;
    const auto place = std::lower_bound(widths.begin(), widths.end(), width);
    if (width > 1 && (place == widths.end() || *place != width)) widths.insert(place, width);
  }

  void bind_parameters() {
    std::size_t index = 0;
    for (const symbolic::InputArray& input : program_.inputs) {
      for (std::size_t k = 0; k < input.elements.size(); ++k, ++index) {
        if (!is_bound(input.role) || !inputs_used_[index]) continue;
        std::string name = arranged_.scope.claim(shortened(input_labels_[index]));
        Line binding{Line::Kind::binding, {name}, arranged_.input_names[index]};
        binding.names = {arranged_.input_sources[index]};
        arranged_.bindings.push_back(std::move(binding));
        arranged_.input_names[index] = arranged_.input_sources[index] = std::move(name);
      }
    }
  }

  Place place(std::size_t i, int uses, int user) const {
    const Statement& s = statement(i);
    if (is_angle_function(s.op)) return Place::angle;
    const std::vector<Store>& stores = arranged_.stores[i];
    const bool one_sign = std::all_of(
        stores.begin(), stores.end(), [&](const Store& store) { return store.negative == stores.front().negative; });
    if (dialect_.stores && uses == 0 && one_sign && stores.size() <= 2 && s.width == 1) return Place::output;
    if (uses != 1 || !stores.empty() || s.named) return Place::own;
    // The argument of a sine is the argument of its cosine too, and of one definite type.
    const Statement& u = statement(at(user));
    if (is_angle_function(u.op)) return Place::own;
    if (s.op == Op::gather && u.op == Op::gather) return Place::own;
    // What belongs to one link stays with it, but a product always goes where it can be fused.
    const bool fusable = s.op == Op::multiply && is_sum(u.op);
    return fusable || s.section == u.section ? Place::inside : Place::own;
  }

  void note_angle(std::size_t i) {
    const Statement& s = statement(i);
    Angle& angle = arranged_.angles[key_of(s.a)];
    angle.first = static_cast<int>(i);  // statements come last to first
    (s.op == Op::sine ? angle.sine : angle.cosine) = true;
    if (s.width > 1) angle.sine = angle.cosine = true;  // of lanes, both come together only
  }

  // Where all lanes of a value have their sine and cosine, a single lane takes its own from there.
  void share_angles_of_lanes() {
    std::map<AngleKey, Angle>& angles = arranged_.angles;
    for (auto angle = angles.begin(); angle != angles.end();) {
      const AngleKey& key = angle->first;
      const auto whole = key.lane < 0 ? angles.end() : angles.find({key.kind, key.index});
      if (whole == angles.end()) {
        ++angle;
        continue;
      }
      whole->second.first = std::min(whole->second.first, angle->second.first);
      angle = angles.erase(angle);
    }
  }

  // Decides whether sines and cosines of inputs are computed together: of one array, and most of the elements between
  // the first and the last.
  void find_angles_together() {
    std::vector<int> angles;
    for (const auto& [key, angle] : arranged_.angles)
      if (key.kind == Operand::Kind::input) angles.push_back(key.index);
    if (dialect_.angles_together == 0 || angles.size() < dialect_.angles_together) return;
    const std::size_t count = at(angles.back() - angles.front()) + 1;
    std::size_t end = 0;
    for (const symbolic::InputArray& array : program_.inputs) {
      end += array.elements.size();
      if (at(angles.front()) < end) break;
    }
    if (at(angles.back()) >= end || count > 2 * angles.size()) return;
    arranged_.first_together = angles.front();
    arranged_.together = count;
    for (auto& [key, angle] : arranged_.angles)
      if (key.kind == Operand::Kind::input) angle.sine = angle.cosine = true;
  }

  void name_values() {
    for (auto& [key, angle] : arranged_.angles) {
      const auto& [kind, index, lane] = key;
      std::string subject = kind == Operand::Kind::input       ? input_labels_[at(index)]
                            : kind == Operand::Kind::statement ? statement_names_[at(index)]
                                                               : statement_names_[at(angle.first)];
      if (lane >= 0) subject += "_" + std::to_string(lane);
      // Both names and the argument's stand in one line.
      const std::size_t limit = kind == Operand::Kind::input ? dialect_.name_limit : dialect_.name_limit * 5 / 6;
      const auto claim = [&](const std::string& name) {
        return arranged_.scope.claim(backend::shortened(name, limit, dialect_.is_reserved));
      };
      if (angle.sine) angle.sine_name = claim("s_" + subject);
      if (angle.cosine) angle.cosine_name = claim("c_" + subject);
    }
    std::vector<std::string> wanted;
    wanted.reserve(program_.statements.size());
    for (const std::string& name : statement_names_) wanted.push_back(shortened(name));
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

  struct Part {
    int statement = -1;
    bool fused = false;  // a product inside a sum
    std::size_t width = 0;
  };

  // The part of i's expression to take out first: the widest, products inside sums last.
  void consider_parts(std::size_t i, Part& best) const {
    if (arranged_.places[i] == Place::sums) consider_parts(i + 1, best);
    const Statement& s = statement(i);
    for_each_operand(s, [&](const Operand& o) {
      if (!is_statement(o) || arranged_.places[at(o.index)] != Place::inside) return;
      const Part part{
          o.index, statement(at(o.index)).op == Op::multiply && is_sum(s.op),
          arranged_.expressions[at(o.index)].text.size()};
      if (best.statement < 0 || std::pair(!part.fused, part.width) > std::pair(!best.fused, best.width)) best = part;
      consider_parts(at(o.index), best);
    });
  }

  // Statements come in their order: what stands inside one is spelled, and fits, before it.
  void fit(std::size_t i) {
    arranged_.expressions[i] = expression(arranged_, i);
    while (!fits(i)) {
      Part part;
      consider_parts(i, part);
      if (part.statement < 0) {
        if (arranged_.places[i] != Place::sums) return;
        part_sums(i);
        continue;
      }
      arranged_.places[at(part.statement)] = Place::own;
      spell_users(at(part.statement), i);
    }
  }

  // Two sums whose line is too long: each has its own.
  void part_sums(std::size_t i) {
    arranged_.places[i] = arranged_.places[i + 1] = Place::own;
    arranged_.expressions[i] = expression(arranged_, i);
  }

  // A line is written to be measured only where it may be too long.
  bool fits(std::size_t i) {
    const std::size_t inner = arranged_.spellings[i].text.size() + arranged_.expressions[i].text.size();
    const bool is_definition = arranged_.places[i] == Place::own || arranged_.places[i] == Place::inside;
    if (is_definition && inner + dialect_.around <= dialect_.line_limit) return true;
    const std::string text = dialect_.text(line(arranged_, i));
    const std::size_t first = std::min(text.find('\n'), text.size());
    const std::size_t rest = text.size() - std::min(first + 1, text.size());
    return first <= dialect_.line_limit && rest <= dialect_.line_limit + dialect_.indentation;
  }

  // All that the part stood inside of is other text now, up to i.
  void spell_users(std::size_t part, std::size_t i) {
    while (part != i) {
      part = at(users_[part]);
      arranged_.expressions[part] = expression(arranged_, part);
    }
  }
};

}  // namespace

std::vector<Parameter> parameters(const Program& program, const Dialect& dialect) {
  NameScope scope(dialect.is_reserved, dialect.used_names);
  return claim_parameters(program, dialect, scope);
}

// Names decide how long lines are, and what has to be a line of its own, and so has to have a name: two rounds, seldom
// more.
Arrangement arrange(const Program& program, const Dialect& dialect) {
  constexpr int kRounds = 4;
  const symbolic::QuantityNames quantities(program);
  std::vector<bool> is_line(program.statements.size(), false);
  for (int round = 0;; ++round) {
    const std::vector<std::string> names = symbolic::line_names(quantities, is_line);
    Arrangement arranged = ArrangementBuilder(program, dialect, names).run();
    bool is_new = false;
    for (std::size_t i = 0; i < is_line.size(); ++i) {
      const Place place = arranged.places[i];
      const bool has_name =
          place == Place::own || place == Place::sums || place == Place::summed || place == Place::loaded;
      if (is_line[i] || !has_name) continue;
      is_line[i] = is_new = true;
    }
    if (!is_new || round == kRounds) return arranged;
  }
}

}  // namespace robcogen::backend
