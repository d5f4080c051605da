#include "backend/common/lower.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "backend/common/arrangement.h"
#include "support/concat.h"
#include "support/index.h"

namespace robcogen::backend {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

// Writes the lines.
class Emission {
 public:
  Emission(const Program& program, const std::string& name, const Dialect& dialect)
      : program_(program), dialect_(dialect), arranged_(arrange(program, dialect)) {
    kernel_.name = name;
  }

  Kernel run() {
    kernel_.parameters = arranged_.parameters;
    kernel_.widths = arranged_.widths;
    kernel_.lines = arranged_.bindings;
    emit_fills();
    emit_input_angles();
    for (std::size_t i = 0; i < program_.statements.size(); ++i) emit(i);
    if (dialect_.stores) {
      emit_plain_outputs();
    } else {
      list_results();
    }
    return std::move(kernel_);
  }

 private:
  const Program& program_;
  const Dialect& dialect_;
  Arrangement arranged_;
  Kernel kernel_;
  std::string section_;        // title of the section that the last line belongs to
  std::set<int> angles_done_;  // statements whose sine and cosine are computed with their block

  const Statement& statement(std::size_t i) const { return program_.statements[i]; }
  std::string text(const Line& line) const { return backend::text(line, dialect_); }
  std::string text(const Spelling& value) const { return backend::text(value); }

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

  // Of an operand as it is.
  std::vector<std::string> names_of(const Operand& o) const {
    std::vector<std::string> names;
    add_names(arranged_, o, width_of(program_, o), names);
    return names;
  }

  void emit_angle(const AngleKey& key, const Angle& angle) {
    const Operand operand{key.kind, key.index, false, key.lane};
    if (angle.sine && angle.cosine && dialect_.pairs_angles) {
      Line line{Line::Kind::sincos, {angle.sine_name, angle.cosine_name}, text(spell(arranged_, operand))};
      line.width = width_of(program_, operand);
      line.names = names_of(operand);
      add(std::move(line));
      return;
    }
    if (angle.sine) define(dialect_.sine, operand, angle.sine_name);
    if (angle.cosine) define(dialect_.cosine, operand, angle.cosine_name);
  }

  void define(const std::string& function, const Operand& argument, const std::string& name) {
    need(function);
    Line line{Line::Kind::definition, {name}, function + "(" + text(spell(arranged_, argument)) + ")"};
    line.names = names_of(argument);
    line.names.push_back(function);
    add(std::move(line));
  }

  // The sines and cosines of `count` values; the first one is an element of `array`.
  void compute_together(
      const std::string& all,
      const std::string& first,
      const std::string& array,
      std::size_t count,
      int width) {
    Line line{Line::Kind::sincos_of, {all}, first, count, width};
    line.names = {array};
    add(std::move(line));
  }

  // Those of one of them.
  void pick(const Angle& angle, const std::string& all, std::size_t k, int width) {
    Line line{Line::Kind::pick, {angle.sine_name, angle.cosine_name}, dialect_.element(all, k), 0, width};
    line.names = {all};
    add(std::move(line));
  }

  void emit_input_angles() {
    if (arranged_.together > 0) {
      const std::string all = arranged_.scope.claim("trig");
      const std::size_t first = at(arranged_.first_together);
      compute_together(all, arranged_.input_names[first], arranged_.input_sources[first], arranged_.together, 1);
      for (const auto& [key, angle] : arranged_.angles)
        if (key.kind == Operand::Kind::input) pick(angle, all, at(key.index) - first, 1);
      return;
    }
    for (const auto& [key, angle] : arranged_.angles)
      if (key.kind == Operand::Kind::input) emit_angle(key, angle);
  }

  // Before all that stands between their elements.
  void emit_fills() {
    for (const symbolic::Fill& fill : arranged_.blocks.stores.fills) {
      Line line{Line::Kind::fill, {}, text(spell(arranged_, fill.value)), at(fill.count)};
      line.targets = {target(arranged_, at(fill.array), at(fill.first))};
      line.names = {output_parameter(arranged_, at(fill.array)).name};
      add(std::move(line));
    }
  }

  void emit_load(std::size_t k) {
    const symbolic::Block& block = arranged_.blocks.loads[k];
    const Parameter& input = arranged_.parameters[at(block.array)];
    Line line{
        Line::Kind::load_block,
        {arranged_.load_names[k]},
        dialect_.element(input.name, at(block.first)),
        block.columns.size()};
    line.width = block.width;
    line.stride = block.stride;
    line.names = {input.name};
    add(std::move(line));
    emit_angles_of_load(k);
  }

  // Sines and cosines of a block are computed together, where most of its columns are angles: two lanes leave room for
  // others in a register. Four are as well computed where they are used.
  void emit_angles_of_load(std::size_t k) {
    const symbolic::Block& block = arranged_.blocks.loads[k];
    if (block.width != 2) return;
    std::vector<std::pair<std::size_t, const Angle*>> angles;
    for (std::size_t c = 0; c < block.columns.size(); ++c) {
      const auto angle = arranged_.angles.find({Operand::Kind::statement, block.columns[c].index});
      if (angle != arranged_.angles.end()) angles.emplace_back(c, &angle->second);
    }
    if (angles.size() < 2 || block.columns.size() > 2 * angles.size()) return;
    const std::string all = arranged_.scope.claim("trig");
    const std::string& load = arranged_.load_names[k];
    compute_together(all, dialect_.element(load, 0), load, block.columns.size(), block.width);
    for (const auto& [column, angle] : angles) {
      pick(*angle, all, column, block.width);
      angles_done_.insert(block.columns[column].index);
    }
  }

  void emit_block(const symbolic::Block& block) {
    Line line{Line::Kind::store_block, {}, "", block.columns.size(), block.width, block.stride};
    line.targets = {target(arranged_, at(block.array), at(block.first))};
    line.names = {output_parameter(arranged_, at(block.array)).name};
    for (const Operand& o : block.columns) {
      line.values.push_back(text(spell(arranged_, o, block.width)));
      add_names(arranged_, o, block.width, line.names);
    }
    add(std::move(line));
  }

  void emit(std::size_t i) {
    emit_value(i);
    const auto [first, last] = arranged_.blocks.store_after.equal_range(i);
    for (auto block = first; block != last; ++block) emit_block(arranged_.blocks.stores.blocks[block->second]);
  }

  void emit_value(std::size_t i) {
    const Statement& s = statement(i);
    if (const auto load = arranged_.blocks.load_at.find(i); load != arranged_.blocks.load_at.end()) {
      enter_section(i);
      emit_load(load->second);
    }
    if (arranged_.places[i] == Place::nowhere || arranged_.places[i] == Place::loaded) return;
    if (s.op == Op::square_root) need(dialect_.square_root);
    if (s.op == Op::arc_tangent) need(dialect_.arc_tangent);
    if (arranged_.places[i] == Place::inside) return;
    if (arranged_.places[i] == Place::angle) {
      const AngleKey key = supplier(arranged_, s.a);
      const Angle& angle = arranged_.angles.at(key);
      const bool computed =
          key.kind != Operand::Kind::input && angle.first == static_cast<int>(i) && angles_done_.count(s.a.index) == 0;
      if (computed || (dialect_.stores && !arranged_.stores[i].empty())) enter_section(i);
      if (computed) emit_angle(key, angle);
    } else if (arranged_.places[i] != Place::summed) {
      enter_section(i);
      Line line = backend::line(arranged_, i);
      line.names = names_in_line(arranged_, i);
      add(std::move(line));
      if (arranged_.places[i] == Place::output) return;
    }
    if (!dialect_.stores || arranged_.stores[i].empty()) return;
    for (int lane = s.width > 1 ? 0 : -1; lane < (s.width > 1 ? s.width : 0); ++lane) {
      for (bool negative : {false, true}) {
        std::vector<Target> targets;
        for (const Store& store : arranged_.stores[i])
          if (store.negative == negative && store.lane == lane)
            targets.push_back({target(arranged_, store.output, store.element), store.output});
        const Operand value = {Operand::Kind::statement, static_cast<int>(i), negative, lane};
        store(targets, value);
      }
    }
  }

  // An element of an output.
  struct Target {
    std::string text;
    std::size_t output = 0;
  };

  // Equal elements at once, as many as a line holds.
  void store(const std::vector<Target>& targets, const Operand& value) {
    const Line empty{Line::Kind::store, {}, text(spell(arranged_, value))};
    Line line = empty;
    const auto put = [&] {
      for (const std::string& name : names_of(value)) line.names.push_back(name);
      add(std::exchange(line, empty));
    };
    for (const Target& target : targets) {
      line.targets.push_back(target.text);
      if (text(line).size() > dialect_.line_limit) {
        line.targets.pop_back();
        put();
        line.targets = {target.text};
      }
      line.names.push_back(output_parameter(arranged_, target.output).name);
    }
    if (!line.targets.empty()) put();
  }

  void list_results() {
    for (const symbolic::OutputArray& output : program_.outputs) {
      std::vector<std::string>& elements = kernel_.results.emplace_back();
      for (const Operand& o : output.values) elements.push_back(text(spell(arranged_, o)));
    }
  }

  // Elements that are inputs or constants: each value once, in the order of the elements.
  void emit_plain_outputs() {
    for (const Operand::Kind kind : {Operand::Kind::input, Operand::Kind::constant}) {
      std::vector<Operand> values;
      std::map<std::string, std::vector<Target>> targets;  // by the text of the value
      for (std::size_t p = 0; p < program_.outputs.size(); ++p) {
        for (std::size_t k = 0; k < program_.outputs[p].values.size(); ++k) {
          const Operand& o = program_.outputs[p].values[k];
          if (o.kind != kind || arranged_.is_in_block(p, k)) continue;
          std::vector<Target>& same = targets[text(spell(arranged_, o))];
          if (same.empty()) values.push_back(o);
          same.push_back({target(arranged_, p, k), p});
        }
      }
      if (values.empty()) continue;
      if (!kernel_.lines.empty())
        add({Line::Kind::section, {}, kind == Operand::Kind::input ? "elements that are inputs" : "constant elements"});
      for (const Operand& value : values) store(targets[text(spell(arranged_, value))], value);
    }
  }
};

}  // namespace

Dialect returning_dialect(std::size_t columns) {
  Dialect d;
  d.line_limit = columns - d.indentation;
  d.pairs_angles = false;
  d.stores = false;
  return d;
}

Kernel lower(const Program& program, const std::string& name, const Dialect& dialect) {
  return Emission(program, name, dialect).run();
}

std::vector<std::string> names_of(const std::vector<Parameter>& parameters) {
  std::vector<std::string> names;
  for (const Parameter& p : parameters) names.push_back(p.name);
  return names;
}

std::string text(const Line& line, const Dialect& dialect) {
  if (dialect.text) return dialect.text(line);
  const std::string head = line.kind == Line::Kind::store ? "" : dialect.definition;
  return head + joined(line.targets, dialect.assignment) + dialect.assignment + line.expression + dialect.end;
}

std::string body(const Kernel& kernel, const Dialect& dialect, std::string before) {
  for (const Line& line : kernel.lines) {
    if (line.kind == Line::Kind::section)
      before += (before.empty() ? "" : "\n") + dialect.section(line.expression);
    else
      before.append("  ").append(text(line, dialect)).append("\n");
  }
  return before;
}

}  // namespace robcogen::backend
