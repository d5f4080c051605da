// Every spelling of an expression and the tree that it represents.
#include "language/common/expression.h"

#include "language/common/parse_expression.h"
#include "language/kinematics/keywords.h"
#include "reading.h"

namespace robcogen::language::expression_test {
namespace {

using test::Codes;
using Kind = Expression::Kind;

// Prefix notation, fully parenthesised.
std::string tree(const Expression& e) {
  const auto operation = [&](const char* name) {
    return std::string("(") + name + " " + tree(*e.left) + (e.right ? " " + tree(*e.right) : "") + ")";
  };
  switch (e.kind) {
    case Kind::number:
      return print_double(e.number.value());
    case Kind::pi:
      return "pi:" + e.name;
    case Kind::name:
      return (e.escaped ? "^" : "") + e.name +
             (e.default_value ? "[" + print_double(e.default_value->value()) + "]" : "");
    case Kind::constant:
      return "<" + e.name + (e.left ? "=" + tree(*e.left) : "") + ">";
    case Kind::negate:
      return operation("-");
    case Kind::add:
      return operation("+");
    case Kind::subtract:
      return operation("-");
    case Kind::multiply:
      return operation("*");
    case Kind::divide:
      return operation("/");
    case Kind::sine:
      return operation("sin");
    case Kind::cosine:
      return operation("cos");
    case Kind::tangent:
      return operation("tan");
    case Kind::square_root:
      return operation("sqrt");
  }
  return "";
}

struct Parsed {
  ExpressionPtr expression;  // null after an error
  std::string rest;          // the token after it
  Codes codes;
};

Parsed parse(const std::string& text) {
  Diagnostics diagnostics;
  Cursor cursor(tokenize(test::source(text), diagnostics), kinematics::keywords(), diagnostics);
  Parsed result;
  try {
    result.expression = parse_expression(cursor);
    result.rest = cursor.peek().text;
  } catch (const SyntaxError&) {
    EXPECT_TRUE(diagnostics.has_errors()) << text;
  }
  result.codes = test::codes(diagnostics);
  return result;
}

// Returns the tree of a text; expects that it prints to text that reads back as the same tree and prints the same.
std::string read(const std::string& text) {
  const Parsed parsed = parse(text);
  if (!parsed.expression) return "[" + parsed.codes.front() + "]";
  if (!parsed.codes.empty()) return "[" + parsed.codes.front() + "] " + tree(*parsed.expression);
  if (!parsed.rest.empty()) return tree(*parsed.expression) + " | " + parsed.rest;
  const std::string printed = print(*parsed.expression);
  const Parsed again = parse(printed);
  EXPECT_TRUE(again.expression && again.codes.empty()) << text << " prints as " << printed;
  if (again.expression) {
    EXPECT_TRUE(equal(*parsed.expression, *again.expression)) << text << " prints as " << printed;
    EXPECT_EQ(print(*again.expression), printed);
  }
  return tree(*parsed.expression);
}

TEST(Expression, OfTheOriginal) {
  EXPECT_EQ(read("1.0"), "1.0");
  EXPECT_EQ(read("-.5"), "-0.5");
  EXPECT_EQ(read("+0.5"), "0.5");
  EXPECT_EQ(read("PI"), "pi:PI");
  EXPECT_EQ(read("-PI"), "(- pi:PI)");
  EXPECT_EQ(read("len"), "len");
  EXPECT_EQ(read("-len"), "(- len)");
  EXPECT_EQ(read("2.0 PI"), "(* 2.0 pi:PI)");
  EXPECT_EQ(read("2.0PI"), "(* 2.0 pi:PI)");
  EXPECT_EQ(read("-2.0 PI"), "(* -2.0 pi:PI)");
  EXPECT_EQ(read("0.5 len"), "(* 0.5 len)");
  EXPECT_EQ(read("2.0a"), "(* 2.0 a)");
  EXPECT_EQ(read("PI/2.0"), "(/ pi:PI 2.0)");
  EXPECT_EQ(read("-len/2.0"), "(/ (- len) 2.0)");
  EXPECT_EQ(read("PI/-2.0"), "(/ pi:PI -2.0)");
  EXPECT_EQ(read("PI / 2.0"), "(/ pi:PI 2.0)");
}

TEST(Expression, OfTheSuccessors) {
  EXPECT_EQ(read("2.0 * PI"), "(* 2.0 pi:PI)");
  EXPECT_EQ(read("-PI / 2"), "(/ (- pi:PI) 2.0)");
  EXPECT_EQ(read("m1[1]"), "m1[1.0]");
  EXPECT_EQ(read("ll[-1.5e-1]"), "ll[-0.15]");
  EXPECT_EQ(read("0.5 * ll[1.0]"), "(* 0.5 ll[1.0])");
  EXPECT_EQ(read("-m1[1]/2.0"), "(/ (- m1[1.0]) 2.0)");
  EXPECT_EQ(read("<name=3.2>"), "<name=3.2>");
  EXPECT_EQ(read("<name=-3.2>"), "<name=-3.2>");
  EXPECT_EQ(read("<name>"), "<name>");
  EXPECT_EQ(read("-2.0*<name>/4"), "(/ (* -2.0 <name>) 4.0)");
  EXPECT_EQ(read("2.0 <name>"), "(* 2.0 <name>)");
  EXPECT_EQ(read("pi"), "pi:pi");
  EXPECT_EQ(read("Pi/2.0"), "(/ pi:Pi 2.0)");
  EXPECT_EQ(read("pI"), "pi:pI");
}

TEST(Expression, OfFullArithmetic) {
  EXPECT_EQ(read("a + b * c"), "(+ a (* b c))");
  EXPECT_EQ(read("(a + b) * c"), "(* (+ a b) c)");
  EXPECT_EQ(read("a - b - c"), "(- (- a b) c)");
  EXPECT_EQ(read("a - (b - c)"), "(- a (- b c))");
  EXPECT_EQ(read("a / b / c"), "(/ (/ a b) c)");
  EXPECT_EQ(read("a / (b * c)"), "(/ a (* b c))");
  EXPECT_EQ(read("-a * -b"), "(* (- a) (- b))");
  EXPECT_EQ(read("-(a * b)"), "(- (* a b))");
  EXPECT_EQ(read("-(a + b)"), "(- (+ a b))");
  EXPECT_EQ(read("--a"), "(- (- a))");
  EXPECT_EQ(read("-+-2.0"), "2.0");
  EXPECT_EQ(read("a - -2.0"), "(- a -2.0)");
  EXPECT_EQ(read("a--b"), "(- a (- b))");
  EXPECT_EQ(read("((a))"), "a");
  EXPECT_EQ(read("-(2.0)"), "-2.0");
  EXPECT_EQ(read("1e-3 + 1 - 1."), "(- (+ 0.001 1.0) 1.0)");
  EXPECT_EQ(
      read("sin(PI/2) + cos(a) * tan(-b) - sqrt(2.0)"),
      "(- (+ (sin (/ pi:PI 2.0)) (* (cos a) (tan (- b)))) (sqrt 2.0))");
  EXPECT_EQ(read("2.0 sin(a)"), "(* 2.0 (sin a))");
  EXPECT_EQ(read("sin"), "sin") << "a function's name is reserved only before '('";
}

TEST(Expression, JuxtaposesLikeAProduct) {
  EXPECT_EQ(read("2.0 PI/3.0"), "(/ (* 2.0 pi:PI) 3.0)");
  EXPECT_EQ(read("PI/2.0 a"), "[product-after-division] (* (/ pi:PI 2.0) a)");
  EXPECT_EQ(read("1.0 + 2.0 a"), "(+ 1.0 (* 2.0 a))");
  EXPECT_EQ(read("2.0 a b"), "(* 2.0 a) | b") << "only after a number";
  EXPECT_EQ(read("(2.0) a"), "2.0 | a") << "only after the number itself";
  EXPECT_EQ(read("m[2.0] a"), "m[2.0] | a");
}

TEST(Expression, SubtractsUnlessItIsNothingButANumberAndASignedName) {
  EXPECT_EQ(read("2.0 -PI"), "[signed-product] (* -2.0 pi:PI)");
  EXPECT_EQ(read("-2.0 -len"), "[signed-product] (* 2.0 len)");
  EXPECT_EQ(read("2.0 - PI"), "(- 2.0 pi:PI)");
  EXPECT_EQ(read("2.0-PI"), "(- 2.0 pi:PI)");
  EXPECT_EQ(read("2.0- PI"), "(- 2.0 pi:PI)");
  EXPECT_EQ(read("2.0 -1.0"), "(- 2.0 1.0)");
  EXPECT_EQ(read("2.0 -PI/2.0"), "(- 2.0 (/ pi:PI 2.0))");
  EXPECT_EQ(read("2.0 -PI + a"), "(+ (- 2.0 pi:PI) a)");
  EXPECT_EQ(read("a + 2.0 -PI"), "(- (+ a 2.0) pi:PI)");
  EXPECT_EQ(read("2.0 -sin(a)"), "(- 2.0 (sin a))");
  EXPECT_EQ(read("2.0 -m[1]"), "(- 2.0 m[1.0])");
  EXPECT_EQ(read("(2.0 -PI)"), "(- 2.0 pi:PI)");
  EXPECT_EQ(read("(2.0) -PI"), "(- 2.0 pi:PI)");
}

TEST(Expression, EndsBeforeAKeyword) {
  EXPECT_EQ(read("0.5 Iy=0.3"), "0.5 | Iy");
  EXPECT_EQ(read("1.0 CoM"), "1.0 | CoM");
  EXPECT_EQ(read("1.0 -mass"), "[unexpected-token]");
  EXPECT_EQ(read("0.5 ^Iy"), "(* 0.5 ^Iy)");
  EXPECT_EQ(read("^mass"), "^mass");
  EXPECT_EQ(read("<^mass=1.0>"), "<mass=1.0>");
  EXPECT_EQ(read("0.5 Izz = 1.0"), "0.5 | Izz") << "a misspelt keyword, for what else is before '='?";
}

TEST(Expression, KnowsEscapedNames) {
  EXPECT_EQ(read("^PI"), "^PI") << "a name, not the constant";
  EXPECT_EQ(read("PI[3.0]"), "PI[3.0]");
  EXPECT_EQ(read("^sin + 1.0"), "(+ ^sin 1.0)");
  EXPECT_EQ(read("^nan"), "^nan");
}

TEST(Expression, RefusesWhatIsNone) {
  for (const char* text : {"",   "*",   "1.0 +", "(1.0",  "(",    "()",    "a[",    "a[b]", "a[1.0", "<",
                           "<a", "<a=", "<a=b>", "<1.0>", "sin(", "sin()", "sin(a", "mass", "-",     ")"}) {
    const Parsed parsed = parse(text);
    EXPECT_FALSE(parsed.expression) << text;
    EXPECT_EQ(parsed.codes.size(), 1u) << text;
  }
  EXPECT_EQ(read("exp(1.0)"), "[unknown-function]");
  EXPECT_EQ(read("PI(1.0)"), "[unknown-function]");
  for (const char* text : {"NaN", "nan", "inf", "-Inf", "INFINITY", "2.0 NaN"}) EXPECT_EQ(read(text), "[not-a-number]");
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

TEST(Expression, NestsSoDeepAndNoDeeper) {
  EXPECT_EQ(read(repeated("(", 200) + "a" + repeated(")", 200)), "a");
  EXPECT_EQ(read(repeated("(", 201) + "a" + repeated(")", 201)), "[nesting-too-deep]");
  EXPECT_EQ(read(repeated("sin(", 10000) + "a" + repeated(")", 10000)), "[nesting-too-deep]");
  EXPECT_EQ(read(repeated("-", 10000) + "a"), "[nesting-too-deep]");
  EXPECT_EQ(parse(repeated("(", 10000)).codes, Codes{"nesting-too-deep"});
}

TEST(Expression, GoesOnSoLongAndNoLonger) {
  const auto operations = [](const Parsed& parsed) { return parsed.expression != nullptr; };
  EXPECT_TRUE(operations(parse("a" + repeated(" + a", 500))));
  EXPECT_EQ(parse("a" + repeated(" + a", 501)).codes, Codes{"expression-too-long"});
  EXPECT_EQ(parse("a" + repeated(" * a", 501)).codes, Codes{"expression-too-long"});
  // the limit counts the operations of the whole expression, because each may be a level of the tree
  EXPECT_EQ(
      parse(repeated("(", 100) + "a" + repeated(" + a)", 100) + repeated(" - a", 401)).codes,
      Codes{"expression-too-long"});
}

TEST(Expression, HasItsPlaceInTheText) {
  const Parsed parsed = parse(" 1.0 + sin( a ) * 2.0 PI ");
  EXPECT_EQ(parsed.expression->span.begin, 1u);
  EXPECT_EQ(parsed.expression->span.end, 24u);
  const Expression& product = *parsed.expression->right;
  EXPECT_EQ(product.span.begin, 7u);
  EXPECT_EQ(product.left->left->span.begin, 7u);
  EXPECT_EQ(product.left->left->span.end, 15u);
}

TEST(Expression, PrintsWhatTheOriginalReads) {
  const auto printed = [](const std::string& text) { return print(*parse(text).expression); };
  EXPECT_EQ(printed("2 * PI"), "2.0 PI");
  EXPECT_EQ(printed("-PI / 2"), "-PI/2.0");
  EXPECT_EQ(printed("2.0 -PI"), "-2.0 PI");
  EXPECT_EQ(printed("0.5*len"), "0.5 len");
  EXPECT_EQ(printed("1e-9"), "0.000000001");
  EXPECT_EQ(printed("1e15"), "1000000000000000.0");
  EXPECT_EQ(printed("1e-30"), "0.000000000000000000000000000001");
  EXPECT_EQ(printed("1e-301"), "1e-301");
  EXPECT_EQ(printed("3.14159265358979323846"), "3.141592653589793");
  EXPECT_EQ(printed("0"), "0.0");
  EXPECT_EQ(printed("2.0 m[1]"), "2.0 * m[1.0]");
}

TEST(Expression, DiffersInEveryPart) {
  const std::vector<std::string> all = {"1.0",    "2.0",     "PI",     "pi",      "a",       "b",      "a[1.0]",
                                        "a[2.0]", "<a>",     "<b>",    "<a=1>",   "<a=2>",   "-a",     "-b",
                                        "a+b",    "a-b",     "b+a",    "a*b",     "a/b",     "sin(a)", "cos(a)",
                                        "tan(a)", "sqrt(a)", "sin(b)", "(a*b)*c", "a*(b*c)", "^PI"};
  for (const std::string& x : all) {
    for (const std::string& y : all)
      EXPECT_EQ(equal(*parse(x).expression, *parse(y).expression), x == y) << x << " and " << y;
  }
}

}  // namespace
}  // namespace robcogen::language::expression_test
