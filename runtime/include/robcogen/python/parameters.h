// The type of the parameters of a library: values by name, which cannot change.
#pragma once

#include <cmath>

#include "robcogen/python/arguments.h"

namespace robcogen::python {

inline ParametersObject* parameters_of(PyObject* self) {
  return reinterpret_cast<ParametersObject*>(self);
}

inline const State& state_of_type(PyTypeObject* type) {
  return **static_cast<State**>(PyType_GetModuleState(type));
}

// `a, b, c`
inline std::string list_of(const ParameterTable& table) {
  std::string text;
  for (const char* name : table.names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

inline std::ptrdiff_t find_parameter(const ParameterTable& table, PyObject* name) {
  for (std::size_t i = 0; i < table.names.size(); ++i)
    if (PyUnicode_CompareWithASCIIString(name, table.names[i]) == 0) return static_cast<std::ptrdiff_t>(i);
  return -1;
}

inline void refuse_name(const ParameterTable& table, PyObject* type, PyObject* name) {
  PyErr_Format(type, "Parameters has no '%U'; its names are %s", name, list_of(table).c_str());
}

// Writes the values of these keywords. Returns whether it succeeded; otherwise an exception is set.
inline bool read_parameters(const ParameterTable& table, PyObject* keywords, std::vector<double>& values) {
  PyObject *name = nullptr, *value = nullptr;
  for (Py_ssize_t place = 0; keywords && PyDict_Next(keywords, &place, &name, &value) != 0;) {
    const std::ptrdiff_t i = find_parameter(table, name);
    if (i < 0) {
      refuse_name(table, PyExc_TypeError, name);
      return false;
    }
    const double number = PyFloat_AsDouble(value);
    if (number == -1.0 && PyErr_Occurred()) {
      PyErr_Clear();
      PyErr_Format(PyExc_TypeError, "Parameters: %U must be a number, is a %s", name, type_name(value).c_str());
      return false;
    }
    values[static_cast<std::size_t>(i)] = number;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    PyObject* const given =
        keywords && std::isnan(values[i]) ? PyDict_GetItemString(keywords, table.names[i]) : nullptr;
    if (std::isnan(values[i]) && !given) {
      PyErr_Format(PyExc_ValueError, "Parameters: '%s' has no default: give its value", table.names[i]);
      return false;
    }
  }
  return true;
}

// Parameters(name=value, …). Parameters that are not given have their defaults.
inline PyObject* new_parameters(PyTypeObject* type, PyObject* args, PyObject* keywords) {
  const ParameterTable& table = state_of_type(type).tables->parameters;
  if (PyTuple_Size(args) > 0) {
    PyErr_Format(
        PyExc_TypeError, "Parameters takes keyword arguments only, such as Parameters(%s=1.0)", table.names[0]);
    return nullptr;
  }
  std::vector<double> values(table.defaults.begin(), table.defaults.end());
  if (!read_parameters(table, keywords, values)) return nullptr;
  const auto allocate = reinterpret_cast<allocfunc>(PyType_GetSlot(type, Py_tp_alloc));
  PyObject* const self = allocate(type, 0);
  if (!self) return nullptr;
  ParametersObject* const object = parameters_of(self);
  object->table = &table;
  object->caches = table.make(values.data());
  object->values = new double[values.size()];
  std::copy(values.begin(), values.end(), object->values);
  return self;
}

inline void delete_parameters(PyObject* self) {
  ParametersObject* const object = parameters_of(self);
  if (object->table) object->table->destroy(object->caches);
  delete[] object->values;
  PyTypeObject* const type = Py_TYPE(self);
  reinterpret_cast<freefunc>(PyType_GetSlot(type, Py_tp_free))(self);
  Py_DecRef(reinterpret_cast<PyObject*>(type));
}

inline PyObject* parameter(PyObject* self, void* index) {
  return PyFloat_FromDouble(parameters_of(self)->values[reinterpret_cast<std::size_t>(index)]);
}

// Refuses a name that is not a parameter in words; names of Python's own protocols do not matter to the reader.
inline PyObject* attribute(PyObject* self, PyObject* name) {
  PyObject* const value = PyObject_GenericGetAttr(self, name);
  if (value || PyErr_ExceptionMatches(PyExc_AttributeError) == 0) return value;
  const bool is_special = PyUnicode_GetLength(name) > 0 && PyUnicode_ReadChar(name, 0) == '_';
  if (is_special) return nullptr;
  PyErr_Clear();
  refuse_name(*parameters_of(self)->table, PyExc_AttributeError, name);
  return nullptr;
}

// {'a': 1.0, …}
inline PyObject* dictionary(const ParametersObject& p) {
  PyObject* const result = PyDict_New();
  for (std::size_t i = 0; result && i < p.table->names.size(); ++i) {
    PyObject* const value = PyFloat_FromDouble(p.values[i]);
    if (value) PyDict_SetItemString(result, p.table->names[i], value);
    Py_XDECREF(value);
  }
  return result;
}

inline std::string text_of(double value) {
  PyObject* const number = PyFloat_FromDouble(value);
  PyObject* const text = number ? PyObject_Repr(number) : nullptr;
  PyObject* const bytes = text ? PyUnicode_AsUTF8String(text) : nullptr;
  std::string result = bytes ? PyBytes_AsString(bytes) : "?";
  Py_DecRef(bytes);
  Py_DecRef(text);
  Py_DecRef(number);
  return result;
}

// `Parameters(a=1.0, b=2.0)`
inline PyObject* print_parameters(PyObject* self) {
  const ParametersObject& p = *parameters_of(self);
  std::string text;
  for (std::size_t i = 0; i < p.table->names.size(); ++i)
    text += (i > 0 ? ", " : "") + std::string(p.table->names[i]) + "=" + text_of(p.values[i]);
  return PyUnicode_FromString(("Parameters(" + text + ")").c_str());
}

// For pickle and copy: the call Parameters(a=1.0, …).
inline PyObject* reduce_parameters(PyObject* self, PyObject*) {
  PyObject* const copyreg = PyImport_ImportModule("copyreg");
  PyObject* const make = copyreg ? PyObject_GetAttrString(copyreg, "__newobj_ex__") : nullptr;
  PyObject* const values = make ? dictionary(*parameters_of(self)) : nullptr;
  PyObject* const result = values ? Py_BuildValue("(O(O()O))", make, Py_TYPE(self), values) : nullptr;
  Py_DecRef(values);
  Py_DecRef(make);
  Py_DecRef(copyreg);
  return result;
}

inline PyObject* compare_parameters(PyObject* a, PyObject* b, int operation) {
  if (Py_TYPE(a) != Py_TYPE(b) || (operation != Py_EQ && operation != Py_NE)) {
    Py_IncRef(Py_NotImplemented);
    return Py_NotImplemented;
  }
  const ParametersObject &p = *parameters_of(a), &q = *parameters_of(b);
  const bool is_equal = std::equal(p.values, p.values + p.table->names.size(), q.values);
  return PyBool_FromLong(static_cast<long>(is_equal == (operation == Py_EQ)));
}

inline Py_hash_t hash_parameters(PyObject* self) {
  PyObject* const text = print_parameters(self);
  const Py_hash_t hash = text ? PyObject_Hash(text) : -1;
  Py_DecRef(text);
  return hash;
}

// `Parameters(*, a=1.0, b)`, as Python's `help` and `inspect` read it.
inline std::string documentation_of(const ParameterTable& table) {
  std::string text = "Parameters(*";
  for (std::size_t i = 0; i < table.names.size(); ++i)
    text +=
        ", " + std::string(table.names[i]) + (std::isnan(table.defaults[i]) ? "" : "=" + text_of(table.defaults[i]));
  return text +
         ")\n--\n\nValues of the parameters, by name. A parameter that is not given has its default. The values cannot "
         "change: make others with Parameters(…).";
}

// Makes the type for a module. Returns a new reference.
inline PyObject* type_of_parameters(PyObject* module, State& state) {
  static PyMethodDef methods[] = {
      {"__reduce__", reinterpret_cast<PyCFunction>(&reduce_parameters), METH_NOARGS, nullptr}, {}};
  const ParameterTable& table = state.tables->parameters;
  for (std::size_t i = 0; i < table.names.size(); ++i)
    state.members.push_back({table.names[i], &parameter, nullptr, nullptr, reinterpret_cast<void*>(i)});
  state.members.push_back({});
  state.name_of_parameters = state.name + ".Parameters";
  state.documentation_of_parameters = documentation_of(table);
  PyType_Slot slots[] = {
      {Py_tp_new, reinterpret_cast<void*>(&new_parameters)},
      {Py_tp_dealloc, reinterpret_cast<void*>(&delete_parameters)},
      {Py_tp_getattro, reinterpret_cast<void*>(&attribute)},
      {Py_tp_repr, reinterpret_cast<void*>(&print_parameters)},
      {Py_tp_richcompare, reinterpret_cast<void*>(&compare_parameters)},
      {Py_tp_hash, reinterpret_cast<void*>(&hash_parameters)},
      {Py_tp_methods, methods},
      {Py_tp_getset, state.members.data()},
      {Py_tp_doc, state.documentation_of_parameters.data()},
      {0, nullptr}};
  PyType_Spec spec = {
      state.name_of_parameters.c_str(), sizeof(ParametersObject), 0, Py_TPFLAGS_DEFAULT | Py_TPFLAGS_IMMUTABLETYPE,
      slots};
  return PyType_FromModuleAndSpec(module, &spec, nullptr);
}

}  // namespace robcogen::python
