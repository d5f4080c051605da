#include "symbolic/line_names.h"

#include <map>
#include <optional>

#include "support/index.h"
#include "support/unique_names.h"
#include "symbolic/lane_names.h"

namespace robcogen::symbolic {
namespace {

// Longer names make lines that are hard to read.
constexpr std::size_t kLongest = 28;

// A value under a name that does not tell its sign.
struct Called {
  std::string name;  // empty: nothing is known of it
  bool negative = false;
};

Called called(const std::string& name) {
  const std::string plain = without_sign(name);
  return {plain, plain.size() < name.size()};
}

std::string text(const Called& c) {
  return c.name + (c.negative ? "_neg" : "");
}

// `hip_wx` as link and quantity.
struct Parts {
  std::string subject, quantity;
};

Parts parts_of(const std::string& name) {
  const std::size_t border = name.rfind('_');
  if (border == std::string::npos) return {"", name};
  return {name.substr(0, border), name.substr(border + 1)};
}

// What elements of such an array are called: `qd_HFE`.
std::string prefix_of(const InputArray& array) {
  if (array.role == Role::base_velocity) return "base_";
  const bool is_labelled = array.role == Role::joint_sine || array.role == Role::joint_cosine ||
                           array.role == Role::parameters || array.role == Role::variables;
  return is_labelled ? "" : array.name + "_";
}

class LineNamer {
 public:
  LineNamer(const Program& p, const std::vector<bool>& is_line)
      : p_(p), is_line_(is_line), known_(p.statements.size()) {
    for (const InputArray& array : p.inputs)
      for (const std::string& label : array.elements) inputs_.push_back(prefix_of(array) + label);
  }

  std::vector<std::string> run() {
    UniqueNames given;
    for (const Statement& s : p_.statements)
      if (has_meaning(s)) given.reserve(s.name);
    for (std::size_t i = 0; i < known_.size(); ++i) {
      const Statement& s = p_.statements[i];
      known_[i] = has_meaning(s) ? called(s.name) : composed(s);
      if (!has_meaning(s) && given.contains(text(known_[i]))) known_[i] = {};  // it is something else
    }
    name_parts();
    return distinct();
  }

 private:
  const Program& p_;
  const std::vector<bool>& is_line_;
  std::vector<Called> known_;                 // by statement
  std::vector<std::string> inputs_;           // by flat index
  std::map<std::size_t, std::string> parts_;  // by statement: names as a part of another value

  const Statement* statement(const Operand& o) const { return is_statement(o) ? &p_.statements[at(o.index)] : nullptr; }

  bool is_number(const Operand& o, double value) const {
    return is_constant(o) && p_.constants[at(o.index)].value() == value;
  }

  Called of(const Operand& o) const {
    Called result;
    if (o.kind == Operand::Kind::input) result.name = inputs_[at(o.index)];
    if (is_statement(o)) result = known_[at(o.index)];
    if (o.lane >= 0 && !result.name.empty()) result.name += "_" + std::to_string(o.lane);
    result.negative = result.negative != o.negative;
    return result;
  }

  // From the names of its operands.
  Called composed(const Statement& s) const {
    Called result;
    switch (s.op) {
      case Op::sine:
      case Op::cosine:
        result = angle(s);
        break;
      case Op::multiply:
        result = product(s);
        break;
      case Op::add:
      case Op::subtract:
        result = sum(s);
        break;
      case Op::divide:
        if (is_number(s.a, 1.0) && !s.a.negative) result = of(s.b), result.name += result.name.empty() ? "" : "_inv";
        break;
      case Op::square_root:
        result = {of(s.a).name, false};
        if (!result.name.empty()) result.name += "_root";
        break;
      case Op::arc_tangent:
        break;
      case Op::sum_lanes:
        result = of(s.a);
        if (!result.name.empty()) result.name += "_sum";
        break;
      case Op::gather:
        result = gathered(s);
        break;
    }
    return result.name.size() > kLongest ? Called() : result;
  }

  // What lanes have in common; numbers have no name.
  Called gathered(const Statement& s) const {
    std::vector<std::string> names;
    bool negative = true;
    for (const Operand& o : s.lanes) {
      const Called lane = of(o);
      if (lane.name.empty()) return {};
      names.push_back(lane.name);
      negative = negative && lane.negative;
    }
    const std::string name = common_name(names);
    return name.starts_with("lanes") ? Called() : Called{name, negative};
  }

  Called angle(const Statement& s) const {
    const Called argument = of(s.a);
    if (argument.name.empty()) return {};
    const std::string label = argument.name.starts_with("q_") ? argument.name.substr(2) : argument.name;
    return {(s.op == Op::sine ? "s_" : "c_") + label, s.op == Op::sine && argument.negative};
  }

  Called product(const Statement& s) const {
    Called a = of(s.a), b = of(s.b);
    // 2 sin cos.
    for (const auto& [number, value] : {std::pair(s.a, b), std::pair(s.b, a)})
      if (is_number(number, 2.0) && value.name.starts_with("sc_"))
        return {"s_2" + value.name.substr(3), value.negative != number.negative};
    if (a.name.empty() || b.name.empty()) return {};
    const bool negative = a.negative != b.negative;
    const bool a_is_sine = a.name.starts_with("s_"), a_is_cosine = a.name.starts_with("c_");
    if (a.name == b.name) {
      if (a_is_sine || a_is_cosine) return {a.name.substr(0, 1) + "2" + a.name.substr(1), negative};
      return {a.name + "2", negative};
    }
    const bool b_is_sine = b.name.starts_with("s_"), b_is_cosine = b.name.starts_with("c_");
    const bool are_both = (a_is_sine && b_is_cosine) || (a_is_cosine && b_is_sine);
    if (are_both && a.name.substr(1) == b.name.substr(1)) return {"sc" + a.name.substr(1), negative};
    if (a_is_cosine && b_is_sine) std::swap(a, b);
    return {joined(a.name, "_", b.name), negative};
  }

  // `hip_wx_wy` of two quantities of one link.
  static std::string joined(const std::string& a, const std::string& word, const std::string& b) {
    const Parts x = parts_of(a), y = parts_of(b);
    return x.subject == y.subject && !x.subject.empty() ? a + word + y.quantity : a + word + b;
  }

  Called sum(const Statement& s) const {
    const bool subtracts = s.op == Op::subtract;
    // 1 - 2 sin^2.
    if (const Statement* b = statement(s.b); b && subtracts && is_number(s.a, 1.0) && b->op == Op::multiply) {
      for (const auto& [number, value] : {std::pair(b->a, b->b), std::pair(b->b, b->a)})
        if (is_number(number, 2.0) && of(value).name.starts_with("s2_"))
          return {"c_2" + of(value).name.substr(3), false};
    }
    if (const Called turned = component_of_turned(s); !turned.name.empty()) return turned;
    const Called a = of(s.a);
    Called b = of(s.b);
    b.negative = b.negative != subtracts;
    if (const Called moved = moved_value(s, a, b); !moved.name.empty()) return moved;
    if (a.name.empty() || b.name.empty()) return {};
    if (const auto u = element_of_U(a, b)) return *u;
    const Parts x = parts_of(a.name), y = parts_of(b.name);
    if (x.subject.empty() || x.subject != y.subject) return {};
    // The positive term first.
    const bool swaps = a.negative && !b.negative;
    const bool differ = a.negative != b.negative;
    const std::string& first = swaps ? b.name : a.name;
    const std::string& second = swaps ? a.name : b.name;
    return {joined(first, differ ? "_minus_" : "_plus_", second), a.negative && b.negative};
  }

  // The factor beside a sine or a cosine of an angle, which `angle` receives: `s_KFE`.
  Operand beside_angle(const Operand& term, std::string& angle) const {
    const Statement* product = statement(term);
    if (!product || product->op != Op::multiply || term.lane >= 0) return {};
    for (const auto& [function, value] : {std::pair(product->a, product->b), std::pair(product->b, product->a)}) {
      const std::string name = of(function).name;
      if (!name.starts_with("s_") && !name.starts_with("c_")) continue;
      angle = name;
      Operand result = value;
      result.negative = (result.negative != function.negative) != term.negative;
      return result;
    }
    return {};
  }

  // c x - s y, s x + c y: a component of a vector that an angle turns, the one that its cosine multiplies.
  Called component_of_turned(const Statement& s) const {
    std::string of_a, of_b;
    Operand a = beside_angle(s.a, of_a), b = beside_angle(s.b, of_b);
    if (of_a.empty() || of_b.empty() || of_a.substr(1) != of_b.substr(1) || of_a == of_b) return {};
    b.negative = b.negative != (s.op == Op::subtract);
    const Called along = of(of_a.front() == 'c' ? a : b);
    if (along.name.empty()) return {};
    return {along.name + "_by" + of_a.substr(1), along.negative};
  }

  // A quantity and a multiple of another one of the same link: the same quantity about another point.
  Called moved_value(const Statement& s, const Called& a, const Called& b) const {
    for (const auto& [kept, other] : {std::pair(a, s.b), std::pair(b, s.a)}) {
      const Statement* product = statement(other);
      if (kept.name.empty() || !product || product->op != Op::multiply || has_meaning(*product)) continue;
      for (const auto& [number, value] : {std::pair(product->a, product->b), std::pair(product->b, product->a)}) {
        if (!is_constant(number)) continue;
        const Parts x = parts_of(kept.name), y = parts_of(of(value).name);
        if (!x.subject.empty() && x.subject == y.subject && x.quantity.front() != 't')
          return {kept.name + "_moved", kept.negative};
      }
    }
    return {};
  }

  // w_r w_c -+ wd, or minus the squares of two.
  static std::optional<Called> element_of_U(const Called& a, const Called& b) {
    for (const auto& [rate, product] : {std::pair(a, b), std::pair(b, a)}) {
      const Parts d = parts_of(rate.name);
      if (d.quantity.size() != 3 || !d.quantity.starts_with("wd")) continue;
      const char axis = d.quantity[2];
      const std::string axes = "xyz";
      const std::size_t k = axes.find(axis);
      if (k == std::string::npos) continue;
      const char i = axes[(k + 1) % 3], j = axes[(k + 2) % 3];
      const std::string stem = d.subject + "_w";
      const bool is_product = product.name == stem + i + "_w" + j || product.name == stem + j + "_w" + i;
      if (!is_product) continue;
      const bool same = rate.negative == product.negative;
      return Called{d.subject + "_U" + (same ? std::string{j, i} : std::string{i, j}), product.negative};
    }
    const auto axis_of_square = [](const std::string& quantity) {
      return quantity.size() == 3 && quantity[0] == 'w' && quantity[2] == '2' ? quantity[1] : '\0';
    };
    const Parts x = parts_of(a.name), y = parts_of(b.name);
    const char i = axis_of_square(x.quantity), j = axis_of_square(y.quantity);
    const auto is_axis = [](char c) { return c >= 'x' && c <= 'z'; };
    if (!is_axis(i) || !is_axis(j) || i == j || x.subject != y.subject || a.negative != b.negative) return std::nullopt;
    const char rest = static_cast<char>('x' + 'y' + 'z' - i - j);
    return Called{x.subject + "_U" + rest + rest, !a.negative};
  }

  // What is still without a name is a part of what the statement that reads it first is a part of.
  void name_parts() {
    std::vector<int> reader(known_.size(), -1);
    for (std::size_t i = known_.size(); i-- > 0;)
      for_each_operand(p_.statements[i], [&](const Operand& o) {
        if (is_statement(o)) reader[at(o.index)] = static_cast<int>(i);
      });
    std::vector<std::string> whole(known_.size());
    for (std::size_t i = known_.size(); i-- > 0;) {
      if (!known_[i].name.empty()) {
        whole[i] = known_[i].name;
        continue;
      }
      if (reader[i] < 0) continue;
      whole[i] = whole[at(reader[i])];
      if (whole[i].empty() || !is_line_[i]) continue;
      const std::string word = part_of_whole(p_.statements[i]);
      if (whole[i].size() + word.size() <= kLongest + 4) parts_.insert({i, whole[i] + word});
    }
  }

  // The running sum up to a term, a term of a quantity: `_to_az`, `_of_az`.
  std::string part_of_whole(const Statement& s) const {
    if (s.op == Op::gather) return "_lanes";
    const auto quantity = [&](const Operand& o) {
      std::string name = of(o).name;
      return name.empty() ? name : parts_of(name).quantity;
    };
    const auto of_product = [&](const Statement& product) {
      // Beside a sine or a cosine, and what is turned rather than that.
      for (const Operand& o : {product.b, product.a}) {
        const std::string name = of(o).name;
        if (!name.empty() && !name.starts_with("s_") && !name.starts_with("c_")) return quantity(o);
      }
      const std::string last = quantity(product.b);
      return last.empty() ? quantity(product.a) : last;
    };
    if (!is_sum(s.op)) {
      const std::string factor = s.op == Op::multiply ? of_product(s) : quantity(s.a);
      return factor.empty() ? "_term" : "_of_" + factor;
    }
    for (const Operand& o : {s.b, s.a}) {
      const Statement* term = statement(o);
      std::string added = quantity(o);
      if (added.empty() && term && term->op == Op::multiply) added = of_product(*term);
      if (!added.empty()) return "_to_" + added;
    }
    return "_part";
  }

  std::vector<std::string> distinct() const {
    std::vector<std::string> result(known_.size());
    UniqueNames used;
    const auto take = [&](std::size_t i, const std::string& name) { result[i] = used.add(name); };
    // What the algorithm named comes first, and keeps its name.
    for (std::size_t i = 0; i < known_.size(); ++i)
      if (p_.statements[i].named) take(i, p_.statements[i].name);
    for (std::size_t i = 0; i < known_.size(); ++i)
      if (is_line_[i] && result[i].empty() && !known_[i].name.empty() && !used.contains(text(known_[i])))
        take(i, text(known_[i]));
    for (const auto& [i, name] : parts_)
      if (result[i].empty()) take(i, name);
    std::map<std::string, int> next;
    for (const bool lines : {true, false}) {
      for (std::size_t i = 0; i < known_.size(); ++i) {
        if (is_line_[i] != lines || !result[i].empty()) continue;
        const std::string& prefix = p_.sections[at(p_.statements[i].section)].prefix;
        std::string name;
        do name = prefix + "_t" + std::to_string(next[prefix]++);
        while (used.contains(name));
        take(i, name);
      }
    }
    return result;
  }
};

}  // namespace

std::vector<std::string> line_names(const Program& program, const std::vector<bool>& is_line) {
  return LineNamer(program, is_line).run();
}

}  // namespace robcogen::symbolic
