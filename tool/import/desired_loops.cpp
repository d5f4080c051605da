#include "import/desired_loops.h"

#include <utility>

namespace robcogen::import {

namespace desired = language::desired;

namespace {

void instantiate(desired::Name& name, const desired::Loop& loop, const desired::Name& instance) {
  if (name.instance != loop.variable.text) return;
  name.instance = instance.text;
  name.instance_span = instance.span;
}

void instantiate(desired::Pair& pair, const desired::Loop& loop, const desired::Name& instance) {
  instantiate(pair.left, loop, instance);
  instantiate(pair.right, loop, instance);
}

void instantiate(desired::Contact& contact, const desired::Loop& loop, const desired::Name& instance) {
  instantiate(contact.frame, loop, instance);
}

void instantiate(desired::Inverse& inverse, const desired::Loop& loop, const desired::Name& instance) {
  instantiate(inverse.pair, loop, instance);
}

template <class T>
std::vector<T> unrolled(const std::vector<T>& list, const std::vector<desired::Loop>& loops) {
  std::vector<T> result;
  for (std::size_t begin = 0, end = 0; begin < list.size(); begin = end) {
    const int number = loop_of(list[begin]);
    while (end < list.size() && loop_of(list[end]) == number) ++end;
    if (number == desired::Name::kNoLoop) {
      result.insert(
          result.end(), list.begin() + static_cast<std::ptrdiff_t>(begin),
          list.begin() + static_cast<std::ptrdiff_t>(end));
      continue;
    }
    const desired::Loop& loop = loops[static_cast<std::size_t>(number)];
    for (const desired::Name& instance : loop.instances)
      for (std::size_t i = begin; i < end; ++i) {
        result.push_back(list[i]);
        instantiate(result.back(), loop, instance);
      }
  }
  return result;
}

}  // namespace

desired::Document unrolled(const desired::Document& document) {
  desired::Document result = document;
  result.frames = unrolled(document.frames, document.loops);
  result.transforms = unrolled(document.transforms, document.loops);
  result.jacobians = unrolled(document.jacobians, document.loops);
  result.contacts = unrolled(document.contacts, document.loops);
  result.inverses = unrolled(document.inverses, document.loops);
  return result;
}

}  // namespace robcogen::import
