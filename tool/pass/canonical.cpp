#include "pass/passes.h"
#include "pass/rebuild.h"

namespace robcogen::pass {

symbolic::Program canonical(symbolic::Program program) {
  Rebuild rebuild(program);
  for (std::size_t i = 0; i < program.statements.size(); ++i) {
    rebuild.enter_section_of(i);
    rebuild.set(i, rebuild.compute(i));
  }
  return rebuild.finish();
}

}  // namespace robcogen::pass
