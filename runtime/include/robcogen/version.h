// The contract between generated code and this runtime.
#pragma once

namespace robcogen {

// Raised when generated code of an older generator would no longer compile or mean the same. Generated headers assert
// that they were made for this number.
inline constexpr int kAbi = 1;

}  // namespace robcogen
