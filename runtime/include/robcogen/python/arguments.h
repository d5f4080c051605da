// Data of the functions of a module, and the arguments of a call by position and keyword.
#pragma once

#include "robcogen/python/tables.h"

namespace robcogen::python {

inline constexpr int kMaxArrays = 32;

// Data of a function, which exist as long as its module.
struct Entry {
  const Module* module = nullptr;
  const Function* function = nullptr;
  std::string name;  // `hyl.inverse_dynamics`
  std::vector<PyObject*> keywords;
  PyTypeObject* structure = nullptr;
  std::vector<PyObject*> shapes;  // arguments of numpy.empty for one state: for each result in double, then in float
  std::unique_ptr<PyMethodDef> method;
};

inline PyObject* numpy_empty = nullptr;  // numpy's function; null without numpy
inline PyObject* types[2] = {};          // numpy.float64 and float32
inline PyTypeObject* parameters_type = nullptr;
inline PyObject* out_keyword = nullptr;

struct ParametersObject {
  PyObject_HEAD void* caches;
  double* values;
};

inline bool refuse(const Entry& entry, const std::string& what, PyObject* type = PyExc_ValueError) {
  PyErr_SetString(type, (entry.function->name + (": " + what)).c_str());
  return false;
}

// Writes the arguments to `given` in the order of the function's arguments, then `out`; null if not given. Returns
// whether it succeeded; otherwise an exception is set.
inline bool place(const Entry& entry, PyObject* const* args, Py_ssize_t count, PyObject* names, PyObject** given) {
  const std::size_t most = entry.function->arguments.size();
  if (count > static_cast<Py_ssize_t>(most))
    return refuse(
        entry, "takes at most " + std::to_string(most) + " arguments, got " + std::to_string(count), PyExc_TypeError);
  std::copy(args, args + count, given);
  const Py_ssize_t named = names ? PyTuple_Size(names) : 0;
  for (Py_ssize_t i = 0; i < named; ++i) {
    PyObject* const name = PyTuple_GetItem(names, i);
    std::size_t k = 0;
    while (k <= most && entry.keywords[k] != name) ++k;
    for (k = k > most ? 0 : k; k <= most && entry.keywords[k] != name; ++k)
      if (PyUnicode_Compare(entry.keywords[k], name) == 0) break;
    if (k > most) {
      PyErr_Format(PyExc_TypeError, "%s: unknown argument '%U'", entry.function->name, name);
      return false;
    }
    if (given[k])
      return refuse(
          entry, std::string(k == most ? "out" : entry.function->arguments[k].name) + " is given twice",
          PyExc_TypeError);
    given[k] = args[count + i];
  }
  for (std::size_t k = 0; k <= most; ++k)
    if (given[k] == Py_None) given[k] = nullptr;
  for (std::size_t k = 0; k < static_cast<std::size_t>(entry.function->required); ++k)
    if (!given[k])
      return refuse(entry, std::string(entry.function->arguments[k].name) + " is missing", PyExc_TypeError);
  return true;
}

}  // namespace robcogen::python
