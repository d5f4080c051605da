#include "backend/cpp/names.h"

#include <array>
#include <string_view>
#include <unordered_set>

namespace robcogen::backend::cpp {
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

// Macros of C and POSIX headers, and the few global variables that a local name would shadow. Names with a leading
// underscore need no entry: no identifier of ours has one.
constexpr auto kStandardMacros = std::to_array<std::string_view>({
    "BUFSIZ",         "CHAR_BIT",    "CHAR_MAX",  "CHAR_MIN",     "DBL_DIG",
    "DBL_EPSILON",    "DBL_MAX",     "DBL_MIN",   "DOMAIN",       "ECHO",
    "EDOM",           "EINTR",       "EINVAL",    "EIO",          "ENOENT",
    "ENOMEM",         "EOF",         "EPERM",     "ERANGE",       "EXIT_FAILURE",
    "EXIT_SUCCESS",   "FLT_EPSILON", "FLT_MAX",   "FLT_MIN",      "FP_FAST_FMA",
    "FP_INFINITE",    "FP_NAN",      "FP_NORMAL", "FP_SUBNORMAL", "FP_ZERO",
    "HUGE",           "HUGE_VAL",    "HUGE_VALF", "HUGE_VALL",    "I",
    "INFINITY",       "INT_MAX",     "INT_MIN",   "LONG_MAX",     "LONG_MIN",
    "MATH_ERREXCEPT", "MATH_ERRNO",  "MAXFLOAT",  "M_1_PI",       "M_2_PI",
    "M_2_SQRTPI",     "M_E",         "M_LN10",    "M_LN2",        "M_LOG10E",
    "M_LOG2E",        "M_PI",        "M_PI_2",    "M_PI_4",       "M_SQRT1_2",
    "M_SQRT2",        "NAN",         "NDEBUG",    "NULL",         "OVERFLOW",
    "PLOSS",          "RAND_MAX",    "SEEK_CUR",  "SEEK_END",     "SEEK_SET",
    "SIGABRT",        "SIGFPE",      "SIGILL",    "SIGINT",       "SIGKILL",
    "SIGSEGV",        "SIGTERM",     "SING",      "SNAN",         "SNANF",
    "SNANL",          "TLOSS",       "UNDERFLOW", "X_TLOSS",      "assert",
    "complex",        "daylight",    "environ",   "errno",        "i386",
    "imaginary",      "linux",       "major",     "makedev",      "math_errhandling",
    "minor",          "offsetof",    "setjmp",    "signgam",      "sparc",
    "stderr",         "stdin",       "stdout",    "timezone",     "unix",
});

// Windows, macOS, X11, Qt, Arduino.
constexpr auto kPlatformMacros = std::to_array<std::string_view>({
    "Always", "Bool", "CONST",    "Complex", "DEBUG",    "DELETE", "DEG_TO_RAD", "ERROR",   "FALSE",     "False",
    "IN",     "NO",   "NO_ERROR", "None",    "OPTIONAL", "OUT",    "PI",         "STRICT",  "Status",    "Success",
    "TRUE",   "True", "VOID",     "YES",     "cdecl",    "emit",   "far",        "foreach", "interface", "max",
    "min",    "near", "nil",      "pascal",  "signals",  "slots",  "small",
});

// Never iterated: it decides no order.
const std::unordered_set<std::string_view>& reserved() {
  static const std::unordered_set<std::string_view> names = [] {
    std::unordered_set<std::string_view> all(kKeywords.begin(), kKeywords.end());
    all.insert(kStandardMacros.begin(), kStandardMacros.end());
    all.insert(kPlatformMacros.begin(), kPlatformMacros.end());
    return all;
  }();
  return names;
}

}  // namespace

bool is_reserved(const std::string& name) {
  return reserved().count(name) > 0;
}

}  // namespace robcogen::backend::cpp
