// Functions of a generated library as functions of a Python module. The generated source has tables and calls; this
// header does the rest: arguments by position and keyword, one state or many, results. Errors are ValueError and
// TypeError, whose messages name the function and the argument.
#pragma once

#include "robcogen/python/computation.h"

namespace robcogen::python {

// Other Python threads can run while it exists.
class WithoutLock {
 public:
  WithoutLock() : thread_(PyEval_SaveThread()) {}
  WithoutLock(const WithoutLock&) = delete;
  WithoutLock& operator=(const WithoutLock&) = delete;
  ~WithoutLock() { PyEval_RestoreThread(thread_); }

 private:
  PyThreadState* thread_;
};

// Returns a new reference to the array of a result, or to a number if the result is one and no array is wanted for it.
inline PyObject* result_object(const Entry& entry, bool is_array, const Results& results, std::size_t r) {
  PyObject* const array = results.arrays[r];
  if (entry.function->results[r].rank > 0 || is_array) {
    Py_IncRef(array);
    return array;
  }
  double number = 0;
  results.views[r].gather(0, &number);
  return PyFloat_FromDouble(number);
}

// Returns the result, or a named tuple of several results.
inline PyObject* collect(const Entry& entry, bool is_array, const Results& results) {
  const std::size_t count = entry.function->results.size();
  if (count == 1) return result_object(entry, is_array, results, 0);
  PyObject* const items = PyTuple_New(static_cast<Py_ssize_t>(count));
  for (std::size_t r = 0; items && r < count; ++r)
    PyTuple_SetItem(items, static_cast<Py_ssize_t>(r), result_object(entry, is_array, results, r));
  PyObject* const arguments = items ? PyTuple_Pack(1, items) : nullptr;
  // A named tuple is made as a tuple is: its own constructor, which is written in Python, takes much longer.
  const auto make = reinterpret_cast<newfunc>(PyType_GetSlot(&PyTuple_Type, Py_tp_new));
  PyObject* const tuple =
      arguments ? make(reinterpret_cast<PyTypeObject*>(entry.structure), arguments, nullptr) : nullptr;
  Py_DecRef(arguments);
  Py_DecRef(items);
  return tuple;
}

// `given` has the arguments in the order of the function's arguments, then `out`.
inline PyObject* call_with(const Entry& entry, PyObject* const* given) {
  PyObject* const out = given[entry.function->arguments.size()];
  Inputs inputs;
  Results results;
  if (!read_inputs(entry, given, inputs) || !prepare_results(entry, out, inputs, results)) return nullptr;
  if (inputs.is_batch) {
    const WithoutLock others_run;
    compute(entry, inputs, results);
  } else {
    compute(entry, inputs, results);
  }
  return collect(entry, inputs.is_batch || out, results);
}

inline PyObject* call(PyObject* self, PyObject* const* args, Py_ssize_t count, PyObject* names) {
  const Entry& entry = *reinterpret_cast<FunctionData*>(self)->entry;
  PyObject* given[kMaxArrays + 1] = {};
  if (!place(entry, args, count, names, given)) return nullptr;
  try {
    return call_with(entry, given);
  } catch (const std::bad_alloc&) {
    return PyErr_NoMemory();
  }
}

}  // namespace robcogen::python
