#include "symbolic/derivative.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "support/index.h"
#include "symbolic/cost.h"
#include "symbolic/partials.h"
#include "symbolic/rebuild.h"

namespace robcogen::symbolic {
namespace {

// A program rebuilt in a graph, to which its derivatives are added.
class Differentiated {
 public:
  explicit Differentiated(const Program& program) : Differentiated(program, program.inputs.size(), {}) {}

  // Adds further inputs in front of the input array `place`, but for those without elements.
  Differentiated(const Program& program, std::size_t place, const std::vector<InputArray>& added)
      : program_(program),
        added_(element_count(added)),
        rebuild_(
            graph_,
            program,
            [this](const Operand& o) {
              return o.kind == Operand::Kind::input ? std::optional(input(o.index)) : std::nullopt;
            }),
        inputs_(program.inputs),
        shapes_(program.outputs) {
    if (program.has_lanes()) throw std::logic_error("derivatives of a program with lanes");
    for (std::size_t k = 0; k < place; ++k) place_ += static_cast<int>(program.inputs[k].elements.size());
    for (const InputArray& array : added)
      if (!array.elements.empty()) inputs_.insert(inputs_.begin() + static_cast<std::ptrdiff_t>(place++), array);
    // Inputs that nothing reads have a derivative too.
    for (int element = 0; element < program.input_count() + added_; ++element) graph_.input(element);
    rebuild_.keep_all();
    outputs_ = rebuild_.outputs();
    size_ = graph_.nodes().size();
  }

  Graph& graph() { return graph_; }
  // The number of expressions beyond which nothing more is differentiated.
  std::size_t limit = std::numeric_limits<std::size_t>::max();
  bool is_full() const { return graph_.nodes().size() > limit; }

  const std::vector<Expression>& output(std::size_t k) const { return outputs_[k]; }
  const std::vector<Expression>& output(const std::string& name) const {
    const auto found =
        std::find_if(shapes_.begin(), shapes_.end(), [&](const OutputArray& array) { return array.name == name; });
    if (found == shapes_.end()) throw std::logic_error("the program has no output '" + name + "'");
    return outputs_[static_cast<std::size_t>(found - shapes_.begin())];
  }

  std::vector<Expression> input(const std::string& name) {
    int first = 0;
    for (const InputArray& array : program_.inputs) {
      const auto count = static_cast<int>(array.elements.size());
      std::vector<Expression> elements;
      for (int k = 0; array.name == name && k < count; ++k) elements.push_back(input(first + k));
      if (array.name == name) return elements;
      first += count;
    }
    throw std::logic_error("the program has no input '" + name + "'");
  }

  // The matrix of FollowerRates, column by column.
  std::vector<Expression> rates_of_followers(const Program& rates) {
    graph().begin_section("rates of joints that follow", "rates");
    std::vector<Expression> inputs;
    for (const InputArray& array : rates.inputs)
      for (const Expression& e : input(array.name)) inputs.push_back(e);
    return outputs_of(graph(), rates, inputs).front();
  }

  // The elements of all added inputs.
  std::vector<Expression> added() {
    std::vector<Expression> elements;
    for (int k = 0; k < added_; ++k) elements.push_back(graph_.input(place_ + k));
    return elements;
  }

  void add_output(const std::string& name, Role role, int rows, int columns, const std::vector<Expression>& values) {
    shapes_.push_back({name, role, rows, columns, {}});
    outputs_.push_back(values);
  }

  // The derivative of each node of the program by an input.
  std::vector<Expression> tangents(const Expression& by) { return tangents(std::vector<Rate>{{by, graph().one()}}); }

  // The rate of each node of the program when inputs change at these rates.
  std::vector<Expression> tangents(const std::vector<Rate>& changes) {
    std::vector<Expression> d(size_);
    for (const Rate& change : changes) d[at(change.of.node())] += change.rate;
    for (std::size_t i = 0; i < size_ && !is_full(); ++i) {
      const Node node = graph().nodes()[i];
      if (node.kind != Node::Kind::operation) continue;
      const Partials p = partials(graph(), i);
      const Expression of_a = is_zero(d, node.a) ? Expression() : p.a * d[at(node.a)];
      d[i] = node.b < 0 || is_zero(d, node.b) ? of_a : of_a + p.b() * d[at(node.b)];
    }
    return d;
  }

  // The derivative of the weighted sum of the results by each node of the program.
  std::vector<Expression> adjoints(const std::vector<Expression>& results, const std::vector<Expression>& weights) {
    std::vector<Expression> d(size_);
    for (std::size_t k = 0; k < results.size(); ++k)
      d[at(results[k].node())] += results[k].negative() ? -weights[k] : weights[k];
    for (std::size_t i = size_; i-- > 0 && !is_full();) {
      const Node node = graph().nodes()[i];
      if (node.kind != Node::Kind::operation || d[i].is_zero()) continue;
      const Partials p = partials(graph(), i);
      d[at(node.a)] += p.a * d[i];
      if (node.b >= 0) d[at(node.b)] += p.b() * d[i];
    }
    return d;
  }

  Program finish() const { return rebuild_.finish(inputs_, shapes_, outputs_); }

 private:
  const Program& program_;
  Graph graph_;
  int place_ = 0, added_ = 0;  // of the added inputs: the first element, the number of elements
  Rebuild rebuild_;
  std::vector<InputArray> inputs_;
  std::vector<OutputArray> shapes_;
  std::vector<std::vector<Expression>> outputs_;
  std::size_t size_ = 0;  // nodes of the program

  static int element_count(const std::vector<InputArray>& arrays) {
    std::size_t count = 0;
    for (const InputArray& array : arrays) count += array.elements.size();
    return static_cast<int>(count);
  }

  Expression input(int element) { return graph_.input(element < place_ ? element : element + added_); }
  static bool is_zero(const std::vector<Expression>& d, int node) { return d[at(node)].is_zero(); }
};

std::vector<Expression> signed_values(const std::vector<Expression>& by_node, const std::vector<Expression>& of) {
  std::vector<Expression> result;
  for (const Expression& e : of) {
    const Expression& d = by_node[at(e.node())];
    result.push_back(e.negative() ? -d : d);
  }
  return result;
}

// Derivatives by rotations in place of those by quaternion elements. A rotation by the small vector t (rad) takes the
// quaternion q to q (1, t / 2).
std::vector<Expression> by_turns(
    const InputArray& array,
    const std::vector<Expression>& q,
    const std::vector<Expression>& d) {
  std::vector<Expression> result;
  for (std::size_t k = 0; k < d.size(); ++k) {
    if (std::find(array.quaternions.begin(), array.quaternions.end(), static_cast<int>(k)) == array.quaternions.end()) {
      result.push_back(d[k]);
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t x = k + 1 + axis, y = k + 1 + (axis + 1) % 3, z = k + 1 + (axis + 2) % 3;
      const Expression first = q[k] * d[x] - q[x] * d[k];
      const Expression second = q[z] * d[y] - q[y] * d[z];
      result.push_back(0.5 * (first + second));
    }
    k += 3;
  }
  return result;
}

// The rates of the elements, from rates of rotations (rad/s) in place of those of quaternion elements.
std::vector<Expression> rates_from_turns(
    const InputArray& array,
    const std::vector<Expression>& q,
    const std::vector<Expression>& turns) {
  std::vector<Expression> result(q.size());
  std::size_t next = 0;
  for (std::size_t k = 0; k < q.size(); ++k) {
    if (std::find(array.quaternions.begin(), array.quaternions.end(), static_cast<int>(k)) == array.quaternions.end()) {
      result[k] = turns[next++];
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t x = k + 1 + axis, y = k + 1 + (axis + 1) % 3, z = k + 1 + (axis + 2) % 3;
      const Expression half = 0.5 * turns[next++];
      result[k] -= half * q[x];
      result[x] += half * q[k];
      result[y] += half * q[z];
      result[z] -= half * q[y];
    }
    k += 3;
  }
  return result;
}

const InputArray& array_of(const Program& program, const std::string& input) {
  return *std::find_if(
      program.inputs.begin(), program.inputs.end(), [&](const InputArray& array) { return array.name == input; });
}

}  // namespace

namespace {

// Derivatives of all results by one input array: a matrix for each output array, column by column.
using Blocks = std::vector<std::vector<Expression>>;

// Indices of outputs.
using Indices = std::vector<std::size_t>;

Blocks forward_blocks(Differentiated& d, const Indices& outputs, const std::vector<Expression>& variables) {
  Blocks blocks(outputs.size());
  for (const Expression& variable : variables) {
    const std::vector<Expression> tangents = d.tangents(variable);
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      const std::vector<Expression> column = signed_values(tangents, d.output(outputs[k]));
      blocks[k].insert(blocks[k].end(), column.begin(), column.end());
    }
  }
  return blocks;
}

Blocks reverse_blocks(Differentiated& d, const Indices& outputs, const std::vector<Expression>& variables) {
  Blocks blocks(outputs.size());
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const std::vector<Expression>& results = d.output(outputs[k]);
    blocks[k].resize(results.size() * variables.size());
    for (std::size_t r = 0; r < results.size(); ++r) {
      const std::vector<Expression> row = signed_values(d.adjoints({results[r]}, {d.graph().one()}), variables);
      for (std::size_t c = 0; c < row.size(); ++c) blocks[k][r + c * results.size()] = row[c];
    }
  }
  return blocks;
}

// Applies `change` to each row of a matrix that is stored column by column and has a column for each variable.
template <class Change>
std::vector<Expression> with_changed_rows(
    const std::vector<Expression>& columns,
    std::size_t variables,
    std::size_t kept,
    const Change& change) {
  const std::size_t rows = columns.size() / variables;
  std::vector<Expression> result(rows * kept);
  for (std::size_t r = 0; r < rows; ++r) {
    std::vector<Expression> row;
    for (std::size_t c = 0; c < variables; ++c) row.push_back(columns[r + c * rows]);
    const std::vector<Expression> changed = change(row);
    for (std::size_t c = 0; c < kept; ++c) result[r + c * rows] = changed[c];
  }
  return result;
}

// `by_turns` for each row of a matrix that is stored column by column.
std::vector<Expression> columns_by_turns(
    const InputArray& array,
    const std::vector<Expression>& q,
    const std::vector<Expression>& columns) {
  return with_changed_rows(
      columns, q.size(), q.size() - array.quaternions.size(),
      [&](const std::vector<Expression>& row) { return by_turns(array, q, row); });
}

// The derivatives by the elements of an input that do not follow others, from those by all elements (with rotations in
// place of quaternions). Both are matrices, column by column.
std::vector<Expression> with_followers(
    Differentiated& d,
    const InputArray& array,
    const FollowerRates& rates,
    const std::vector<Expression>& columns) {
  if (array.followers == 0) return columns;
  const std::size_t count = at(array.followers), all = array.elements.size() - array.quaternions.size();
  const std::size_t rows = columns.size() / all, kept = all - count;
  const std::vector<Expression> factors = d.rates_of_followers(rates.value());
  std::vector<Expression> result(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(rows * kept));
  for (std::size_t c = 0; c < kept; ++c)
    for (std::size_t f = 0; f < count; ++f)
      for (std::size_t r = 0; r < rows; ++r)
        result[r + c * rows] += factors[f + c * count] * columns[r + (kept + f) * rows];
  return result;
}

// The number of derivatives by an input.
std::size_t columns_by(const InputArray& array) {
  return array.elements.size() - array.quaternions.size() - at(array.followers);
}

// Derivatives by rotations of the base about its own axes, from those by gravity in base coordinates: the row D becomes
// D x gravity.
std::vector<Expression> by_rotation_of_base(const std::vector<Expression>& gravity, const std::vector<Expression>& d) {
  std::vector<Expression> result;
  for (std::size_t x = 0; x < 3; ++x) {
    const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
    result.push_back(d[y] * gravity[z] - d[z] * gravity[y]);
  }
  return result;
}

enum class Mode { forward, reverse };

Blocks blocks_by(Differentiated& d, const Indices& outputs, const std::vector<Expression>& variables, Mode mode) {
  return mode == Mode::forward ? forward_blocks(d, outputs, variables) : reverse_blocks(d, outputs, variables);
}

// The input for kBaseRotation.
const InputArray& orientation_by_which_base_turns(const Program& program) {
  const InputArray* orientation = orientation_of_base(program);
  if (orientation == nullptr) throw std::logic_error("the program does not know how the base is oriented");
  return *orientation;
}

// By kBaseRotation.
Blocks blocks_by_rotation(Differentiated& d, const Program& program, const Indices& outputs, Mode mode) {
  const InputArray& orientation = orientation_by_which_base_turns(program);
  const bool is_pose = orientation.role == Role::base_pose;
  std::vector<Expression> variables = d.input(orientation.name);
  variables.resize(is_pose ? 4 : 3);
  Blocks columns = blocks_by(d, outputs, variables, mode);
  for (std::vector<Expression>& block : columns)
    block = with_changed_rows(block, variables.size(), 3, [&](const std::vector<Expression>& row) {
      return is_pose ? by_turns(orientation, variables, row) : by_rotation_of_base(variables, row);
    });
  return columns;
}

// nullopt if it takes more than `most` expressions.
std::optional<Program> differentiated(
    const Program& program,
    const std::vector<std::string>& inputs,
    Mode mode,
    std::size_t most,
    const FollowerRates& rates) {
  Differentiated d(program);
  d.limit = most;
  Indices all;
  for (std::size_t k = 0; k < program.outputs.size(); ++k) all.push_back(k);
  for (const std::string& input : inputs) {
    d.graph().begin_section("derivatives by " + input, "d_" + input);
    Blocks columns;
    std::size_t count = 3;
    if (input == kBaseRotation) {
      columns = blocks_by_rotation(d, program, all, mode);
    } else {
      const InputArray& array = array_of(program, input);
      const std::vector<Expression> variables = d.input(input);
      columns = blocks_by(d, all, variables, mode);
      count = columns_by(array);
      if (!d.is_full()) {
        for (std::vector<Expression>& block : columns) {
          if (!array.quaternions.empty()) block = columns_by_turns(array, variables, block);
          block = with_followers(d, array, rates, block);
        }
      }
    }
    if (d.is_full()) return std::nullopt;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const OutputArray& of = program.outputs[k];
      d.add_output(
          name_of_block(program.outputs.size(), of.name, input), Role::matrix, of.rows * of.columns,
          static_cast<int>(count), columns[k]);
    }
  }
  return d.finish();
}

}  // namespace

const InputArray* orientation_of_base(const Program& program) {
  const auto place = std::find_if(program.inputs.begin(), program.inputs.end(), [](const InputArray& array) {
    return array.role == Role::gravity || array.role == Role::base_pose;
  });
  return place == program.inputs.end() ? nullptr : &*place;
}

Program with_derivatives(const Program& program, const std::vector<std::string>& inputs) {
  return *differentiated(program, inputs, Mode::forward, std::numeric_limits<std::size_t>::max(), {});
}

std::optional<Program> with_derivatives(
    const Program& program,
    const std::vector<std::string>& inputs,
    DerivativeMode mode,
    std::size_t most,
    const FollowerRates& rates) {
  std::optional<Program> forward = differentiated(program, inputs, Mode::forward, most, rates);
  if (forward && mode == DerivativeMode::forward) return forward;
  std::optional<Program> reverse = differentiated(program, inputs, Mode::reverse, most, rates);
  if (!forward || !reverse) return forward ? std::move(forward) : std::move(reverse);
  return work(*reverse) < work(*forward) ? std::move(reverse) : std::move(forward);
}

namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

std::size_t place_of_output(const Program& program, const std::string& name) {
  std::size_t k = 0;
  while (k < program.outputs.size() && program.outputs[k].name != name) ++k;
  if (k == program.outputs.size()) throw std::logic_error("the program has no output '" + name + "'");
  return k;
}

// Copies the elements below the diagonal to those above, which then need not be computed.
void make_symmetric(std::vector<Expression>& block, std::size_t size) {
  for (std::size_t r = 0; r < size; ++r)
    for (std::size_t c = r + 1; c < size; ++c) block[r + c * size] = block[c + r * size];
}

Program second_derivatives(const Program& gradient, const Pairs& pairs, Mode mode, const FollowerRates& rates) {
  Differentiated d(gradient);
  for (const auto& [of, by] : pairs) {
    const std::vector<Expression> variables = d.input(by);
    d.graph().begin_section("derivatives of the gradient by " + of + " and " + by, "d_" + of + "_" + by);
    std::vector<Expression> block = blocks_by(d, {place_of_output(gradient, "d_" + of)}, variables, mode).front();
    const InputArray& array = array_of(gradient, by);
    const std::size_t rows = variables.empty() ? 0 : block.size() / variables.size();
    const std::size_t columns = columns_by(array);
    if (!array.quaternions.empty()) block = columns_by_turns(array, variables, block);
    block = with_followers(d, array, rates, block);
    // With quaternions the matrix is not symmetric, because rotations about two axes do not commute.
    if (array.quaternions.empty() && of == by) make_symmetric(block, columns);
    d.add_output("d_" + of + "_" + by, Role::matrix, static_cast<int>(rows), static_cast<int>(columns), block);
  }
  return d.finish();
}

}  // namespace

Program with_second_derivatives(
    const Program& gradient,
    const Pairs& pairs,
    DerivativeMode mode,
    const FollowerRates& rates) {
  Program forward = second_derivatives(gradient, pairs, Mode::forward, rates);
  if (mode == DerivativeMode::forward) return forward;
  Program reverse = second_derivatives(gradient, pairs, Mode::reverse, rates);
  return work(reverse) < work(forward) ? std::move(reverse) : std::move(forward);
}

namespace {

InputArray array_of_weights(const Program& program, const WeightedOutputs& weights) {
  InputArray result{weights.name, Role::value, {}};
  for (const std::string& name : weights.outputs) {
    const std::size_t count = program.outputs[place_of_output(program, name)].values.size();
    for (std::size_t k = 0; k < count; ++k) result.elements.push_back(name + "_" + std::to_string(k));
  }
  return result;
}

// The gradient by an input, from the adjoints of its elements.
std::vector<Expression> gradient_by(
    Differentiated& d,
    const Program& program,
    const std::string& input,
    const std::vector<Expression>& adjoints,
    const FollowerRates& rates) {
  if (input != kBaseRotation) {
    const std::vector<Expression> variables = d.input(input);
    const InputArray& array = array_of(program, input);
    return with_followers(d, array, rates, by_turns(array, variables, signed_values(adjoints, variables)));
  }
  const InputArray& orientation = orientation_by_which_base_turns(program);
  std::vector<Expression> variables = d.input(orientation.name);
  if (orientation.role != Role::base_pose) return by_rotation_of_base(variables, signed_values(adjoints, variables));
  variables.resize(4);
  return by_turns(orientation, variables, signed_values(adjoints, variables));
}

// The rates of all elements of an input, from those that with_tangents adds.
std::vector<Rate> rates_of_input(
    Differentiated& d,
    const Program& program,
    const std::string& input,
    std::vector<Expression> given,
    const FollowerRates& rates) {
  const bool is_rotation = input == kBaseRotation;
  const InputArray& array = is_rotation ? orientation_by_which_base_turns(program) : array_of(program, input);
  std::vector<Expression> variables = d.input(array.name), of_elements;
  if (is_rotation && array.role == Role::gravity) {
    for (std::size_t x = 0; x < 3; ++x) {  // gravity x turn
      const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
      of_elements.push_back(variables[y] * given[z] - variables[z] * given[y]);
    }
  } else {
    if (is_rotation) variables.resize(4);
    if (!is_rotation && array.followers > 0) {
      const std::size_t kept = given.size(), count = at(array.followers);
      const std::vector<Expression> factors = d.rates_of_followers(rates.value());
      for (std::size_t f = 0; f < count; ++f) {
        Expression rate;
        for (std::size_t c = 0; c < kept; ++c) rate += factors[f + c * count] * given[c];
        given.push_back(rate);
      }
    }
    of_elements = rates_from_turns(array, variables, given);
  }
  std::vector<Rate> result;
  for (std::size_t k = 0; k < variables.size(); ++k) result.push_back({variables[k], of_elements[k]});
  return result;
}

}  // namespace

std::size_t place_of_loads(const Program& program) {
  const auto place = std::find_if(program.inputs.begin(), program.inputs.end(), [](const InputArray& array) {
    return array.role == Role::gravity || array.role == Role::link_wrenches;
  });
  return static_cast<std::size_t>(place - program.inputs.begin());
}

std::vector<WeightedOutputs> weights_of_outputs(const Program& program) {
  if (program.outputs.size() == 1) return {{"weights", {program.outputs.front().name}}};
  std::vector<WeightedOutputs> result;
  for (const OutputArray& array : program.outputs) result.push_back({array.name + "_weights", {array.name}});
  return result;
}

Program with_gradient(
    const Program& program,
    const std::vector<WeightedOutputs>& weights,
    const std::vector<std::string>& inputs,
    std::size_t place,
    const FollowerRates& rates) {
  std::vector<InputArray> arrays;
  for (const WeightedOutputs& of : weights) arrays.push_back(array_of_weights(program, of));
  Differentiated d(program, place, arrays);
  std::vector<Expression> results;
  for (const WeightedOutputs& of : weights) {
    for (const std::string& name : of.outputs) {
      const std::vector<Expression>& values = d.output(name);
      results.insert(results.end(), values.begin(), values.end());
    }
  }
  d.graph().begin_section("gradient", "gradient");
  const std::vector<Expression> adjoints = d.adjoints(results, d.added());
  for (const std::string& input : inputs) {
    const std::vector<Expression> gradient = gradient_by(d, program, input, adjoints, rates);
    d.add_output(name_of_gradient(input), Role::value, static_cast<int>(gradient.size()), 1, gradient);
  }
  return d.finish();
}

std::string name_of_tangent(const std::string& array) {
  return array + "_tangent";
}

std::string name_of_gradient(const std::string& input) {
  return "d_" + input;
}

std::string name_of_block(std::size_t results, const std::string& of, const std::string& input) {
  const std::string name = name_of_gradient(input);
  return results == 1 && of != name ? name : of + "_" + name;
}

Program with_tangents(
    const Program& program,
    const std::vector<std::string>& inputs,
    std::size_t place,
    const FollowerRates& rates) {
  std::vector<InputArray> arrays;
  for (const std::string& input : inputs) {
    InputArray rate{name_of_tangent(input), Role::value, {}};
    const std::size_t count = input == kBaseRotation ? 3 : columns_by(array_of(program, input));
    for (std::size_t k = 0; k < count; ++k) rate.elements.push_back(rate.name + "_" + std::to_string(k));
    arrays.push_back(std::move(rate));
  }
  Differentiated d(program, place, arrays);
  d.graph().begin_section("tangent", "tangent");
  const std::vector<Expression> given = d.added();
  std::vector<Rate> changes;
  auto next = given.begin();
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const auto end = next + static_cast<std::ptrdiff_t>(arrays[k].elements.size());
    const std::vector<Rate> of = rates_of_input(d, program, inputs[k], {next, end}, rates);
    changes.insert(changes.end(), of.begin(), of.end());
    next = end;
  }
  const std::vector<Expression> tangents = d.tangents(changes);
  for (std::size_t k = 0; k < program.outputs.size(); ++k) {
    const OutputArray& of = program.outputs[k];
    d.add_output(
        name_of_tangent(of.name), of.columns == 1 ? Role::value : Role::matrix, of.rows, of.columns,
        signed_values(tangents, d.output(k)));
  }
  return d.finish();
}

}  // namespace robcogen::symbolic
