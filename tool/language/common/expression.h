// Arithmetic in documents, as written: the syntax tree shared by all four languages.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "support/number.h"
#include "support/source.h"

namespace robcogen::language {

struct Expression;
using ExpressionPtr = std::shared_ptr<const Expression>;

// Names are kept as written, without the escaping '^'. The import decides what a name means.
struct Expression {
  enum class Kind {
    number,    // literal, or a folded constant
    pi,        // `PI`, `pi`, `Pi`, …: the constant, unless a parameter of exactly this name is declared
    name,      // parameter or variable; `group` for `Group.name`
    constant,  // named constant `<name=3.2>` (with value in `left`) or `<name>`, `c:name:value`, `consts.name`
    negate,
    add,
    subtract,
    multiply,  // `*`, or juxtaposition if `juxtaposed`
    divide,
    sine,
    cosine,
    tangent,
    square_root,
  };
  Kind kind = Kind::number;
  Span span;
  Number number;                        // kind number
  std::string name;                     // kinds pi (its spelling), name, constant
  bool escaped = false;                 // kinds name, constant: written with '^', because the name is a keyword
  std::string group;                    // kind name: `Group.` prefix, or empty
  bool is_parameter = false;            // kind name: written `p:name`, which declares a parameter
  std::optional<Number> default_value;  // kind name: `m1[1]`
  ExpressionPtr left;                   // operand, or first operand
  ExpressionPtr right;                  // second operand
  bool juxtaposed = false;              // kind multiply: written `2.0 a`, not `2.0*a`
};

// Returns a literal or a folded constant.
ExpressionPtr literal(Span span, const Number& number);

// Returns text that parses to an equal tree, except for spans. Prefers the spelling of the first RobCoGen (`PI/2.0`,
// `-PI/2.0`, `0.5 len`) if there is one.
std::string print(const Expression& e);

// Whether the trees are the same; spans may differ.
bool equal(const Expression& a, const Expression& b);

}  // namespace robcogen::language
