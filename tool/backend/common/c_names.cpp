#include "backend/common/c_names.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <unordered_set>

namespace robcogen::backend::c_family {
namespace {

constexpr auto kKeywords = std::to_array<std::string_view>({
    "alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
    "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
    "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
    "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
    "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
    "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
    "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
    "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
    "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
    "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
    "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
    "true",        "try",      "typedef",    "typeid",    "typename",  "typeof",       "union",
    "unsigned",    "using",    "virtual",    "void",      "volatile",  "wchar_t",      "while",
    "xor",         "xor_eq",
});

// Macros of system headers and of compilers, and the types and variables of headers that a local name would shadow.
// Names with a leading underscore need no entry, because no generated identifier has one.
constexpr std::string_view kSystemNames[] = {
#include "backend/common/macros.inc"
};

// Macros of other versions of these headers, and of other processors.
constexpr auto kOtherMacros = std::to_array<std::string_view>(
    {"DOMAIN", "FP_FAST_FMA", "HUGE", "NDEBUG", "OVERFLOW", "PLOSS", "SING", "TLOSS", "UNDERFLOW", "X_TLOSS", "i386",
     "imaginary", "sparc"});

// Macros of Windows, macOS, X11, Qt and Arduino.
constexpr auto kPlatformMacros = std::to_array<std::string_view>({
    "Always", "Bool", "CONST",    "Complex", "DEBUG",    "DELETE", "DEG_TO_RAD", "ERROR",   "FALSE",     "False",
    "IN",     "NO",   "NO_ERROR", "None",    "OPTIONAL", "OUT",    "PI",         "STRICT",  "Status",    "Success",
    "TRUE",   "True", "VOID",     "YES",     "cdecl",    "emit",   "far",        "foreach", "interface", "max",
    "min",    "near", "nil",      "pascal",  "signals",  "slots",  "small",
});

// Never iterated, so that it decides no order.
const std::unordered_set<std::string_view>& reserved() {
  static const std::unordered_set<std::string_view> names = [] {
    std::unordered_set<std::string_view> all(kKeywords.begin(), kKeywords.end());
    all.insert(std::begin(kSystemNames), std::end(kSystemNames));
    all.insert(kOtherMacros.begin(), kOtherMacros.end());
    all.insert(kPlatformMacros.begin(), kPlatformMacros.end());
    return all;
  }();
  return names;
}

// A number for the pair of a word's first and last characters, and how many such numbers there are.
constexpr std::size_t kEnds = 32 * 32;
std::size_t ends(std::string_view word) {
  const auto number = [](char c) { return static_cast<unsigned char>(c) % std::size_t{32}; };
  return 32 * number(word.front()) + number(word.back());
}

// The bit for the word's length. All longer words share the last bit.
std::uint64_t length_bit(std::string_view word) {
  return std::uint64_t{1} << std::min<std::size_t>(word.size(), 63);
}

}  // namespace

bool is_reserved(const std::string& name) {
  // Most names differ in length from all reserved names that begin and end with the same characters.
  static const auto lengths = [] {
    std::array<std::uint64_t, kEnds> result{};  // one bit per length
    for (const std::string_view word : reserved()) result[ends(word)] |= length_bit(word);
    return result;
  }();
  return !name.empty() && (lengths[ends(name)] & length_bit(name)) != 0 && reserved().contains(name);
}

}  // namespace robcogen::backend::c_family
