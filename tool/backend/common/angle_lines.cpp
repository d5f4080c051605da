#include "backend/common/angle_lines.h"

#include <utility>
#include <vector>

#include "support/index.h"

namespace robcogen::backend {

using symbolic::Operand;

namespace {

// Whether this is an element of reference positions of the joints.
bool is_reference(const symbolic::Program& program, const Operand& o) {
  if (o.kind != Operand::Kind::input) return false;
  std::size_t end = 0;
  for (const symbolic::InputArray& array : program.inputs) {
    end += array.elements.size();
    if (at(o.index) < end) return array.role == symbolic::Role::joint_reference;
  }
  return false;
}

}  // namespace

void AngleLines::add_those_of_inputs() {
  Arrangement& arranged = lines_.arranged();
  const bool are_together = arranged.together > 0;
  const std::size_t first = at(arranged.first_together);
  const std::string all = are_together ? arranged.scope.claim("trig") : "";
  if (are_together)
    compute_together(all, arranged.input_names[first], arranged.input_sources[first], arranged.together, 1);
  for (const auto& [key, angle] : arranged.angles) {
    if (key.kind != Operand::Kind::input) continue;
    if (are_together) {
      pick(angle, all, at(key.index) - first, 1);
    } else {
      add(key, angle);
    }
  }
}

void AngleLines::add_those_of_load(std::size_t load) {
  Arrangement& arranged = lines_.arranged();
  const symbolic::Block& block = arranged.blocks.loads[load];
  if (block.width != 2 || lines_.dialect().angles_together == 0) return;
  std::vector<std::pair<std::size_t, const Angle*>> angles;
  for (std::size_t c = 0; c < block.columns.size(); ++c) {
    const auto angle = arranged.angles.find({Operand::Kind::statement, block.columns[c].index});
    if (angle != arranged.angles.end()) angles.emplace_back(c, &angle->second);
  }
  if (angles.size() < 2 || block.columns.size() > 2 * angles.size()) return;
  const std::string all = arranged.scope.claim("trig");
  const std::string& name = arranged.load_names[load];
  compute_together(all, lines_.dialect().element(name, 0), name, block.columns.size(), block.width);
  for (const auto& [column, angle] : angles) {
    pick(*angle, all, column, block.width);
    done_.insert(block.columns[column].index);
  }
}

void AngleLines::add(const AngleKey& key, const Angle& angle) {
  const Dialect& dialect = lines_.dialect();
  const Operand operand{key.kind, key.index, false, key.lane};
  if (angle.sine && angle.cosine && dialect.pairs_angles) {
    Line line{Line::Kind::sincos, {angle.sine_name, angle.cosine_name}, lines_.text_of(operand)};
    line.width = width_of(lines_.program(), operand);
    line.is_reference = is_reference(lines_.program(), operand);
    line.names = lines_.names_of(operand);
    lines_.add(std::move(line));
    return;
  }
  if (angle.sine) define(dialect.sine, operand, angle.sine_name);
  if (angle.cosine) define(dialect.cosine, operand, angle.cosine_name);
}

void AngleLines::define(const std::string& function, const Operand& argument, const std::string& name) {
  lines_.need(function);
  Line line{Line::Kind::definition, {name}, function + "(" + lines_.text_of(argument) + ")"};
  line.names = lines_.names_of(argument);
  line.names.push_back(function);
  lines_.add(std::move(line));
}

// Computes the sines and cosines of `count` values, the first of which is an element of `array`.
void AngleLines::compute_together(
    const std::string& all,
    const std::string& first,
    const std::string& array,
    std::size_t count,
    int width) {
  Line line{Line::Kind::sincos_of, {all}, first, count, width};
  line.names = {array};
  lines_.add(std::move(line));
}

// Names the sine and cosine of one of these values, number k.
void AngleLines::pick(const Angle& angle, const std::string& all, std::size_t k, int width) {
  Line line{Line::Kind::pick, {angle.sine_name, angle.cosine_name}, lines_.dialect().element(all, k), 0, width};
  line.names = {all};
  lines_.add(std::move(line));
}

}  // namespace robcogen::backend
