// What robcogen.jax and robcogen.torch read of a module. It is made when they are used, as `module.jax` and
// `module.torch`: nothing of it takes time when a module is imported.
#pragma once

#include "robcogen/python/xla.h"

namespace robcogen::python {

// An attribute of another module. Returns a new reference, or null with an exception.
inline PyObject* imported(const char* module, const char* name) {
  PyObject* const from = PyImport_ImportModule(module);
  PyObject* const object = from ? PyObject_GetAttrString(from, name) : nullptr;
  Py_DecRef(from);
  return object;
}

// (name, shape, quaternions, whether the library stores a matrix by rows, whether these are parameters)
inline PyObject* description(const Module& module, const Argument& a) {
  PyObject* const quaternions = PyTuple_New(static_cast<Py_ssize_t>(a.quaternions.size()));
  for (std::size_t i = 0; quaternions && i < a.quaternions.size(); ++i)
    PyTuple_SetItem(quaternions, static_cast<Py_ssize_t>(i), PyLong_FromLong(a.quaternions[i]));
  PyObject* const shape = a.is_parameters
                              ? Py_BuildValue("(n)", static_cast<Py_ssize_t>(module.parameters.names.size()))
                              : lengths(a, false, 1);
  return Py_BuildValue(
      "(sNNNN)", a.name, shape, quaternions, PyBool_FromLong(a.is_by_rows ? 1 : 0),
      PyBool_FromLong(a.is_parameters ? 1 : 0));
}

inline PyObject* descriptions(const Module& module, const List<Argument>& arguments) {
  PyObject* const list = PyList_New(0);
  for (const Argument& a : arguments) {
    PyObject* const item = list ? description(module, a) : nullptr;
    if (item) PyList_Append(list, item);
    Py_DecRef(item);
  }
  return list;
}

// [(scope, name, arguments, how many of them are required, how many each overload takes, results), …], in the order of
// the handler of XLA.
inline PyObject* descriptions(const Module& module) {
  PyObject* const list = PyList_New(0);
  for (const Function& f : module.functions) {
    PyObject* const overloads = PyList_New(0);
    for (const Variant& v : f.variants) {
      PyObject* const count = PyLong_FromLong(v.inputs);
      if (overloads && count) PyList_Append(overloads, count);
      Py_DecRef(count);
    }
    PyObject* const item = Py_BuildValue(
        "(ssNiNN)", f.scope, f.name, descriptions(module, f.arguments), f.required, overloads,
        descriptions(module, f.results));
    if (list && item) PyList_Append(list, item);
    Py_DecRef(item);
  }
  return list;
}

// The functions of the module for tensors of PyTorch or for arrays of JAX, which the module keeps from then on.
inline PyObject* functions_for(PyObject* module, const char* library) {
  const std::string layer = std::string("robcogen.") + library;
  PyObject* const make = imported(layer.c_str(), "functions");
  if (!make) {
    PyObject *type, *error, *trace;
    PyErr_Fetch(&type, &error, &trace);
    PyObject* const name = error ? PyObject_GetAttrString(error, "name") : nullptr;
    if (!name) PyErr_Clear();
    const bool is_missing = name && (PyUnicode_CompareWithASCIIString(name, "robcogen") == 0 ||
                                     PyUnicode_CompareWithASCIIString(name, layer.c_str()) == 0);
    Py_DecRef(name);
    if (!is_missing) {
      PyErr_Restore(type, error, trace);
      return nullptr;
    }
    Py_DecRef(type);
    Py_DecRef(error);
    Py_DecRef(trace);
    PyErr_Format(
        PyExc_ImportError,
        "there is no module %s: it is part of the Python package of robcogen, in share/robcogen/python of an "
        "installation or "
        "runtime/python of the sources, which must be in PYTHONPATH or installed with pip",
        layer.c_str());
    return nullptr;
  }
  PyObject* const functions = PyObject_CallFunctionObjArgs(make, module, nullptr);
  Py_DecRef(make);
  if (functions && PyObject_SetAttrString(module, library, functions) == 0) return functions;
  Py_DecRef(functions);
  return nullptr;
}

// `__getattr__` of the module (PEP 562): attributes that are made when they are used.
inline PyObject* attribute_on_demand(PyObject* module, PyObject* name) {
  const State& state = **static_cast<State**>(PyModule_GetState(module));
  const auto is = [&](const char* text) {
    return PyUnicode_Check(name) && PyUnicode_CompareWithASCIIString(name, text) == 0;
  };
  for (const char* library : {"jax", "torch"})
    if (is(library)) return functions_for(module, library);
  if (is("_functions")) return descriptions(*state.tables);
  if (is("_xla_handler")) return xla::capsule(*state.tables);
  PyErr_Format(PyExc_AttributeError, "module '%s' has no attribute '%S'", state.name.c_str(), name);
  return nullptr;
}

inline bool add_attributes_on_demand(PyObject* module) {
  static PyMethodDef methods[] = {{"__getattr__", &attribute_on_demand, METH_O, nullptr}, {}};
  return PyModule_AddFunctions(module, methods) == 0;
}

}  // namespace robcogen::python
