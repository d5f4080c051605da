// Internal to this folder: conversion between the coordinates of a library and those of generated code.
#pragma once

#include "peers/peer.h"

namespace robcogen::peers {

// (base, joints) for a floating base, otherwise only the joints.
inline Eigen::VectorXd coordinates(
    bool floating,
    const Eigen::Matrix<double, 6, 1>& base,
    const Eigen::VectorXd& joints) {
  if (!floating) return joints;
  Eigen::VectorXd all(6 + joints.size());
  all << base, joints;
  return all;
}

// For each coordinate in the order of generated code, with the base's angular ones first, its index in the library.
using Order = std::vector<Eigen::Index>;

inline Eigen::VectorXd to_library(const Order& order, const Eigen::VectorXd& ours) {
  Eigen::VectorXd theirs(ours.size());
  theirs(order) = ours;
  return theirs;
}

// A vector.
inline Eigen::MatrixXd vector_from_library(const Order& order, const Eigen::VectorXd& theirs) {
  return theirs(order);
}

// A matrix whose rows and columns are coordinates.
inline Eigen::MatrixXd matrix_from_library(const Order& order, const Eigen::MatrixXd& theirs) {
  return theirs(order, order);
}

}  // namespace robcogen::peers
