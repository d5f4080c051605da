#include "pass/passes.h"
#include "symbolic/rebuild.h"

namespace robcogen::pass {

symbolic::Program canonical(symbolic::Program program) {
  symbolic::Graph graph;
  symbolic::Rebuild rebuild(graph, program);
  rebuild.keep_all();
  return rebuild.finish();
}

}  // namespace robcogen::pass
