#include "backend/common/names.h"

#include <algorithm>

#include "support/concat.h"

namespace robcogen::backend {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Whether identifier() would return the name unchanged.
bool is_identifier(const std::string& name, IsReserved is_reserved) {
  char last = '_';
  for (const char c : name) {
    if (c == '_' ? last == '_' : !is_letter(c) && !is_digit(c)) return false;
    last = c;
  }
  return !name.empty() && !is_digit(name.front()) && !is_reserved(name);
}

}  // namespace

std::string identifier(const std::string& wanted, IsReserved is_reserved) {
  std::string name;
  for (char c : wanted) {
    const char legal = is_letter(c) || is_digit(c) ? c : '_';
    if (legal == '_' && (name.empty() || name.back() == '_')) continue;
    name += legal;
  }
  if (name.empty() || is_digit(name.front())) name.insert(0, "n");
  if (is_reserved(name)) name += '_';
  return name;
}

std::string shortened(const std::string& name, std::size_t limit, IsReserved is_reserved) {
  if (name.size() <= limit) return name;
  const std::size_t head = (limit - 1) / 2;
  return identifier(name.substr(0, head) + "_" + name.substr(name.size() - (limit - 1 - head)), is_reserved);
}

NameScope::NameScope(IsReserved reserved, const std::vector<std::string>& taken) : is_reserved_(reserved) {
  for (const std::string& name : taken) take(name);
}

bool NameScope::take(const std::string& name) {
  return uses_.try_emplace(name, 1).second;
}

std::string NameScope::claim(const std::string& wanted) {
  const std::string name = identifier(wanted, is_reserved_);
  if (take(name)) return name;
  int uses = *uses_.find(name);
  std::string numbered;
  do numbered = (name.back() == '_' ? name : name + "_") + std::to_string(++uses);
  while (!take(numbered));
  *uses_.find(name) = uses;
  return numbered;
}

std::vector<std::string> claim_all(NameScope& scope, std::vector<std::string> wanted) {
  std::vector<bool> is_claimed(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
    is_claimed[i] = is_identifier(wanted[i], scope.is_reserved()) && scope.take(wanted[i]);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (!is_claimed[i]) wanted[i] = scope.claim(wanted[i]);
  return wanted;
}

std::vector<std::string> claim_all(const std::vector<std::string>& wanted, IsReserved is_reserved) {
  NameScope scope(is_reserved);
  return claim_all(scope, wanted);
}

std::string dotted(const std::string& scope) {
  return replaced(scope, "::", ".");
}

std::string scoped(const std::string& enclosing, const std::string& name, const std::string& between) {
  return replaced(enclosing.empty() ? name : enclosing + "::" + name, "::", between);
}

std::string flat(const std::string& enclosing, const std::string& name) {
  return scoped(enclosing, name, "_");
}

}  // namespace robcogen::backend
