// Arrays for the results of a call: those given as `out`, or new ones, which are numpy arrays if there is numpy.
#pragma once

#include "robcogen/python/inputs.h"

namespace robcogen::python {

// The shape of a result, as a tuple.
inline PyObject* lengths(const Argument& a, bool is_batch, std::ptrdiff_t states) {
  PyObject* const tuple = PyTuple_New(a.rank + (is_batch ? 1 : 0));
  Py_ssize_t k = 0;
  if (is_batch) PyTuple_SetItem(tuple, k++, PyLong_FromSsize_t(states));
  for (int d = 0; d < a.rank; ++d) PyTuple_SetItem(tuple, k++, PyLong_FromLong(length(a, d)));
  return tuple;
}

// A memoryview for a result, for use without numpy.
inline PyObject* memory(const Argument& a, bool is_float, bool is_batch, std::ptrdiff_t states) {
  const std::ptrdiff_t bytes = states * size(a) * (is_float ? 4 : 8);
  PyObject* const array = PyByteArray_FromStringAndSize(nullptr, bytes);
  PyObject* const view = array ? PyMemoryView_FromObject(array) : nullptr;
  PyObject* const shape = lengths(a, is_batch, states);
  PyObject* const cast =
      view && shape && bytes > 0 ? PyObject_CallMethod(view, "cast", "sO", is_float ? "f" : "d", shape) : nullptr;
  if (view && bytes == 0) PyErr_SetString(PyExc_ValueError, "arrays without elements need numpy");
  Py_DecRef(shape);
  Py_DecRef(view);
  Py_DecRef(array);
  return cast;
}

inline PyObject* empty_array(const Entry& entry, std::size_t r, bool is_float, bool is_batch, std::ptrdiff_t states) {
  const Argument& a = entry.function->results[r];
  const State& module = *entry.module;
  if (!module.numpy_empty) return memory(a, is_float, is_batch, states);
  if (!is_batch) return PyObject_CallObject(module.numpy_empty, entry.shapes[2 * r + (is_float ? 1 : 0)]);
  PyObject* const shape = lengths(a, true, states);
  PyObject* const array =
      PyObject_CallFunctionObjArgs(module.numpy_empty, shape, module.types[is_float ? 1 : 0], nullptr);
  Py_DecRef(shape);
  return array;
}

struct Results {
  PyObject* arrays[kMaxArrays];
  std::size_t count = 0;
  Views views;

  Results() = default;
  Results(const Results&) = delete;
  Results& operator=(const Results&) = delete;
  ~Results() {
    for (std::size_t r = 0; r < count; ++r) Py_DecRef(arrays[r]);
  }
};

// Whether the array given for result r can take it. Its view is already among those of the results.
inline bool check_out(const Entry& entry, const Inputs& inputs, const Results& results, std::size_t r) {
  const Function& function = *entry.function;
  const Argument& result = function.results[r];
  const std::string name = std::string("out for ") + result.name;
  const View& out = results.views[r];
  if (out.is_float() != inputs.is_float)
    return refuse(
        entry, name + " must be " + (inputs.is_float ? "float32, like the arguments" : "float64, like the arguments"));
  if (out.is_batch() != inputs.is_batch || out.states() != inputs.states) {
    const std::string states = std::to_string(inputs.states);
    return refuse(
        entry, name + " must have the shape " + shape(result, inputs.is_batch ? states : "") + ", has " +
                   shape(result, out.is_batch() ? std::to_string(out.states()) : ""));
  }
  if (out.overlaps_itself()) return refuse(entry, name + " has elements that share memory");
  for (std::size_t k = 0; k < inputs.count(); ++k)
    if (!function.arguments[k].is_parameters && out.overlaps(inputs.views[k]))
      return refuse(entry, name + " overlaps " + function.arguments[k].name);
  for (std::size_t k = 0; k < r; ++k)
    if (out.overlaps(results.views[k])) return refuse(entry, name + " overlaps that for " + function.results[k].name);
  return true;
}

// `out` is an array, a tuple of arrays, or null. Returns whether it succeeded; otherwise an exception is set.
inline bool prepare_results(const Entry& entry, PyObject* out, const Inputs& inputs, Results& results) {
  const Function& function = *entry.function;
  const std::size_t count = function.results.size();
  const bool is_tuple = out && (count != 1 || PyTuple_Check(out));
  if (is_tuple && (!PyTuple_Check(out) || PyTuple_Size(out) != static_cast<Py_ssize_t>(count)))
    return refuse(entry, "out must be a tuple of " + std::to_string(count) + " arrays");
  for (std::size_t r = 0; r < count; ++r) {
    PyObject* array = nullptr;
    if (out) {
      array = is_tuple ? PyTuple_GetItem(out, static_cast<Py_ssize_t>(r)) : out;
      Py_IncRef(array);
    } else {
      array = empty_array(entry, r, inputs.is_float, inputs.is_batch, inputs.states);
    }
    if (!array) return false;
    results.arrays[results.count++] = array;
    if (!results.views.add(r).read_result(array, function.results[r], function.name)) return false;
    if (out && !check_out(entry, inputs, results, r)) return false;
  }
  return true;
}

}  // namespace robcogen::python
