#include "language/desired/frame_parser.h"

#include <fmt/format.h>

namespace robcogen::language::desired {

Name FrameParser::name(std::string_view what) {
  const Token token = cursor_.expect_name(what);
  return {std::string(token.text), token.span};
}

Name FrameParser::instance() {
  if (!at_side()) return name("the name of an instance of a part");
  const Token side = cursor_.take();
  return {std::string(side.text), side.span};
}

Name FrameParser::frame(std::string_view what) {
  Name result = at_instance() ? instance() : name(what);
  result.loop = loop_;
  if (!cursor_.accept(".")) return result;
  result.instance = std::exchange(result.text, {});
  result.instance_span = result.span;
  const Name own = name(fmt::format("the name of a frame of '{}'", result.instance));
  result.text = own.text;
  result.span.end = own.span.end;
  return result;
}

}  // namespace robcogen::language::desired
