// What the values of a program are, as data: names of values are text made from it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robcogen::symbolic {

struct Quantity;
using QuantityRef = std::shared_ptr<const Quantity>;  // null if nothing is known about a value

// A quantity of the field: an element of the angular velocity w of a link, of the wrench (n, f) of a joint on a link,
// of the joint-space inertia matrix H, …; or what operations make of other quantities.
struct Quantity {
  enum class Form {
    value,
    lane,          // of a, a value with lanes
    product,       // a b
    square,        // a^2
    sum,           // a + b
    difference,    // a - b
    rotated,       // a component after a rotation by an angle, with sine or cosine b, that leaves component a in place
                   // if the angle is zero
    moved,         // a about another point
    inverse,       // 1 / a
    root,          // the square root of a
    sum_of_lanes,  // of a
    sine,          // of the angle a
    cosine,
    sine_cosine,  // sin a cos a
    double_sine,  // sin 2a
    double_cosine
  };

  std::string subject = {};    // what it belongs to: a link, a joint, a frame; the row of a matrix over coordinates
  std::string symbol = {};     // of the field: w, wd, a, n, f, I, h, U, D, u, H, …
  std::string element = {};    // of a vector or matrix: x, yz
  std::string second = {};     // the second of a pair: the link at which a joint moves something; the column
  std::string qualifier = {};  // which of several with one symbol: own (of the link itself), U, U_by_D, …
  std::string state = {};      // P: about the origin of the parent, in its axes; free: behind a joint that moves freely
  bool of_coordinates = false;  // an element of a vector or matrix over joints or coordinates
  bool negative = false;
  Form form = Form::value;
  QuantityRef a = {}, b = {};  // of other forms
  int lane = -1;
};

// The names of a link's quantities differ in the last part; the first part is shared: `hip`, `wx`.
struct NameParts {
  std::string stem, last;
};

NameParts parts_of(const Quantity& quantity);

// The name without its sign, and with it: `hip_wx`, `hip_wx_neg`, `H_HAA_HFE`.
//
//     hip_nx_P                 in axes of the parent
//     hip_wx_wy, hip_wx2       products and squares
//     s2_KFE, sc_KFE           sin^2 and sin cos of an angle; s_2KFE, c_2KFE: sine and cosine of twice the angle
//     hip_Uxy                  elements of U = [wd]x + [w]x [w]x, the acceleration per position vector
//     hip_Sxx_plus_Syy         sums of two values of one link
//     hip_fx_by_HAA            a component after a rotation by the angle of a joint
//     hip_nx_moved             plus a multiple of another quantity of the link: the same about another point
std::string unsigned_text(const Quantity& quantity);
std::string text(const Quantity& quantity);

// The angle of a sine or cosine, as names refer to it: `KFE`, `2KFE`; empty for other quantities.
std::string angle_of(const Quantity& quantity);
bool is_sine(const Quantity& quantity);
bool is_cosine(const Quantity& quantity);

// Quantities made from others, whose signs do not count.
Quantity made(Quantity::Form form, QuantityRef a, QuantityRef b = nullptr);
Quantity product(Quantity a, Quantity b);

// What corresponding values of congruent limbs have in common: `hip_wx` for LF_hip_wx, RF_hip_wx_neg, …. A value that
// one limb shares with another part of the robot does not count.
std::optional<Quantity> common_quantity(const std::vector<QuantityRef>& lanes);

}  // namespace robcogen::symbolic
