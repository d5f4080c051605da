#include "language/desired/parse_loop.h"

namespace robcogen::language::desired {
namespace {

// The body is read even after an error in the list.
void read_instances(Cursor& cursor, Loop& loop) {
  try {
    do loop.instances.push_back(read_instance(cursor));
    while (cursor.accept(","));
    if (!cursor.accept("}")) cursor.unexpected("',' or '}'", "in the list of instances");
  } catch (const SyntaxError&) {
    cursor.skip_until([&] { return cursor.at_any({"}", "->", "<-"}) || at_section(cursor); });
    if (!cursor.accept("}") || !cursor.at("{")) throw;
  }
}

}  // namespace

bool at_loop(const Cursor& cursor) {
  return cursor.at("for") && cursor.at_name(1) && cursor.at("in", 2);
}

LoopHead read_loop_head(Cursor& cursor, int outer, std::string_view element) {
  const Token word = cursor.take();
  if (outer != Name::kNoLoop) {
    cursor.error_at(word.span, "nested-loop", "loops cannot be nested").hint =
        "write one loop for each instance of the outer loop";
    throw SyntaxError{};
  }
  LoopHead head;
  head.loop.variable = read_name(cursor, "the name of a variable");
  cursor.take();
  cursor.expect("{", "after 'in'");
  read_instances(cursor, head.loop);
  head.open = cursor.expect("{", "after the list of instances");
  if (cursor.at("}")) cursor.unexpected(element, "in the loop");
  return head;
}

}  // namespace robcogen::language::desired
