// The contract between generated code and this runtime.
#pragma once

namespace robcogen {

// Raised when code from an older generator would no longer compile or behave the same. Generated headers assert that
// they were generated for this number.
inline constexpr int kAbi = 1;

}  // namespace robcogen
