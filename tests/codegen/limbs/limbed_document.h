// Random robots with congruent and mirrored limbs, as documents of the kinematics language.
#pragma once

#include <cstdint>
#include <string>

namespace robcogen::test {

// One to two sets of two to six limbs of one to five joints on a fixed or floating base, or on a trunk one joint away
// from it; limbs may carry limbs of their own, as hands do fingers. Copies of a limb are mirrored in coordinate planes,
// and may differ in zeros, in roundings or in single values. Angles are multiples of a right angle, nearly so, tiny, or
// any; lengths and masses may be parameters.
//
// The same document for the same seed, everywhere: written without a library's distributions.
std::string limbed_document(std::uint64_t seed);

}  // namespace robcogen::test
