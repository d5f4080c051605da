// How large the quantities of a robot are.
#pragma once

#include <string>
#include <string_view>

namespace robcogen::import {

// In SI units, no quantity of a robot is as large as this: products of a few quantities would overflow.
inline constexpr double kTooLarge = 1e15;
// A quantity as small as this is zero: its reciprocal would overflow.
inline constexpr double kZero = 1e-60;

// The message about a quantity that is not below the bound; `what` is its value, or names it.
std::string too_large(std::string_view what);

}  // namespace robcogen::import
