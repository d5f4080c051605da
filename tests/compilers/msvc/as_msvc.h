// Included before everything else: what follows sees the macros of MSVC, and any construct of gcc in it is an error. The headers
// of the standard library and of Eigen, which have a version for each compiler, come first, with the macros of the real one.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <complex>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <Eigen/LU>

#undef __GNUC__
#undef __GNUC_MINOR__
#undef __clang__
#undef __x86_64__
#undef __linux__
#undef __unix__
#define _MSC_VER 1938
#define _M_X64 100
#define _WIN32 1

#define __attribute__(...) msvc_refuses_attributes
#define __asm__ msvc_refuses_asm
#define __extension__ msvc_refuses_extension
#define __typeof__ msvc_refuses_typeof
#define __has_builtin(x) msvc_has_no_builtins
#define __builtin_sqrt msvc_has_no_builtins
#define __builtin_sqrtf msvc_has_no_builtins
#define __builtin_atan2 msvc_has_no_builtins
#define __builtin_atan2f msvc_has_no_builtins
#define __builtin_fma msvc_has_no_builtins
#define __builtin_fmaf msvc_has_no_builtins
#define __builtin_expect msvc_has_no_builtins
#define __builtin_unreachable msvc_has_no_builtins
#define __builtin_cpu_supports msvc_has_no_builtins
#define __builtin_convertvector msvc_has_no_builtins
#define __builtin_shufflevector msvc_has_no_builtins
