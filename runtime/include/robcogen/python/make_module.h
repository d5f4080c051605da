// Makes a Python module from the tables of a generated library: functions in their scopes, the type of parameters,
// names and limits of the model.
#pragma once

#include <cmath>

#include "robcogen/python/module.h"

namespace robcogen::python {

// Takes over the reference to `value`.
inline bool add(PyObject* module, const char* name, PyObject* value) {
  const bool is_added = value && PyObject_SetAttrString(module, name, value) == 0;
  Py_DecRef(value);
  return is_added;
}

template <class T, class F>
PyObject* tuple(const std::vector<T>& values, F make) {
  PyObject* const result = PyTuple_New(static_cast<Py_ssize_t>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) PyTuple_SetItem(result, static_cast<Py_ssize_t>(i), make(values[i]));
  return result;
}

inline const Module* module_of_parameters = nullptr;

inline void delete_parameters(PyObject* self) {
  auto* const object = reinterpret_cast<ParametersObject*>(self);
  module_of_parameters->parameters.destroy(object->caches);
  delete[] object->values;
  PyTypeObject* const type = Py_TYPE(self);
  reinterpret_cast<freefunc>(PyType_GetSlot(type, Py_tp_free))(self);
  Py_DecRef(reinterpret_cast<PyObject*>(type));
}

// Parameters(name=value, …). Parameters that are not given have their defaults.
inline PyObject* new_parameters(PyTypeObject* type, PyObject* args, PyObject* keywords) {
  const ParameterTable& table = module_of_parameters->parameters;
  if (PyTuple_Size(args) > 0) {
    PyErr_SetString(PyExc_TypeError, "Parameters takes its values by name");
    return nullptr;
  }
  std::vector<double> values = table.defaults;
  Py_ssize_t taken = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    PyObject* const value = keywords ? PyDict_GetItemString(keywords, table.names[i]) : nullptr;
    if (value) {
      values[i] = PyFloat_AsDouble(value);
      if (PyErr_Occurred()) return nullptr;
      ++taken;
    } else if (std::isnan(values[i])) {
      PyErr_Format(PyExc_ValueError, "Parameters: '%s' has no default: give its value", table.names[i]);
      return nullptr;
    }
  }
  if (keywords && taken < PyDict_Size(keywords)) {
    PyErr_SetString(PyExc_TypeError, "Parameters: a name that is not one of parameter_names");
    return nullptr;
  }
  const auto allocate = reinterpret_cast<allocfunc>(PyType_GetSlot(type, Py_tp_alloc));
  PyObject* const self = allocate(type, 0);
  if (!self) return nullptr;
  auto* const object = reinterpret_cast<ParametersObject*>(self);
  object->caches = table.make(values.data());
  object->values = new double[values.size()];
  std::copy(values.begin(), values.end(), object->values);
  return self;
}

inline PyObject* parameter(PyObject* self, PyObject* name) {
  const ParameterTable& table = module_of_parameters->parameters;
  for (std::size_t i = 0; i < table.names.size(); ++i)
    if (PyUnicode_CompareWithASCIIString(name, table.names[i]) == 0)
      return PyFloat_FromDouble(reinterpret_cast<ParametersObject*>(self)->values[i]);
  return PyObject_GenericGetAttr(self, name);
}

inline bool add_parameters(PyObject* module, const Module& m) {
  if (m.parameters.names.empty()) return true;
  module_of_parameters = &m;
  static const std::string name = std::string(m.name) + ".Parameters";
  static PyType_Slot slots[] = {
      {Py_tp_new, reinterpret_cast<void*>(&new_parameters)},
      {Py_tp_dealloc, reinterpret_cast<void*>(&delete_parameters)},
      {Py_tp_getattro, reinterpret_cast<void*>(&parameter)},
      {Py_tp_doc,
       const_cast<char*>("Values of the parameters, by name. Parameters that are not given have their defaults.")},
      {0, nullptr}};
  static PyType_Spec spec = {
      name.c_str(), sizeof(ParametersObject), 0, Py_TPFLAGS_DEFAULT | Py_TPFLAGS_IMMUTABLETYPE, slots};
  PyObject* const type = PyType_FromSpec(&spec);
  if (!type) return false;
  parameters_type = reinterpret_cast<PyTypeObject*>(type);
  Py_IncRef(type);
  const auto text = [](const char* s) { return PyUnicode_FromString(s); };
  return add(module, "Parameters", type) && add(module, "parameter_names", tuple(m.parameters.names, text));
}

// Returns the module of a scope such as `transforms.homogeneous`, and makes it if there is none. A borrowed reference.
inline PyObject* scope_of(PyObject* module, std::string scope) {
  while (!scope.empty()) {
    const std::size_t end = std::min(scope.find('.'), scope.size());
    const std::string name = scope.substr(0, end);
    if (PyObject_HasAttrString(module, name.c_str()) == 0 && !add(module, name.c_str(), PyModule_New(name.c_str())))
      return nullptr;
    module = PyObject_GetAttrString(module, name.c_str());
    if (!module) return nullptr;
    Py_DecRef(module);  // the enclosing scope holds it
    scope.erase(0, std::min(end + 1, scope.size()));
  }
  return module;
}

// The type of a structure of several results, with their names.
inline PyTypeObject* structure(const Entry& entry) {
  std::vector<PyStructSequence_Field> fields;
  for (const Argument& a : entry.function->results) fields.push_back({a.name, nullptr});
  fields.push_back({nullptr, nullptr});
  static std::vector<std::unique_ptr<std::string>> names;
  names.push_back(std::make_unique<std::string>(entry.name + "_result"));
  PyStructSequence_Desc description = {
      names.back()->c_str(), "Results, by name.", fields.data(), static_cast<int>(fields.size()) - 1};
  return PyStructSequence_NewType(&description);
}

inline bool add_function(PyObject* module, const Module& m, const Function& f) {
  PyObject* const scope = scope_of(module, f.scope);
  if (!scope) return false;
  auto* const entry = new Entry;
  entry->module = &m;
  entry->function = &f;
  entry->name = std::string(m.name) + "." + (*f.scope ? f.scope + std::string(".") : "") + f.name;
  for (const Argument& a : f.arguments) entry->keywords.push_back(PyUnicode_InternFromString(a.name));
  entry->keywords.push_back(PyUnicode_InternFromString("out"));
  if (f.results.size() != 1) entry->structure = structure(*entry);
  for (const Argument& a : f.results)
    for (PyObject* type : types)
      entry->shapes.push_back(type ? Py_BuildValue("(NO)", lengths(a, false, 1), type) : nullptr);
  entry->method.reset(new PyMethodDef{
      f.name, reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(&call)), METH_FASTCALL | METH_KEYWORDS,
      f.documentation});
  // The entry is never deleted, because Python never unloads a module.
  PyObject* const self = PyCapsule_New(entry, nullptr, nullptr);
  PyObject* const name = PyUnicode_FromString(m.name);
  PyObject* const function = self ? PyCFunction_NewEx(entry->method.get(), self, name) : nullptr;
  Py_XDECREF(self);
  Py_XDECREF(name);
  return add(scope, f.name, function);
}

// {'KFE': 2, …}
inline PyObject* indices(const std::vector<LimbElement>& elements) {
  PyObject* const result = PyDict_New();
  for (const LimbElement& e : elements) {
    PyObject* const index = PyLong_FromLong(e.index);
    if (index) PyDict_SetItemString(result, e.own, index);
    Py_XDECREF(index);
  }
  return result;
}

// {'LF': Limb(name='LF', part='Leg', first_link=1, links={…}, joints={…}, frames={…}), …}
inline PyObject* limbs(const Module& m) {
  static PyStructSequence_Field fields[] = {{"name", nullptr},  {"part", nullptr},   {"first_link", nullptr},
                                            {"links", nullptr}, {"joints", nullptr}, {"frames", nullptr},
                                            {nullptr, nullptr}};
  static const std::string name = std::string(m.name) + ".Limb";
  static PyStructSequence_Desc description = {
      name.c_str(),
      "An instance of a part: indices in the robot, by names in the part; indices of joints refer to joint_names.",
      fields, 6};
  PyObject* const result = PyDict_New();
  PyTypeObject* const type = m.limbs.empty() || !result ? nullptr : PyStructSequence_NewType(&description);
  if (!type) return result;
  for (const Limb& l : m.limbs) {
    PyObject* const limb = PyStructSequence_New(type);
    if (!limb) break;
    PyStructSequence_SetItem(limb, 0, PyUnicode_FromString(l.name));
    PyStructSequence_SetItem(limb, 1, PyUnicode_FromString(l.part));
    PyStructSequence_SetItem(limb, 2, PyLong_FromLong(l.first_link));
    PyStructSequence_SetItem(limb, 3, indices(l.links));
    PyStructSequence_SetItem(limb, 4, indices(l.joints));
    PyStructSequence_SetItem(limb, 5, indices(l.frames));
    PyDict_SetItemString(result, l.name, limb);
    Py_DecRef(limb);
  }
  Py_DecRef(reinterpret_cast<PyObject*>(type));
  return result;
}

inline PyObject* make_module(const Module& m) {
  static PyModuleDef definition = {
      PyModuleDef_HEAD_INIT, m.name, m.documentation, -1, nullptr, nullptr, nullptr, nullptr, nullptr};
  PyObject* const module = PyModule_Create(&definition);
  if (!module) return nullptr;
  if (PyObject* const numpy = PyImport_ImportModule("numpy")) {
    numpy_empty = PyObject_GetAttrString(numpy, "empty");
    types[0] = PyObject_GetAttrString(numpy, "float64");
    types[1] = PyObject_GetAttrString(numpy, "float32");
    Py_DecRef(numpy);
  } else {
    PyErr_Clear();
  }
  const auto text = [](const char* s) { return PyUnicode_FromString(s); };
  const auto number = [](double x) { return PyFloat_FromDouble(x); };
  bool is_good = add_parameters(module, m);
  is_good = is_good && add(module, "frame_names", tuple(m.frames, text));
  // Modules without links have only transforms.
  if (!m.links.empty())
    is_good =
        is_good && add(module, "dof", PyLong_FromSize_t(m.joints.size())) &&
        add(module, "joint_names", tuple(m.joints, text)) && add(module, "position_names", tuple(m.positions, text)) &&
        add(module, "link_names", tuple(m.links, text)) &&
        add(module, "link_parents", tuple(m.parents, [](int i) { return PyLong_FromLong(i); })) &&
        add(module, "joint_lower", tuple(m.lower, number)) && add(module, "joint_upper", tuple(m.upper, number)) &&
        add(module, "joint_velocity", tuple(m.velocity, number)) &&
        add(module, "joint_effort", tuple(m.effort, number)) && add(module, "limbs", limbs(m));
  for (const Function& f : m.functions) is_good = is_good && add_function(module, m, f);
  if (is_good) return module;
  Py_DecRef(module);
  return nullptr;
}

}  // namespace robcogen::python
