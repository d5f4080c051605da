// Data of a module and of its functions, and the arguments of a call by position and keyword.
#pragma once

#include "robcogen/python/tables.h"

namespace robcogen::python {

inline constexpr std::size_t kMaxArrays = 64;

// The name of an object's type, for messages.
inline std::string type_name(PyObject* object) {
  PyObject* const name = PyType_GetName(Py_TYPE(object));
  PyObject* const text = name ? PyUnicode_AsUTF8String(name) : nullptr;
  std::string result = text ? PyBytes_AsString(text) : "object";
  Py_DecRef(text);
  Py_DecRef(name);
  PyErr_Clear();
  return result;
}

// What the functions and types of a module share. Nothing is shared between modules, so that modules of different
// robots, or of one robot with different options, can have the same name. A state and the entries are never deleted, as
// Python unloads no module.
struct State {
  const Module* tables = nullptr;
  std::string name;                   // of the module, as `import` knows it
  PyObject* numpy_empty = nullptr;    // numpy's function; null without numpy
  PyObject* types[2] = {};            // numpy.float64 and float32
  PyObject* named_tuple = nullptr;    // collections.namedtuple
  PyObject* parameters = nullptr;     // the type of parameters; null if there are none
  PyObject* function_data = nullptr;  // the type of FunctionData
  std::string name_of_parameters, documentation_of_parameters, name_of_function_data;
  std::vector<PyGetSetDef> members;  // of the type of parameters
};

// Data of a function.
struct Entry {
  const State* module = nullptr;
  const Function* function = nullptr;
  std::vector<PyObject*> keywords;
  PyObject* structure = nullptr;  // the type of several results, a named tuple
  std::vector<PyObject*> shapes;  // arguments of numpy.empty for one state: for each result in double, then in float
  PyMethodDef method = {};
};

struct ParametersObject {
  PyObject_HEAD void* caches;
  double* values;
  const ParameterTable* table;
};

// The `self` of a function.
struct FunctionData {
  PyObject_HEAD const Entry* entry;
};

inline bool refuse(const Entry& entry, const std::string& what, PyObject* type = PyExc_ValueError) {
  PyErr_SetString(type, (entry.function->name + (": " + what)).c_str());
  return false;
}

// Whether the object holds parameters of the entry's module; otherwise an exception is set.
inline bool check_parameters(const Entry& entry, PyObject* object, bool is_named) {
  PyTypeObject* const type = Py_TYPE(object);
  if (reinterpret_cast<PyObject*>(type) == entry.module->parameters) return true;
  const std::string given = type_name(object);
  const std::string wanted = "must be Parameters of the module, ";
  if (given == "Parameters")
    return refuse(entry, "parameters " + wanted + "not those of another module", PyExc_TypeError);
  const std::string start = is_named ? "parameters " : "parameters is missing: the first argument ";
  return refuse(entry, start + wanted + "is a " + given, PyExc_TypeError);
}

// Writes the arguments to `given` in the order of the function's arguments, then `out`; null if not given. Returns
// whether it succeeded; otherwise an exception is set.
inline bool place(const Entry& entry, PyObject* const* args, Py_ssize_t count, PyObject* names, PyObject** given) {
  const Function& function = *entry.function;
  const std::size_t most = function.arguments.size();
  const bool has_parameters = most > 0 && function.arguments[0].is_parameters;
  if (has_parameters && count > 0 && args[0] != Py_None && !check_parameters(entry, args[0], false)) return false;
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
      std::string known;
      for (const Argument& a : function.arguments) known += a.name + std::string(", ");
      PyErr_Format(
          PyExc_TypeError, "%s: unknown argument '%U'; the arguments are %sout", function.name, name, known.c_str());
      return false;
    }
    if (given[k])
      return refuse(
          entry, std::string(k == most ? "out" : function.arguments[k].name) + " is given twice", PyExc_TypeError);
    given[k] = args[count + i];
  }
  for (std::size_t k = 0; k <= most; ++k)
    if (given[k] == Py_None) given[k] = nullptr;
  for (std::size_t k = 0; k < static_cast<std::size_t>(function.required); ++k)
    if (!given[k]) return refuse(entry, std::string(function.arguments[k].name) + " is missing", PyExc_TypeError);
  return !has_parameters || check_parameters(entry, given[0], true);
}

}  // namespace robcogen::python
