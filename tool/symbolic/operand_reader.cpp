#include "symbolic/operand_reader.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace robcogen::symbolic {
namespace {

// Whether all of the text is one integer.
template <class Integer>
bool read_all(std::string_view text, Integer& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && !text.empty();
}

}  // namespace

std::string OperandReader::assign(const std::string& name) {
  const bool is_new = statement_of_.emplace(name, static_cast<int>(program_.statements.size())).second;
  return is_new ? "" : "'" + name + "' is assigned twice";
}

std::string OperandReader::read(std::string word, Operand& operand) {
  if (word.starts_with('-')) {
    operand.negative = true;
    word.erase(0, 1);
  }
  const std::size_t at = std::min(word.find('@'), word.size());
  if (const auto known = statement_of_.find(word.substr(0, at)); known != statement_of_.end()) {
    operand.kind = Operand::Kind::statement;
    operand.index = known->second;
    const bool is_lane =
        at == word.size() || (read_all(std::string_view(word).substr(at + 1), operand.lane) && operand.lane >= 0);
    return is_lane ? "" : "'" + word + "' is not a lane";
  }
  if (word.ends_with(']')) return read_input(word, operand);
  return read_constant(word, operand);
}

std::string OperandReader::read_input(const std::string& word, Operand& operand) const {
  const std::size_t bracket = std::min(word.find('['), word.size() - 1);
  const std::string_view digits = std::string_view(word).substr(bracket + 1, word.size() - bracket - 2);
  int index = -1, offset = 0;
  const bool whole = read_all(digits, index);
  for (const InputArray& array : program_.inputs) {
    if (whole && word.compare(0, bracket, array.name) == 0 && index >= 0 &&
        index < static_cast<int>(array.elements.size())) {
      operand.kind = Operand::Kind::input;
      operand.index = offset + index;
      return "";
    }
    offset += static_cast<int>(array.elements.size());
  }
  return "'" + word + "' is not an element of an input";
}

std::string OperandReader::read_constant(const std::string& word, Operand& operand) {
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
  operand.kind = Operand::Kind::constant;
  const auto [place, fresh] = constant_of_.emplace(word, static_cast<int>(program_.constants.size()));
  if (fresh) program_.constants.push_back(*value);
  operand.index = place->second;
  return "";
}

}  // namespace robcogen::symbolic
