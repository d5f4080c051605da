#include "backend/common/lower.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "backend/common/block_plan.h"

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
bool is_angle_function(Op op) {
  return op == Op::sine || op == Op::cosine;
}

// An element of an output that a statement supplies.
struct Store {
  std::string target;
  bool negative = false;
  int lane = -1;  // -1: of a scalar
};

// What becomes of a statement.
enum class Place {
  nowhere,  // no output needs it
  angle,    // a sine or cosine, defined with its pair
  inside,   // part of its only user's expression
  own,      // a definition
  output,   // stored without a name
  loaded,   // part of a block
};

// Sine and cosine of one argument.
struct Angle {
  int first = -1;  // statement that asks for it first
  bool sine = false, cosine = false;
  std::string sine_name, cosine_name;
};

class Lowering {
 public:
  Lowering(const Program& program, const Dialect& dialect, Kernel& kernel)
      : program_(program),
        dialect_(dialect),
        kernel_(kernel),
        scope_(dialect.is_reserved, dialect.used_names),
        places_(program.statements.size(), Place::nowhere),
        spellings_(program.statements.size()),
        stores_(program.statements.size()) {}

  void run() {
    declare_parameters();
    if (dialect_.stores) blocks_ = block_plan(program_);
    find_uses();
    if (dialect_.binds_parameters) bind_parameters();
    find_angles_together();
    name_values();
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (places_[i] != Place::nowhere && places_[i] != Place::angle) fit(i);
    emit_fills();
    emit_input_angles();
    for (std::size_t i = 0; i < places_.size(); ++i) emit(i);
    if (dialect_.stores) {
      emit_plain_outputs();
    } else {
      list_results();
    }
  }

 private:
  using AngleKey = std::pair<Operand::Kind, int>;

  const Program& program_;
  const Dialect& dialect_;
  Kernel& kernel_;
  NameScope scope_;
  std::vector<std::string> input_names_;   // by flat index: `q[1]`
  std::vector<std::string> input_labels_;  // by flat index
  std::vector<bool> inputs_used_;          // by flat index
  std::vector<Place> places_;
  std::vector<Spelling> spellings_;         // how a user reads the statement, unless it stands inside
  std::vector<std::vector<Store>> stores_;  // by statement
  std::map<AngleKey, Angle> angles_;
  int first_together_ = 0;    // input element
  std::size_t together_ = 0;  // how many from it on have their sines and cosines computed together; 0: none
  std::string section_;       // title of the section that the last line belongs to
  BlockPlan blocks_;
  std::vector<std::string> load_names_;
  std::set<int> angles_done_;  // statements whose sine and cosine are computed with their block

  const Statement& statement(std::size_t i) const { return program_.statements[i]; }

  void declare_parameters() {
    kernel_.parameters = parameters(program_, dialect_);
    for (const Parameter& p : kernel_.parameters) {
      scope_.take(p.name);
      for (const std::string& e : p.elements) scope_.take(e);
    }
    for (std::size_t p = 0; p < program_.inputs.size(); ++p) {
      kernel_.parameters[p].used = false;
      const std::vector<std::string>& labels = program_.inputs[p].elements;
      const std::vector<std::string> names = element_names(program_.inputs[p], kernel_.parameters[p]);
      input_names_.insert(input_names_.end(), names.begin(), names.end());
      input_labels_.insert(input_labels_.end(), labels.begin(), labels.end());
    }
    for (std::size_t p = 0; p < program_.outputs.size(); ++p)
      output_parameter(p).used = !program_.outputs[p].values.empty();
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
  std::string text(const Spelling& value) const { return backend::text(value); }

  Parameter& output_parameter(std::size_t output) { return kernel_.parameters[program_.inputs.size() + output]; }

  void find_uses() {
    std::vector<int> uses(places_.size(), 0);  // by statements that are needed
    std::vector<int> last_user(places_.size(), -1);
    std::vector<bool> inputs_used(input_names_.size(), false);
    std::vector<bool> apart(places_.size(), false);  // a lane of it is read, or it is spread to lanes
    const auto use = [&](const Operand& o, int user) {
      if (o.kind == Operand::Kind::input) inputs_used[at(o.index)] = true;
      if (!is_statement(o)) return;
      ++uses[at(o.index)];
      last_user[at(o.index)] = user;
      const Statement& reader = statement(at(user));
      if (o.lane >= 0 || (reader.op != Op::gather && reader.op != Op::sum_lanes && reader.width != width(o)))
        apart[at(o.index)] = true;
    };
    for (std::size_t p = 0; p < program_.outputs.size(); ++p) {
      const std::vector<Operand>& values = program_.outputs[p].values;
      for (std::size_t k = 0; k < values.size(); ++k) {
        const Operand& o = values[k];
        if (o.kind == Operand::Kind::input) inputs_used[at(o.index)] = true;
        if (is_statement(o) && !is_in_block(p, k))
          stores_[at(o.index)].push_back({element(output_parameter(p), k), o.negative, o.lane});
      }
    }
    for (std::size_t i = places_.size(); i-- > 0;) {
      const bool is_column = dialect_.stores && blocks_.is_column[i];
      if (uses[i] == 0 && stores_[i].empty() && !is_column) continue;
      const Statement& s = statement(i);
      note_width(s.width);
      if (const auto column = blocks_.loaded.find(i); column != blocks_.loaded.end()) {
        places_[i] = Place::loaded;
        kernel_.parameters[at(blocks_.loads[column->second.first].array)].used = true;
        continue;
      }
      for_each_operand(s, [&](const Operand& o) { use(o, static_cast<int>(i)); });
      places_[i] = (apart[i] || is_column) && !is_angle_function(s.op) ? Place::own : place(i, uses[i], last_user[i]);
      if (places_[i] == Place::angle) note_angle(i);
    }
    std::size_t element = 0;
    for (std::size_t p = 0; p < program_.inputs.size(); ++p)
      for (std::size_t k = 0; k < program_.inputs[p].elements.size(); ++k)
        if (inputs_used[element++]) kernel_.parameters[p].used = true;
    inputs_used_ = std::move(inputs_used);
  }

  bool is_in_block(std::size_t output, std::size_t element) const {
    return dialect_.stores && blocks_.is_stored[output][element];
  }

  int width(const Operand& o) const { return is_statement(o) && o.lane < 0 ? statement(at(o.index)).width : 1; }

  void note_width(int width) {
    std::vector<int>& widths = kernel_.widths;
    const auto place = std::lower_bound(widths.begin(), widths.end(), width);
    if (width > 1 && (place == widths.end() || *place != width)) widths.insert(place, width);
  }

  void bind_parameters() {
    std::size_t index = 0;
    for (std::size_t p = 0; p < program_.inputs.size(); ++p) {
      for (std::size_t k = 0; k < program_.inputs[p].elements.size(); ++k, ++index) {
        if (!is_bound(program_.inputs[p].role) || !inputs_used_[index]) continue;
        std::string name = scope_.claim(shortened(input_labels_[index]));
        add({Line::Kind::binding, {name}, input_names_[index]});
        input_names_[index] = std::move(name);
      }
    }
  }

  Place place(std::size_t i, int uses, int user) const {
    const Statement& s = statement(i);
    if (is_angle_function(s.op)) return Place::angle;
    const std::vector<Store>& stores = stores_[i];
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
    Angle& angle = angles_[{s.a.kind, s.a.index}];
    angle.first = static_cast<int>(i);  // statements come last to first
    (s.op == Op::sine ? angle.sine : angle.cosine) = true;
    if (s.width > 1) angle.sine = angle.cosine = true;  // of lanes, both come together only
  }

  // Decides whether sines and cosines of inputs are computed together: of one array, and most of the elements between
  // the first and the last.
  void find_angles_together() {
    std::vector<int> angles;
    for (const auto& [key, angle] : angles_)
      if (key.first == Operand::Kind::input) angles.push_back(key.second);
    if (dialect_.angles_together == 0 || angles.size() < dialect_.angles_together) return;
    const std::size_t count = at(angles.back() - angles.front()) + 1;
    std::size_t end = 0;
    for (const symbolic::InputArray& array : program_.inputs) {
      end += array.elements.size();
      if (at(angles.front()) < end) break;
    }
    if (at(angles.back()) >= end || count > 2 * angles.size()) return;
    first_together_ = angles.front();
    together_ = count;
    for (auto& [key, angle] : angles_)
      if (key.first == Operand::Kind::input) angle.sine = angle.cosine = true;
  }

  void name_values() {
    for (auto& [key, angle] : angles_) {
      const auto& [kind, index] = key;
      const std::string subject = kind == Operand::Kind::input       ? input_labels_[at(index)]
                                  : kind == Operand::Kind::statement ? statement(at(index)).name
                                                                     : statement(at(angle.first)).name;
      if (angle.sine) angle.sine_name = scope_.claim(shortened("s_" + subject));
      if (angle.cosine) angle.cosine_name = scope_.claim(shortened("c_" + subject));
    }
    std::vector<std::string> wanted;
    for (const Statement& s : program_.statements) wanted.push_back(shortened(s.name));
    const std::vector<std::string> names = claim_all(scope_, wanted);
    for (const symbolic::Block& load : blocks_.loads)
      load_names_.push_back(scope_.claim(program_.inputs[at(load.array)].name + "_lanes"));
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Statement& s = statement(i);
      if (places_[i] == Place::loaded) {
        const auto& [load, column] = blocks_.loaded.at(i);
        spellings_[i].text = dialect_.element(load_names_[load], column);
        continue;
      }
      if (places_[i] != Place::angle) {
        spellings_[i].text = names[i];
        continue;
      }
      const Angle& angle = angles_.at({s.a.kind, s.a.index});
      spellings_[i].text = s.op == Op::sine ? angle.sine_name : angle.cosine_name;
      spellings_[i].negative = s.op == Op::sine && s.a.negative;
    }
  }

  // As an operand of a statement of so many lanes.
  Spelling spell(const Operand& o, int lanes) const {
    if (lanes == 1 || width(o) == lanes) return spell(o);
    Spelling result;
    if (o.kind == Operand::Kind::constant) {
      const Spelling number = dialect_.literal(program_.constants[at(o.index)]);
      const std::string type = dialect_.type(lanes);
      result = literal(type + "(" + number.text + ")", type + "(" + number.opposite + ")");
      result.negative = o.negative;
      return result;
    }
    const Operand positive = {o.kind, o.index, false, o.lane};
    result = call(dialect_.type(lanes), spell(positive));
    result.negative = o.negative;
    return result;
  }

  Spelling spell(const Operand& o) const {
    Spelling result;
    if (o.kind == Operand::Kind::constant) {
      result = dialect_.literal(program_.constants[at(o.index)]);
      if (program_.constants[at(o.index)].is_zero()) return result;
    } else if (o.kind == Operand::Kind::input) {
      result.text = input_names_[at(o.index)];
    } else {
      result = places_[at(o.index)] == Place::inside ? expression(at(o.index)) : spellings_[at(o.index)];
      if (o.lane >= 0) result.text = dialect_.element(result.text, at(o.lane));
    }
    result.negative = result.negative != o.negative;
    return result;
  }

  Spelling expression(std::size_t i) const {
    const Statement& s = statement(i);
    if (s.op == Op::square_root) return call("sqrt", spell(s.a));
    if (s.op == Op::sum_lanes) return call("sum_lanes", spell(s.a));
    if (s.op == Op::gather) {
      std::string list;
      for (const Operand& o : s.lanes) list += (list.empty() ? "" : ", ") + text(spell(o));
      Spelling gathered;
      gathered.text = dialect_.type(s.width) + "::of(" + list + ")";
      return gathered;
    }
    return binary(s.op, spell(s.a, s.width), spell(s.b, s.width));
  }

  // The line of a statement that is not inside another; of one that is, the line that it would have by itself.
  Line line(std::size_t i) const {
    Spelling value = expression(i);
    if (places_[i] != Place::output)
      return {Line::Kind::definition, {spellings_[i].text}, text(value), 0, statement(i).width};
    value.negative = value.negative != stores_[i].front().negative;
    Line result{Line::Kind::store, {}, text(value)};
    for (const Store& store : stores_[i]) result.targets.push_back(store.target);
    return result;
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
      if (!is_statement(o) || places_[at(o.index)] != Place::inside) return;
      const Part part{
          o.index, statement(at(o.index)).op == Op::multiply && is_sum(s.op), expression(at(o.index)).text.size()};
      if (best.statement < 0 || std::pair(!part.fused, part.width) > std::pair(!best.fused, best.width)) best = part;
      consider_parts(at(o.index), best);
    });
  }

  void fit(std::size_t i) {
    while (text(line(i)).size() > dialect_.line_limit) {
      Part part;
      consider_parts(i, part);
      if (part.statement < 0) return;
      places_[at(part.statement)] = Place::own;
    }
  }

  void add(Line line) { kernel_.lines.push_back(std::move(line)); }

  void enter_section(std::size_t i) {
    const std::string& title = program_.sections[at(statement(i).section)].title;
    if (title == section_) return;
    section_ = title;
    if (!title.empty()) add({Line::Kind::section, {}, title});
  }

  void need(const std::string& function) {
    std::vector<std::string>& list = kernel_.functions;
    const auto place = std::lower_bound(list.begin(), list.end(), function);
    if (place == list.end() || *place != function) list.insert(place, function);
  }

  void emit_angle(const AngleKey& key, const Angle& angle) {
    const Operand operand{key.first, key.second, false};
    const std::string argument = text(spell(operand));
    if (angle.sine && angle.cosine && dialect_.pairs_angles) {
      add({Line::Kind::sincos, {angle.sine_name, angle.cosine_name}, argument, 0, width(operand)});
      return;
    }
    if (angle.sine) define("sin", argument, angle.sine_name);
    if (angle.cosine) define("cos", argument, angle.cosine_name);
  }

  void define(const std::string& function, const std::string& argument, const std::string& name) {
    need(function);
    add({Line::Kind::definition, {name}, function + "(" + argument + ")"});
  }

  void emit_input_angles() {
    if (together_ > 0) {
      const std::string all = scope_.claim("trig");
      add({Line::Kind::sincos_of, {all}, input_names_[at(first_together_)], together_});
      for (const auto& [key, angle] : angles_) {
        if (key.first != Operand::Kind::input) continue;
        const std::string element = dialect_.element(all, at(key.second - first_together_));
        add({Line::Kind::pick, {angle.sine_name, angle.cosine_name}, element});
      }
      return;
    }
    for (const auto& [key, angle] : angles_)
      if (key.first == Operand::Kind::input) emit_angle(key, angle);
  }

  // Before all that stands between their elements.
  void emit_fills() {
    for (const symbolic::Fill& fill : blocks_.stores.fills) {
      Line line{Line::Kind::fill, {}, text(spell(fill.value)), at(fill.count)};
      line.targets = {element(output_parameter(at(fill.array)), at(fill.first))};
      add(std::move(line));
    }
  }

  void emit_load(std::size_t k) {
    const symbolic::Block& block = blocks_.loads[k];
    const std::string first = element(kernel_.parameters[at(block.array)], at(block.first));
    add({Line::Kind::load_block, {load_names_[k]}, first, block.columns.size(), block.width, block.stride});
    emit_angles_of_load(k);
  }

  // Sines and cosines of a block are computed together, where most of its columns are angles: two lanes leave room for
  // others in a register. Four are as well computed where they are used.
  void emit_angles_of_load(std::size_t k) {
    const symbolic::Block& block = blocks_.loads[k];
    if (block.width != 2) return;
    std::vector<std::pair<std::size_t, const Angle*>> angles;
    for (std::size_t c = 0; c < block.columns.size(); ++c) {
      const auto angle = angles_.find({Operand::Kind::statement, block.columns[c].index});
      if (angle != angles_.end()) angles.emplace_back(c, &angle->second);
    }
    if (angles.size() < 2 || block.columns.size() > 2 * angles.size()) return;
    const std::string all = scope_.claim("trig");
    const std::string first = dialect_.element(load_names_[k], 0);
    add({Line::Kind::sincos_of, {all}, first, block.columns.size(), block.width});
    for (const auto& [column, angle] : angles) {
      const std::string element = dialect_.element(all, column);
      add({Line::Kind::pick, {angle->sine_name, angle->cosine_name}, element, 0, block.width});
      angles_done_.insert(block.columns[column].index);
    }
  }

  void emit_block(const symbolic::Block& block) {
    Line line{Line::Kind::store_block, {}, "", block.columns.size(), block.width, block.stride};
    line.targets = {element(output_parameter(at(block.array)), at(block.first))};
    for (const Operand& o : block.columns) line.values.push_back(text(spell(o, block.width)));
    add(std::move(line));
  }

  void emit(std::size_t i) {
    emit_value(i);
    const auto [first, last] = blocks_.store_after.equal_range(i);
    for (auto block = first; block != last; ++block) emit_block(blocks_.stores.blocks[block->second]);
  }

  void emit_value(std::size_t i) {
    const Statement& s = statement(i);
    if (const auto load = blocks_.load_at.find(i); load != blocks_.load_at.end()) {
      enter_section(i);
      emit_load(load->second);
    }
    if (places_[i] == Place::nowhere || places_[i] == Place::loaded) return;
    if (s.op == Op::square_root) need("sqrt");
    if (places_[i] == Place::inside) return;
    if (places_[i] == Place::angle) {
      const AngleKey key{s.a.kind, s.a.index};
      const Angle& angle = angles_.at(key);
      const bool computed =
          key.first != Operand::Kind::input && angle.first == static_cast<int>(i) && angles_done_.count(s.a.index) == 0;
      if (computed || (dialect_.stores && !stores_[i].empty())) enter_section(i);
      if (computed) emit_angle(key, angle);
    } else {
      enter_section(i);
      add(line(i));
      if (places_[i] == Place::output) return;
    }
    if (!dialect_.stores) return;
    for (int lane = s.width > 1 ? 0 : -1; lane < (s.width > 1 ? s.width : 0); ++lane) {
      for (bool negative : {false, true}) {
        std::vector<std::string> targets;
        for (const Store& store : stores_[i])
          if (store.negative == negative && store.lane == lane) targets.push_back(store.target);
        Spelling value = spellings_[i];
        if (lane >= 0) value.text = dialect_.element(value.text, at(lane));
        value.negative = value.negative != negative;
        store(targets, text(value));
      }
    }
  }

  // Equal elements at once, as many as a line holds.
  void store(const std::vector<std::string>& targets, const std::string& value) {
    Line line{Line::Kind::store, {}, value};
    for (const std::string& target : targets) {
      line.targets.push_back(target);
      if (text(line).size() <= dialect_.line_limit) continue;
      line.targets.pop_back();
      add(line);
      line.targets = {target};
    }
    if (!line.targets.empty()) add(std::move(line));
  }

  void list_results() {
    for (const symbolic::OutputArray& output : program_.outputs) {
      std::vector<std::string>& elements = kernel_.results.emplace_back();
      for (const Operand& o : output.values) elements.push_back(text(spell(o)));
    }
  }

  // Elements that are inputs or constants: each value once, in the order of the elements.
  void emit_plain_outputs() {
    for (const Operand::Kind kind : {Operand::Kind::input, Operand::Kind::constant}) {
      std::vector<std::string> values;
      std::map<std::string, std::vector<std::string>> targets;
      for (std::size_t p = 0; p < program_.outputs.size(); ++p) {
        for (std::size_t k = 0; k < program_.outputs[p].values.size(); ++k) {
          const Operand& o = program_.outputs[p].values[k];
          if (o.kind != kind || is_in_block(p, k)) continue;
          const std::string value = text(spell(o));
          if (targets[value].empty()) values.push_back(value);
          targets[value].push_back(element(output_parameter(p), k));
        }
      }
      if (values.empty()) continue;
      if (!kernel_.lines.empty())
        add({Line::Kind::section, {}, kind == Operand::Kind::input ? "elements that are inputs" : "constant elements"});
      for (const std::string& value : values) store(targets[value], value);
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

Kernel lower(const Program& program, const std::string& name, const Dialect& dialect) {
  Kernel kernel;
  kernel.name = name;
  Lowering(program, dialect, kernel).run();
  return kernel;
}

}  // namespace robcogen::backend
