#include "language/kinematics/parse_couplings.h"

namespace robcogen::language::kinematics {
namespace {

class CouplingParser {
 public:
  CouplingParser(BlockParser& parser, Body& body) : parser_(parser), cursor_(parser.cursor()), body_(body) {}

  void run() {
    const Token word = cursor_.take();
    parser_.block(
        fmt::format("'{}'", word.text), [&] { return at_coupling() || at_loop(); },
        [&] {
          if (at_loop())
            loop();
          else
            coupling(Coupling::kNoLoop);
        });
    for (std::string& comment : cursor_.comments_before(cursor_.previous().span.end))
      body_.coupling_comments.push_back(std::move(comment));
  }

 private:
  BlockParser& parser_;
  Cursor& cursor_;
  Body& body_;

  bool at_instance() const { return cursor_.at_name() && cursor_.at(".", 1) && cursor_.at_name(2); }
  bool at_coupling() const { return cursor_.at_name() && cursor_.at("=", at_instance() ? 3 : 1); }
  // 'for' and 'in' are not keywords: joints may have these names.
  bool at_loop() const { return cursor_.at("for") && cursor_.at_name(1) && cursor_.at("in", 2); }

  void coupling(int loop) {
    Coupling coupling;
    coupling.loop = loop;
    coupling.joint = parser_.name("the name of a joint");
    if (cursor_.accept(".")) {
      coupling.instance = std::exchange(coupling.joint.text, {});
      const Name own = parser_.name(fmt::format("the name of a joint of '{}'", coupling.instance));
      coupling.joint = {own.text, {coupling.joint.span.begin, own.span.end}};
    }
    cursor_.expect("=", fmt::format("after '{}'", coupling.joint.text));
    coupling.value = parser_.scalar();
    body_.couplings.push_back(std::move(coupling));
  }

  void loop() {
    cursor_.take();
    Loop loop;
    loop.variable = parser_.name("the name of a variable");
    cursor_.take();
    cursor_.expect("{", "after 'in'");
    do loop.instances.push_back(parser_.name("the name of an instance of a part"));
    while (cursor_.accept(","));
    if (!cursor_.accept("}")) cursor_.unexpected("',' or '}'", "in the list of instances");
    const int number = static_cast<int>(body_.loops.size());
    body_.loops.push_back(std::move(loop));
    cursor_.expect("{", "after the list of instances");
    do {
      cursor_.begin_statement();
      if (at_loop()) nested();
      if (!cursor_.at_name()) cursor_.unexpected("a coupling", "in the loop");
      coupling(number);
    } while (!cursor_.at("}"));
    cursor_.take();
  }

  [[noreturn]] void nested() {
    cursor_.error_at(cursor_.take().span, "nested-loop", "loops cannot be nested").hint =
        "write one loop for each instance of the outer loop";
    throw SyntaxError{};
  }
};

}  // namespace

void couplings(BlockParser& parser, Body& body) {
  CouplingParser(parser, body).run();
}

}  // namespace robcogen::language::kinematics
