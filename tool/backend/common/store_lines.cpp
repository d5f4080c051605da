#include "backend/common/store_lines.h"

#include <map>
#include <utility>

#include "support/index.h"

namespace robcogen::backend {

using symbolic::Operand;

void StoreLines::add_fills() {
  Arrangement& arranged = lines_.arranged();
  for (const symbolic::Fill& fill : arranged.blocks.stores.fills) {
    Line line{Line::Kind::fill, {}, lines_.text_of(fill.value), at(fill.count)};
    line.targets = {target(arranged, at(fill.array), at(fill.first))};
    line.names = {output_parameter(arranged, at(fill.array)).name};
    lines_.add(std::move(line));
  }
}

void StoreLines::add_block(const symbolic::Block& block) {
  Arrangement& arranged = lines_.arranged();
  Line line{Line::Kind::store_block, {}, "", block.columns.size(), block.width, block.stride};
  line.targets = {target(arranged, at(block.array), at(block.first))};
  line.names = {output_parameter(arranged, at(block.array)).name};
  for (const Operand& o : block.columns) {
    line.values.push_back(text(spell(arranged, o, block.width)));
    add_names(arranged, o, block.width, line.names);
  }
  lines_.add(std::move(line));
}

void StoreLines::add_those_of(std::size_t statement) {
  const std::vector<Store>& stores = lines_.arranged().stores[statement];
  if (stores.empty()) return;
  const int width = lines_.program().statements[statement].width;
  for (int lane = width > 1 ? 0 : -1; lane < (width > 1 ? width : 0); ++lane) {
    for (const bool negative : {false, true}) {
      std::vector<Target> targets;
      for (const Store& s : stores)
        if (s.negative == negative && s.lane == lane) targets.push_back(target_of(s.output, s.element));
      store(targets, {Operand::Kind::statement, static_cast<int>(statement), negative, lane});
    }
  }
}

void StoreLines::add_those_of_inputs() {
  const std::vector<symbolic::OutputArray>& outputs = lines_.program().outputs;
  for (const Operand::Kind kind : {Operand::Kind::input, Operand::Kind::constant}) {
    std::vector<Operand> values;
    std::map<std::string, std::vector<Target>> targets;  // by the text of the value
    for (std::size_t p = 0; p < outputs.size(); ++p) {
      for (std::size_t k = 0; k < outputs[p].values.size(); ++k) {
        const Operand& o = outputs[p].values[k];
        if (o.kind != kind || lines_.arranged().is_in_block(p, k)) continue;
        std::vector<Target>& same = targets[lines_.text_of(o)];
        if (same.empty()) values.push_back(o);
        same.push_back(target_of(p, k));
      }
    }
    if (values.empty()) continue;
    if (!lines_.empty())
      lines_.add_section(kind == Operand::Kind::input ? "elements equal to inputs" : "constant elements");
    for (const Operand& value : values) store(targets[lines_.text_of(value)], value);
  }
}

StoreLines::Target StoreLines::target_of(std::size_t output, std::size_t element) const {
  return {target(lines_.arranged(), output, element), output};
}

// Stores equal elements at once, as many as fit in a line.
void StoreLines::store(const std::vector<Target>& targets, const Operand& value) {
  const Dialect& dialect = lines_.dialect();
  const Line empty{Line::Kind::store, {}, lines_.text_of(value)};
  Line line = empty;
  const auto put = [&] {
    for (const std::string& name : lines_.names_of(value)) line.names.push_back(name);
    lines_.add(std::exchange(line, empty));
  };
  for (const Target& target : targets) {
    line.targets.push_back(target.text);
    if (text(line, dialect).size() > dialect.line_limit) {
      line.targets.pop_back();
      put();
      line.targets = {target.text};
    }
    line.names.push_back(output_parameter(lines_.arranged(), target.output).name);
  }
  if (!line.targets.empty()) put();
}

}  // namespace robcogen::backend
