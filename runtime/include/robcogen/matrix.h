// The matrix type of arguments and results, and what it needs of the compiler's options.
#pragma once

#include <Eigen/Core>

#include "robcogen/layout.h"

// Eigen aligns vectors to what the processor options allow, so the layout of a structure that holds vectors depends on
// options such as -mavx. A tag in the type's linked name tells the layouts apart: where files of one program that were
// compiled for different layouts pass each other such a structure, the program does not link.
#if EIGEN_MAX_STATIC_ALIGN_BYTES == 16 || !defined(__GNUC__)
#define ROBCOGEN_ALIGNED
#elif EIGEN_MAX_STATIC_ALIGN_BYTES == 64
#define ROBCOGEN_ALIGNED __attribute__((__abi_tag__("eigen_aligns_to_64")))
#elif EIGEN_MAX_STATIC_ALIGN_BYTES == 32
#define ROBCOGEN_ALIGNED __attribute__((__abi_tag__("eigen_aligns_to_32")))
#elif EIGEN_MAX_STATIC_ALIGN_BYTES == 8
#define ROBCOGEN_ALIGNED __attribute__((__abi_tag__("eigen_aligns_to_8")))
#else
#define ROBCOGEN_ALIGNED __attribute__((__abi_tag__("eigen_does_not_align")))
#endif

namespace robcogen {

// Kernels write matrices column by column, so the type states its storage order, whatever EIGEN_DEFAULT_TO_ROW_MAJOR
// says. Eigen stores a row by rows only; its elements are in the same order.
template <class Scalar, int kRows, int kColumns>
using Matrix = Eigen::Matrix<Scalar, kRows, kColumns, kRows == 1 && kColumns != 1 ? Eigen::RowMajor : Eigen::ColMajor>;

// A matrix whose size is known at run time.
template <class Scalar>
using DynamicMatrix = Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

}  // namespace robcogen
