// One thing a line:
//     program inverse_dynamics
//     input q joint_position SLIDE HFE
//     output tau joint_force 2 1
//     section upperleg link upperleg: velocity
//     in 0
//     let upperleg_wz = q[0] * 0.35        (let: named by the algorithm; tmp: numbered)
//     tmp upperleg_t0 = sin q[1]
//     tmp legs_qd = gather qd[0] qd[3]     (lanes; legs_qd@1 is one of them)
//     return tau upperleg_wz -upperleg_t0
#include "symbolic/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

namespace robcogen::symbolic {
namespace {

struct RoleName {
  Role role;
  const char* name;
};
constexpr std::array kRoles = {
    RoleName{Role::joint_position, "joint_position"},
    RoleName{Role::joint_sine, "joint_sine"},
    RoleName{Role::joint_cosine, "joint_cosine"},
    RoleName{Role::joint_velocity, "joint_velocity"},
    RoleName{Role::joint_acceleration, "joint_acceleration"},
    RoleName{Role::joint_force, "joint_force"},
    RoleName{Role::gravity, "gravity"},
    RoleName{Role::base_velocity, "base_velocity"},
    RoleName{Role::base_acceleration, "base_acceleration"},
    RoleName{Role::base_wrench, "base_wrench"},
    RoleName{Role::link_wrenches, "link_wrenches"},
    RoleName{Role::inertia_matrix, "inertia_matrix"},
    RoleName{Role::inertia_factor, "inertia_factor"},
    RoleName{Role::inverse_diagonal, "inverse_diagonal"},
    RoleName{Role::homogeneous, "homogeneous"},
    RoleName{Role::spatial_motion, "spatial_motion"},
    RoleName{Role::spatial_force, "spatial_force"},
    RoleName{Role::jacobian, "jacobian"},
    RoleName{Role::jacobian_in_target, "jacobian_in_target"},
    RoleName{Role::spatial_jacobian, "spatial_jacobian"},
    RoleName{Role::jacobian_derivative, "jacobian_derivative"},
    RoleName{Role::matrix, "matrix"},
    RoleName{Role::frame_velocity, "frame_velocity"},
    RoleName{Role::frame_acceleration, "frame_acceleration"},
    RoleName{Role::frame_bias_acceleration, "frame_bias_acceleration"},
    RoleName{Role::position, "position"},
    RoleName{Role::energy, "energy"},
    RoleName{Role::mass, "mass"},
    RoleName{Role::parameters, "parameters"},
    RoleName{Role::variables, "variables"},
    RoleName{Role::value, "value"}};

struct OpName {
  Op op;
  const char* name;
};
constexpr std::array kOps = {
    OpName{Op::add, "+"},      OpName{Op::subtract, "-"},       OpName{Op::multiply, "*"},
    OpName{Op::divide, "/"},   OpName{Op::square_root, "sqrt"}, OpName{Op::sine, "sin"},
    OpName{Op::cosine, "cos"}, OpName{Op::gather, "gather"},    OpName{Op::sum_lanes, "sum_lanes"}};

std::string name_of(Role role) {
  for (const RoleName& r : kRoles)
    if (r.role == role) return r.name;
  return "value";
}

std::string name_of(Op op) {
  for (const OpName& o : kOps)
    if (o.op == op) return o.name;
  return "?";
}

// How many lanes an operand has; a sound one picks a lane of none but statements that have several.
int width_of(const Program& p, const Operand& o) {
  return o.kind == Operand::Kind::statement && o.lane < 0 ? p.statements[static_cast<std::size_t>(o.index)].width : 1;
}

int width_of_result(const Program& p, const Statement& s) {
  if (s.op == Op::gather) return static_cast<int>(s.lanes.size());
  if (s.op == Op::sum_lanes) return 1;
  return std::max(width_of(p, s.a), is_binary(s.op) ? width_of(p, s.b) : 1);
}

// Whether the lanes of a statement agree with each other, where its operands are sound.
bool has_sound_lanes(const Program& p, const Statement& s) {
  const auto is_scalar = [&](const Operand& o) { return width_of(p, o) == 1; };
  if (s.width != width_of_result(p, s)) return false;
  if (s.op == Op::gather) return s.width > 1 && std::all_of(s.lanes.begin(), s.lanes.end(), is_scalar);
  if (s.op == Op::sum_lanes) return !is_scalar(s.a);
  const auto fits = [&](const Operand& o) { return is_scalar(o) || width_of(p, o) == s.width; };
  return fits(s.a) && (!is_binary(s.op) || fits(s.b));
}

std::string print_constant(const Number& n) {
  if (!n.is_pi_multiple()) return print_double(n.value());
  return "pi:" + std::to_string(n.ratio()->num) + ":" + std::to_string(n.ratio()->den);
}

bool is_identifier(const std::string& s) {
  if (s.empty() || (s[0] >= '0' && s[0] <= '9')) return false;
  for (char c : s)
    if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_')) return false;
  return true;
}

// Whether all of the text is one integer.
template <class Integer>
bool read_all(std::string_view text, Integer& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && !text.empty();
}

// What is wrong with the names of input or output arrays.
template <class Array>
std::string fault_of_names(const std::vector<Array>& arrays) {
  std::set<std::string> names;
  for (const Array& array : arrays) {
    if (!is_identifier(array.name)) return "'" + array.name + "' is no identifier";
    if (!names.insert(array.name).second) return "'" + array.name + "' names two arrays";
  }
  return "";
}

// Reads line by line; the first thing that is wrong ends it.
class Reader {
 public:
  explicit Reader(const std::string& text) : lines_(text) {}

  std::optional<Program> read(std::string& error) {
    std::string line;
    for (int number = 1; std::getline(lines_, line); ++number) {
      words_ = std::istringstream(line);
      std::string keyword;
      if (!(words_ >> keyword)) continue;
      std::string fault = statement(keyword);
      std::string rest;
      if (fault.empty() && words_ >> rest) fault = "'" + rest + "' is too much";
      if (!fault.empty()) {
        error = "line " + std::to_string(number) + ": " + fault;
        return std::nullopt;
      }
    }
    error = verify(program_);
    return error.empty() ? std::optional(program_) : std::nullopt;
  }

 private:
  std::istringstream lines_;
  std::istringstream words_;
  Program program_;
  int section_ = 0;
  std::map<std::string, int> statement_of_;
  std::map<std::string, int> constant_of_;

  std::string statement(const std::string& keyword) {
    if (keyword == "program") return words_ >> program_.name ? "" : "a program needs a name";
    if (keyword == "input") return input();
    if (keyword == "output") return output();
    if (keyword == "section") return section();
    if (keyword == "in") return words_ >> section_ ? "" : "'in' needs the number of a section";
    if (keyword == "let" || keyword == "tmp") return assignment(keyword == "let");
    if (keyword == "return") return values();
    return "'" + keyword + "' is no statement";
  }

  bool role(Role& role) {
    std::string name;
    words_ >> name;
    for (const RoleName& r : kRoles) {
      if (name != r.name) continue;
      role = r.role;
      return true;
    }
    return false;
  }

  std::string input() {
    InputArray array;
    if (!(words_ >> array.name) || !role(array.role)) return "an input needs a name and a role";
    for (std::string element; words_ >> element;) array.elements.push_back(element);
    program_.inputs.push_back(std::move(array));
    return "";
  }

  std::string output() {
    OutputArray array;
    if (!(words_ >> array.name) || !role(array.role) || !(words_ >> array.rows >> array.columns))
      return "an output needs a name, a role, rows and columns";
    program_.outputs.push_back(std::move(array));
    return "";
  }

  std::string section() {
    Section s;
    if (!(words_ >> s.prefix)) return "a section needs a prefix";
    words_ >> std::ws;
    std::getline(words_, s.title);
    program_.sections.push_back(std::move(s));
    return "";
  }

  std::string assignment(bool named) {
    Statement s;
    s.named = named;
    s.section = section_;
    std::string equals, first;
    if (!(words_ >> s.name >> equals >> first) || equals != "=") return "expected `name = …`";
    std::string op, operand;
    for (const OpName& o : kOps) {
      if (first != o.name || is_binary(o.op)) continue;
      s.op = o.op;
      if (s.op == Op::gather) {
        while (words_ >> operand)
          if (std::string fault = read_operand(operand, s.lanes.emplace_back()); !fault.empty()) return fault;
        return append(std::move(s));
      }
      if (!(words_ >> operand)) return "the function needs an operand";
      if (std::string fault = read_operand(operand, s.a); !fault.empty()) return fault;
      return append(std::move(s));
    }
    if (!(words_ >> op >> operand)) return "expected `a op b`";
    bool known = false;
    for (const OpName& o : kOps) {
      if (op != o.name || !is_binary(o.op)) continue;
      s.op = o.op;
      known = true;
    }
    if (!known) return "'" + op + "' is no operation";
    if (std::string fault = read_operand(first, s.a); !fault.empty()) return fault;
    if (std::string fault = read_operand(operand, s.b); !fault.empty()) return fault;
    return append(std::move(s));
  }

  std::string append(Statement s) {
    if (!statement_of_.emplace(s.name, static_cast<int>(program_.statements.size())).second)
      return "'" + s.name + "' is assigned twice";
    s.width = width_of_result(program_, s);
    program_.statements.push_back(std::move(s));
    return "";
  }

  std::string values() {
    std::string name;
    words_ >> name;
    for (OutputArray& array : program_.outputs) {
      if (array.name != name) continue;
      for (std::string word; words_ >> word;) {
        Operand o;
        if (std::string fault = read_operand(word, o); !fault.empty()) return fault;
        array.values.push_back(o);
      }
      return "";
    }
    return "'" + name + "' is no output";
  }

  std::string read_operand(std::string word, Operand& o) {
    if (word.starts_with('-')) {
      o.negative = true;
      word.erase(0, 1);
    }
    const std::size_t at = std::min(word.find('@'), word.size());
    if (const auto known = statement_of_.find(word.substr(0, at)); known != statement_of_.end()) {
      o.kind = Operand::Kind::statement;
      o.index = known->second;
      const bool is_lane =
          at == word.size() || (read_all(std::string_view(word).substr(at + 1), o.lane) && o.lane >= 0);
      return is_lane ? "" : "'" + word + "' is no lane";
    }
    if (word.ends_with(']')) return read_input(word, o);
    return read_constant(word, o);
  }

  std::string read_input(const std::string& word, Operand& o) {
    const std::size_t bracket = std::min(word.find('['), word.size() - 1);
    const std::string_view digits = std::string_view(word).substr(bracket + 1, word.size() - bracket - 2);
    int index = -1, offset = 0;
    const bool whole = read_all(digits, index);
    for (const InputArray& array : program_.inputs) {
      if (whole && word.compare(0, bracket, array.name) == 0 && index >= 0 &&
          index < static_cast<int>(array.elements.size())) {
        o.kind = Operand::Kind::input;
        o.index = offset + index;
        return "";
      }
      offset += static_cast<int>(array.elements.size());
    }
    return "'" + word + "' is no element of an input";
  }

  std::string read_constant(const std::string& word, Operand& o) {
    std::optional<Number> value;
    if (word.starts_with("pi:")) {
      const std::string_view ratio = std::string_view(word).substr(3);
      const std::size_t colon = std::min(ratio.find(':'), ratio.size() - 1);
      Rational r;
      if (read_all(ratio.substr(0, colon), r.num) && read_all(ratio.substr(colon + 1), r.den) && r.num > 0 && r.den > 0)
        value = Number::pi_multiple(r.num, r.den);
    } else if (!word.starts_with('-') && !word.starts_with('+')) {
      value = Number::parse(word);
    }
    if (!value) return "'" + word + "' is neither a number nor assigned before";
    o.kind = Operand::Kind::constant;
    const auto [place, fresh] = constant_of_.emplace(word, static_cast<int>(program_.constants.size()));
    if (fresh) program_.constants.push_back(*value);
    o.index = place->second;
    return "";
  }
};

}  // namespace

std::string print(const Program& p) {
  std::vector<std::string> inputs;
  for (const InputArray& array : p.inputs)
    for (std::size_t i = 0; i < array.elements.size(); ++i)
      inputs.push_back(array.name + "[" + std::to_string(i) + "]");
  const auto text = [&](const Operand& o) {
    const auto i = static_cast<std::size_t>(o.index);
    const std::string value = o.kind == Operand::Kind::constant ? print_constant(p.constants[i])
                              : o.kind == Operand::Kind::input  ? inputs[i]
                                                                : p.statements[i].name;
    return (o.negative ? "-" : "") + value + (o.lane >= 0 ? "@" + std::to_string(o.lane) : "");
  };

  std::string out = "program " + p.name + "\n";
  for (const InputArray& array : p.inputs) {
    out += "input " + array.name + " " + name_of(array.role);
    for (const std::string& element : array.elements) out += " " + element;
    out += "\n";
  }
  for (const OutputArray& array : p.outputs)
    out += "output " + array.name + " " + name_of(array.role) + " " + std::to_string(array.rows) + " " +
           std::to_string(array.columns) + "\n";
  for (const Section& s : p.sections) out += "section " + s.prefix + " " + s.title + "\n";
  int section = -1;
  for (const Statement& s : p.statements) {
    if (s.section != section) out += "in " + std::to_string(section = s.section) + "\n";
    out += (s.named ? "let " : "tmp ") + s.name + " = ";
    if (s.op == Op::gather) {
      out += name_of(s.op);
      for (const Operand& o : s.lanes) out += " " + text(o);
    } else {
      out += is_binary(s.op) ? text(s.a) + " " + name_of(s.op) + " " + text(s.b) : name_of(s.op) + " " + text(s.a);
    }
    out += "\n";
  }
  for (const OutputArray& array : p.outputs) {
    out += "return " + array.name;
    for (const Operand& o : array.values) out += " " + text(o);
    out += "\n";
  }
  return out;
}

std::optional<Program> parse(const std::string& text, std::string& error) {
  return Reader(text).read(error);
}

std::string verify(const Program& p) {
  const int inputs = p.input_count();
  const auto sound = [&](const Operand& o, std::size_t before) {
    if (o.index < 0) return false;
    switch (o.kind) {
      case Operand::Kind::constant:
        return o.index < static_cast<int>(p.constants.size());
      case Operand::Kind::input:
        return o.index < inputs;
      case Operand::Kind::statement:
        return static_cast<std::size_t>(o.index) < before &&
               (o.lane < 0 || o.lane < p.statements[static_cast<std::size_t>(o.index)].width);
    }
    return false;
  };
  if (!is_identifier(p.name)) return "the program has no proper name";
  for (const auto& fault : {fault_of_names(p.inputs), fault_of_names(p.outputs)})
    if (!fault.empty()) return fault;
  std::set<std::string> names;
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    const Statement& s = p.statements[i];
    if (!is_identifier(s.name)) return "'" + s.name + "' is no identifier";
    if (std::any_of(kOps.begin(), kOps.end(), [&](const OpName& o) { return s.name == o.name; }))
      return "'" + s.name + "' is an operation";
    if (!names.insert(s.name).second) return "'" + s.name + "' is assigned twice";
    const bool gathers = s.op == Op::gather;
    if ((!gathers && !sound(s.a, i)) || (is_binary(s.op) && !sound(s.b, i)) ||
        !std::all_of(s.lanes.begin(), s.lanes.end(), [&](const Operand& o) { return sound(o, i); }))
      return "statement '" + s.name + "' reads what is not there";
    if (!has_sound_lanes(p, s)) return "statement '" + s.name + "' reads lanes that do not fit";
    if (s.section < 0 || s.section >= static_cast<int>(p.sections.size()))
      return "statement '" + s.name + "' is in no section";
  }
  for (const Number& n : p.constants)
    if (!(n.value() >= 0.0) || std::isinf(n.value())) return "a constant is negative or no number";
  for (const OutputArray& array : p.outputs) {
    if (array.rows < 0 || array.columns < 0 ||
        array.values.size() != static_cast<std::size_t>(array.rows) * static_cast<std::size_t>(array.columns))
      return "output '" + array.name + "' has the wrong number of values";
    for (const Operand& o : array.values) {
      if (!sound(o, p.statements.size())) return "output '" + array.name + "' reads what is not there";
      if (width_of(p, o) > 1) return "output '" + array.name + "' reads several lanes at once";
    }
  }
  return "";
}

}  // namespace robcogen::symbolic
