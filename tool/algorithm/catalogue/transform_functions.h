// Coordinate transforms without a robot: every program of a document of transforms.
#pragma once

#include <string>
#include <vector>

#include "algorithm/kinematics/kinematics.h"
#include "algorithm/kinematics/primitive_product.h"
#include "model/coordinate_transforms.h"
#include "symbolic/function.h"

namespace robcogen::algorithm {

// The arguments that the primitives of a transform depend on.
struct Arguments {
  std::vector<int> variables;  // indices into the document's, in its order
  bool parameters = false;     // all of the document's, or none
};
Arguments arguments_of(const model::CoordinateTransforms& document, const model::CoordinateTransform& transform);
// All arguments of the document.
Arguments all_arguments(const model::CoordinateTransforms& document);

// parameters, variables -> X. An array that would be empty is left out.
symbolic::Program transform_program(
    const model::CoordinateTransforms& document,
    const model::CoordinateTransform& transform,
    TransformForm form,
    const std::string& name);

// The product as the document writes it, for primitives of this convention: parameters, variables -> amounts.
PrimitiveProduct primitive_product(
    const model::CoordinateTransforms& document,
    const model::CoordinateTransform& transform,
    model::MovedFramePosition position,
    const Arguments& arguments);

// The user's name, or `A_X_B`.
std::string name_of(const model::CoordinateTransform& transform);

// All functions of the document.
std::vector<symbolic::Function> transform_functions(const model::CoordinateTransforms& document);

}  // namespace robcogen::algorithm
