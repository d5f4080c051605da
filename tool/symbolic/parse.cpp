#include <memory>
#include <sstream>
#include <utility>

#include "symbolic/operand_reader.h"
#include "symbolic/text.h"
#include "symbolic/text_names.h"
#include "symbolic/verify.h"

namespace robcogen::symbolic {
namespace {

// Reads line by line and stops at the first error.
class Reader {
 public:
  explicit Reader(const std::string& text) : lines_(text) {}
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

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
  OperandReader operands_{program_};
  int section_ = 0;

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
          if (std::string fault = operands_.read(operand, s.lanes.emplace_back()); !fault.empty()) return fault;
        return append(std::move(s));
      }
      if (!(words_ >> operand)) return "the function needs an operand";
      if (std::string fault = operands_.read(operand, s.a); !fault.empty()) return fault;
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
    if (std::string fault = operands_.read(first, s.a); !fault.empty()) return fault;
    if (std::string fault = operands_.read(operand, s.b); !fault.empty()) return fault;
    return append(std::move(s));
  }

  std::string append(Statement s) {
    if (std::string fault = operands_.assign(s.name); !fault.empty()) return fault;
    if (s.named) s.quantity = std::make_shared<const Quantity>(Quantity{s.name});
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
        if (std::string fault = operands_.read(word, o); !fault.empty()) return fault;
        array.values.push_back(o);
      }
      return "";
    }
    return "'" + name + "' is not an output";
  }
};

}  // namespace

std::optional<Program> parse(const std::string& text, std::string& error) {
  return Reader(text).read(error);
}

}  // namespace robcogen::symbolic
