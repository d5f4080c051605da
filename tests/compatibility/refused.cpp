// What the first RobCoGen had and these headers cannot serve: each is one message that names what to use
// (check_refused.cmake).
#include <iit/robots/fixed/declarations.h>

// expected: model_constants.h is not offered: <fixed_walker/reflection.h> has the numbers of the model
#include <iit/robots/fixed/model_constants.h>
#include <iit/robots/fixed/traits.h>

namespace old = iit::FixedWalker;

// expected: a fixed base has no getWholeBodyInertia(): InertiaProperties has the inertia of each link
void a(const old::dyn::JSIM& jsim) {
  jsim.getWholeBodyInertia();
}
// expected: a fixed base has no getF(): the JSIM has the rows of the joints only
void b(const old::dyn::JSIM& jsim) {
  jsim.getF();
}
// expected: a fixed base has no getFixedBaseBlock(): it is the JSIM itself
void c(const old::dyn::JSIM& jsim) {
  jsim.getFixedBaseBlock();
}
// expected: this robot does not have the function: robcogen ops MODEL lists those that it has, with the reasons
void d() {
  robcogen::compatibility::call<old::compatibility::Robot>(
      robcogen::compatibility::Absent(), robcogen::compatibility::NoParameters());
}
