#include "backend/common/lower.h"

#include <utility>

#include "backend/common/angle_lines.h"
#include "backend/common/arc_tangent_lines.h"
#include "backend/common/arrangement.h"
#include "backend/common/kernel_lines.h"
#include "backend/common/store_lines.h"
#include "support/concat.h"
#include "support/index.h"

namespace robcogen::backend {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;

// Writes the lines of all statements in order, each with the loads, angles and stores that belong to it.
class Emission {
 public:
  explicit Emission(KernelLines& lines)
      : lines_(lines), arranged_(lines.arranged()), dialect_(lines.dialect()), angles_(lines), stores_(lines) {}

  void run() {
    stores_.add_fills();
    angles_.add_those_of_inputs();
    for (std::size_t i = 0; i < arranged_.program.statements.size(); ++i) emit(i);
    if (dialect_.stores) stores_.add_those_of_inputs();
  }

 private:
  KernelLines& lines_;
  Arrangement& arranged_;
  const Dialect& dialect_;
  AngleLines angles_;
  StoreLines stores_;

  void emit(std::size_t i) {
    emit_value(i);
    const auto [first, last] = arranged_.blocks.store_after.equal_range(i);
    for (auto block = first; block != last; ++block) stores_.add_block(arranged_.blocks.stores.blocks[block->second]);
  }

  void emit_value(std::size_t i) {
    const Op op = arranged_.program.statements[i].op;
    const Place place = arranged_.places[i];
    if (const auto load = arranged_.blocks.load_at.find(i); load != arranged_.blocks.load_at.end()) {
      lines_.enter_section(i);
      emit_load(load->second);
    }
    if (place == Place::nowhere || place == Place::loaded) return;
    if (op == Op::square_root)
      lines_.need(square_of_magnitude(arranged_, i) ? dialect_.magnitude : dialect_.square_root);
    if (op == Op::arc_tangent) lines_.need(dialect_.arc_tangent);
    if (place == Place::inside) return;
    if (place == Place::angle) {
      emit_angle(i);
    } else if (place != Place::summed) {
      lines_.enter_section(i);
      Line line = backend::line(arranged_, i);
      line.names = names_in_line(arranged_, i);
      if (op == Op::arc_tangent && place == Place::output) describe_angle(i, line);
      lines_.add(std::move(line));
      if (place == Place::output) return;
    }
    if (dialect_.stores) stores_.add_those_of(i);
  }

  // Of an angle that is stored. The opposite angle has the opposite sine.
  void describe_angle(std::size_t i, Line& line) {
    const symbolic::Statement& s = arranged_.program.statements[i];
    const Store& store = arranged_.stores[i].front();
    Spelling sine = spell(arranged_, s.a);
    if (arranged_.expressions[i].negative != store.negative) sine.negative = !sine.negative;
    line.values = {backend::text(sine), lines_.text_of(s.b)};
    line.output = store.output;
    line.element = store.element;
  }

  void emit_load(std::size_t k) {
    const symbolic::Block& block = arranged_.blocks.loads[k];
    const KernelArray& input = arranged_.parameters[at(block.array)];
    Line line{
        Line::Kind::load_block,
        {arranged_.load_names[k]},
        dialect_.element(input.name, at(block.first)),
        block.columns.size()};
    line.width = block.width;
    line.stride = block.stride;
    line.names = {input.name};
    lines_.add(std::move(line));
    angles_.add_those_of_load(k);
  }

  // Defines the sine or cosine, together with the other one of the pair, if this statement is the first to need either.
  void emit_angle(std::size_t i) {
    const Operand& argument = arranged_.program.statements[i].a;
    const AngleKey key = supplier(arranged_, argument);
    const Angle& angle = arranged_.angles.at(key);
    const bool computed =
        key.kind != Operand::Kind::input && angle.first == static_cast<int>(i) && !angles_.are_done(argument.index);
    if (computed || (dialect_.stores && !arranged_.stores[i].empty())) lines_.enter_section(i);
    if (computed) angles_.add(key, angle);
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
  Arrangement arranged = arrange(program, dialect);
  KernelLines lines(arranged, name);
  Emission(lines).run();
  return with_arc_tangents_together(lines.kernel(), dialect);
}

std::vector<std::string> names_of(const std::vector<KernelArray>& parameters) {
  std::vector<std::string> names;
  for (const KernelArray& p : parameters) names.push_back(p.name);
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
