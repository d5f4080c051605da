#include "import/identifier.h"

namespace robcogen::import {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_legal(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
}

bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace

std::string identifier(const std::string& name) {
  std::string result;
  if (!name.empty() && is_digit(name.front())) result += '_';
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (is_legal(name[i])) {
      result += name[i];
    } else if (i == 0 || !continues_character(name[i])) {
      result += '_';
    }
  }
  return result;
}

}  // namespace robcogen::import
