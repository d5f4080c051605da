// Random robots with congruent and mirrored limbs, as documents of the kinematics language.
#pragma once

#include <cstdint>
#include <string>

namespace robcogen::test {

// One or two sets of two to six limbs with one to five joints, on a fixed or floating base, or on a trunk that is one
// joint away from it. Limbs may carry limbs, as hands carry fingers. Copies of a limb are mirrored in coordinate
// planes, and may differ in zeros, in rounding or in single values. Angles are multiples of a right angle, nearly such
// multiples, tiny, or arbitrary; lengths and masses may be parameters.
//
// The document depends only on the seed, on every platform: no distributions of the standard library are used.
std::string limbed_document(std::uint64_t seed);

}  // namespace robcogen::test
