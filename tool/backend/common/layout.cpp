#include "backend/common/layout.h"

#include <algorithm>

namespace robcogen::backend {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

// By Dialect::binds_parameters.
bool is_bound(symbolic::Role role) {
  using symbolic::Role;
  return role == Role::parameters || role == Role::joint_sine || role == Role::joint_cosine;
}

Spelling expression(const Layout& layout, std::size_t i) {
  const Statement& s = layout.program.statements[i];
  if (s.op == Op::square_root) return call("sqrt", spell(layout, s.a));
  if (s.op == Op::sum_lanes) return call("sum_lanes", spell(layout, s.a));
  if (s.op == Op::gather) {
    std::string list;
    for (const Operand& o : s.lanes) list += (list.empty() ? "" : ", ") + text(spell(layout, o));
    Spelling gathered;
    gathered.text = layout.dialect.type(s.width) + "::of(" + list + ")";
    return gathered;
  }
  return binary(s.op, spell(layout, s.a, s.width), spell(layout, s.b, s.width));
}

class Arranging {
 public:
  Arranging(const Program& program, const Dialect& dialect)
      : program_(program),
        dialect_(dialect),
        layout_{program, dialect, NameScope(dialect.is_reserved, dialect.used_names)} {
    layout_.places.resize(program.statements.size(), Place::nowhere);
    layout_.spellings.resize(program.statements.size());
    layout_.stores.resize(program.statements.size());
  }

  Layout run() {
    declare_parameters();
    if (dialect_.stores) layout_.blocks = block_plan(program_);
    find_uses();
    if (dialect_.binds_parameters) bind_parameters();
    find_angles_together();
    name_values();
    for (std::size_t i = 0; i < layout_.places.size(); ++i)
      if (layout_.places[i] != Place::nowhere && layout_.places[i] != Place::angle) fit(i);
    return std::move(layout_);
  }

 private:
  const Program& program_;
  const Dialect& dialect_;
  Layout layout_;
  std::vector<std::string> input_labels_;  // by flat index
  std::vector<bool> inputs_used_;          // by flat index

  const Statement& statement(std::size_t i) const { return program_.statements[i]; }

  void declare_parameters() {
    layout_.parameters = parameters(program_, dialect_);
    for (const Parameter& p : layout_.parameters) {
      layout_.scope.take(p.name);
      for (const std::string& e : p.elements) layout_.scope.take(e);
    }
    for (std::size_t p = 0; p < program_.inputs.size(); ++p) {
      layout_.parameters[p].used = false;
      const std::vector<std::string>& labels = program_.inputs[p].elements;
      const std::vector<std::string> names = element_names(program_.inputs[p], layout_.parameters[p]);
      layout_.input_names.insert(layout_.input_names.end(), names.begin(), names.end());
      input_labels_.insert(input_labels_.end(), labels.begin(), labels.end());
    }
    for (std::size_t p = 0; p < program_.outputs.size(); ++p)
      layout_.parameters[program_.inputs.size() + p].used = !program_.outputs[p].values.empty();
  }

  std::vector<std::string> element_names(const symbolic::InputArray& input, const Parameter& parameter) const {
    if (!parameter.elements.empty()) return parameter.elements;
    std::vector<std::string> names;
    if (input.role == symbolic::Role::parameters && dialect_.members) {
      for (const std::string& member : dialect_.members(input.elements)) names.push_back(parameter.name + "." + member);
    } else {
      for (std::size_t k = 0; k < input.elements.size(); ++k) names.push_back(element(parameter, k));
    }
    return names;
  }

  std::string element(const Parameter& array, std::size_t k) const { return dialect_.element(array.name, k); }
  std::string shortened(const std::string& name) const {
    return backend::shortened(name, dialect_.name_limit, dialect_.is_reserved);
  }
  std::string text(const Line& line) const { return dialect_.text(line); }

  void find_uses() {
    std::vector<int> uses(layout_.places.size(), 0);  // by statements that are needed
    std::vector<int> last_user(layout_.places.size(), -1);
    std::vector<bool> inputs_used(layout_.input_names.size(), false);
    std::vector<bool> apart(layout_.places.size(), false);  // a lane of it is read, or it is spread to lanes
    const auto use = [&](const Operand& o, int user) {
      if (o.kind == Operand::Kind::input) inputs_used[at(o.index)] = true;
      if (!is_statement(o)) return;
      ++uses[at(o.index)];
      last_user[at(o.index)] = user;
      const Statement& reader = statement(at(user));
      if (o.lane >= 0 || (reader.op != Op::gather && reader.op != Op::sum_lanes && reader.width != width(layout_, o)))
        apart[at(o.index)] = true;
    };
    for (std::size_t p = 0; p < program_.outputs.size(); ++p) {
      const std::vector<Operand>& values = program_.outputs[p].values;
      for (std::size_t k = 0; k < values.size(); ++k) {
        const Operand& o = values[k];
        if (o.kind == Operand::Kind::input) inputs_used[at(o.index)] = true;
        if (is_statement(o) && !is_in_block(layout_, p, k))
          layout_.stores[at(o.index)].push_back({element(output_parameter(layout_, p), k), o.negative, o.lane});
      }
    }
    for (std::size_t i = layout_.places.size(); i-- > 0;) {
      const bool is_column = dialect_.stores && layout_.blocks.is_column[i];
      if (uses[i] == 0 && layout_.stores[i].empty() && !is_column) continue;
      const Statement& s = statement(i);
      note_width(s.width);
      if (const auto column = layout_.blocks.loaded.find(i); column != layout_.blocks.loaded.end()) {
        layout_.places[i] = Place::loaded;
        layout_.parameters[at(layout_.blocks.loads[column->second.first].array)].used = true;
        continue;
      }
      for_each_operand(s, [&](const Operand& o) { use(o, static_cast<int>(i)); });
      layout_.places[i] =
          (apart[i] || is_column) && !is_angle_function(s.op) ? Place::own : place(i, uses[i], last_user[i]);
      if (layout_.places[i] == Place::angle) note_angle(i);
    }
    std::size_t element = 0;
    for (std::size_t p = 0; p < program_.inputs.size(); ++p)
      for (std::size_t k = 0; k < program_.inputs[p].elements.size(); ++k)
        if (inputs_used[element++]) layout_.parameters[p].used = true;
    inputs_used_ = std::move(inputs_used);
  }

  void note_width(int width) {
    std::vector<int>& widths = layout_.widths;
    const auto place = std::lower_bound(widths.begin(), widths.end(), width);
    if (width > 1 && (place == widths.end() || *place != width)) widths.insert(place, width);
  }

  void bind_parameters() {
    std::size_t index = 0;
    for (const symbolic::InputArray& input : program_.inputs) {
      for (std::size_t k = 0; k < input.elements.size(); ++k, ++index) {
        if (!is_bound(input.role) || !inputs_used_[index]) continue;
        std::string name = layout_.scope.claim(shortened(input_labels_[index]));
        layout_.bindings.push_back({Line::Kind::binding, {name}, layout_.input_names[index]});
        layout_.input_names[index] = std::move(name);
      }
    }
  }

  Place place(std::size_t i, int uses, int user) const {
    const Statement& s = statement(i);
    if (is_angle_function(s.op)) return Place::angle;
    const std::vector<Store>& stores = layout_.stores[i];
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
    Angle& angle = layout_.angles[{s.a.kind, s.a.index}];
    angle.first = static_cast<int>(i);  // statements come last to first
    (s.op == Op::sine ? angle.sine : angle.cosine) = true;
    if (s.width > 1) angle.sine = angle.cosine = true;  // of lanes, both come together only
  }

  // Decides whether sines and cosines of inputs are computed together: of one array, and most of the elements between
  // the first and the last.
  void find_angles_together() {
    std::vector<int> angles;
    for (const auto& [key, angle] : layout_.angles)
      if (key.first == Operand::Kind::input) angles.push_back(key.second);
    if (dialect_.angles_together == 0 || angles.size() < dialect_.angles_together) return;
    const std::size_t count = at(angles.back() - angles.front()) + 1;
    std::size_t end = 0;
    for (const symbolic::InputArray& array : program_.inputs) {
      end += array.elements.size();
      if (at(angles.front()) < end) break;
    }
    if (at(angles.back()) >= end || count > 2 * angles.size()) return;
    layout_.first_together = angles.front();
    layout_.together = count;
    for (auto& [key, angle] : layout_.angles)
      if (key.first == Operand::Kind::input) angle.sine = angle.cosine = true;
  }

  void name_values() {
    for (auto& [key, angle] : layout_.angles) {
      const auto& [kind, index] = key;
      const std::string subject = kind == Operand::Kind::input       ? input_labels_[at(index)]
                                  : kind == Operand::Kind::statement ? statement(at(index)).name
                                                                     : statement(at(angle.first)).name;
      if (angle.sine) angle.sine_name = layout_.scope.claim(shortened("s_" + subject));
      if (angle.cosine) angle.cosine_name = layout_.scope.claim(shortened("c_" + subject));
    }
    std::vector<std::string> wanted;
    for (const Statement& s : program_.statements) wanted.push_back(shortened(s.name));
    const std::vector<std::string> names = claim_all(layout_.scope, wanted);
    for (const symbolic::Block& load : layout_.blocks.loads)
      layout_.load_names.push_back(layout_.scope.claim(program_.inputs[at(load.array)].name + "_lanes"));
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Statement& s = statement(i);
      if (layout_.places[i] == Place::loaded) {
        const auto& [load, column] = layout_.blocks.loaded.at(i);
        layout_.spellings[i].text = dialect_.element(layout_.load_names[load], column);
        continue;
      }
      if (layout_.places[i] != Place::angle) {
        layout_.spellings[i].text = names[i];
        continue;
      }
      const Angle& angle = layout_.angles.at({s.a.kind, s.a.index});
      layout_.spellings[i].text = s.op == Op::sine ? angle.sine_name : angle.cosine_name;
      layout_.spellings[i].negative = s.op == Op::sine && s.a.negative;
    }
  }

  struct Part {
    int statement = -1;
    bool fused = false;  // a product inside a sum
    std::size_t width = 0;
  };

  // The part of i's expression to take out first: the widest, products inside sums last.
  void consider_parts(std::size_t i, Part& best) const {
    const Statement& s = statement(i);
    for_each_operand(s, [&](const Operand& o) {
      if (!is_statement(o) || layout_.places[at(o.index)] != Place::inside) return;
      const Part part{
          o.index, statement(at(o.index)).op == Op::multiply && is_sum(s.op),
          expression(layout_, at(o.index)).text.size()};
      if (best.statement < 0 || std::pair(!part.fused, part.width) > std::pair(!best.fused, best.width)) best = part;
      consider_parts(at(o.index), best);
    });
  }

  void fit(std::size_t i) {
    while (text(line(layout_, i)).size() > dialect_.line_limit) {
      Part part;
      consider_parts(i, part);
      if (part.statement < 0) return;
      layout_.places[at(part.statement)] = Place::own;
    }
  }
};

}  // namespace

std::vector<Parameter> parameters(const Program& program, const Dialect& dialect) {
  NameScope scope(dialect.is_reserved, dialect.used_names);
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

Layout layout(const Program& program, const Dialect& dialect) {
  return Arranging(program, dialect).run();
}

int width(const Layout& layout, const Operand& o) {
  return is_statement(o) && o.lane < 0 ? layout.program.statements[at(o.index)].width : 1;
}

Spelling spell(const Layout& layout, const Operand& o, int lanes) {
  if (lanes == 1 || width(layout, o) == lanes) return spell(layout, o);
  Spelling result;
  if (o.kind == Operand::Kind::constant) {
    const Spelling number = layout.dialect.literal(layout.program.constants[at(o.index)]);
    const std::string type = layout.dialect.type(lanes);
    result = literal(type + "(" + number.text + ")", type + "(" + number.opposite + ")");
    result.negative = o.negative;
    return result;
  }
  const Operand positive = {o.kind, o.index, false, o.lane};
  result = call(layout.dialect.type(lanes), spell(layout, positive));
  result.negative = o.negative;
  return result;
}

Spelling spell(const Layout& layout, const Operand& o) {
  Spelling result;
  if (o.kind == Operand::Kind::constant) {
    result = layout.dialect.literal(layout.program.constants[at(o.index)]);
    if (layout.program.constants[at(o.index)].is_zero()) return result;
  } else if (o.kind == Operand::Kind::input) {
    result.text = layout.input_names[at(o.index)];
  } else {
    result =
        layout.places[at(o.index)] == Place::inside ? expression(layout, at(o.index)) : layout.spellings[at(o.index)];
    if (o.lane >= 0) result.text = layout.dialect.element(result.text, at(o.lane));
  }
  result.negative = result.negative != o.negative;
  return result;
}

Line line(const Layout& layout, std::size_t i) {
  Spelling value = expression(layout, i);
  if (layout.places[i] != Place::output)
    return {Line::Kind::definition, {layout.spellings[i].text}, text(value), 0, layout.program.statements[i].width};
  value.negative = value.negative != layout.stores[i].front().negative;
  Line result{Line::Kind::store, {}, text(value)};
  for (const Store& store : layout.stores[i]) result.targets.push_back(store.target);
  return result;
}

const Parameter& output_parameter(const Layout& layout, std::size_t output) {
  return layout.parameters[layout.program.inputs.size() + output];
}

bool is_in_block(const Layout& layout, std::size_t output, std::size_t element) {
  return layout.dialect.stores && layout.blocks.is_stored[output][element];
}

bool is_angle_function(Op op) {
  return op == Op::sine || op == Op::cosine;
}

}  // namespace robcogen::backend
