#include <charconv>
#include <map>
#include <sstream>
#include <string_view>

#include "symbolic/text.h"
#include "symbolic/text_names.h"
#include "symbolic/verify.h"

namespace robcogen::symbolic {
namespace {

// Whether all of the text is one integer.
template <class Integer>
bool read_all(std::string_view text, Integer& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && !text.empty();
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
    return "'" + keyword + "' is not a statement";
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
    if (!known) return "'" + op + "' is not an operation";
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
    return "'" + name + "' is not an output";
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
      return is_lane ? "" : "'" + word + "' is not a lane";
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
    return "'" + word + "' is not an element of an input";
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

std::optional<Program> parse(const std::string& text, std::string& error) {
  return Reader(text).read(error);
}

}  // namespace robcogen::symbolic
