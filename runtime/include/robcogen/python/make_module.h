// Makes a Python module from the tables of a generated library: functions in their scopes, the type of parameters,
// names and limits of the model.
#pragma once

#include "robcogen/python/description.h"
#include "robcogen/python/module.h"
#include "robcogen/python/parameters.h"

namespace robcogen::python {

// Takes over the reference to `value`.
inline bool add(PyObject* module, const char* name, PyObject* value) {
  const bool is_added = value && PyObject_SetAttrString(module, name, value) == 0;
  Py_DecRef(value);
  return is_added;
}

template <class T, class F>
PyObject* tuple(const List<T>& values, F make) {
  PyObject* const result = PyTuple_New(static_cast<Py_ssize_t>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) PyTuple_SetItem(result, static_cast<Py_ssize_t>(i), make(values[i]));
  return result;
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

// A class of named tuples with these fields, which the module then has under this name: pickles refer to it.
inline PyObject* named_tuple(PyObject* module, const State& state, const std::string& name, PyObject* fields) {
  PyObject* const keywords = Py_BuildValue("{ss}", "module", state.name.c_str());
  PyObject* const arguments = fields ? Py_BuildValue("(sO)", name.c_str(), fields) : nullptr;
  PyObject* const type = keywords && arguments ? PyObject_Call(state.named_tuple, arguments, keywords) : nullptr;
  Py_DecRef(arguments);
  Py_DecRef(keywords);
  if (!type) return nullptr;
  Py_IncRef(type);
  if (add(module, name.c_str(), type)) return type;
  Py_DecRef(type);
  return nullptr;
}

// The class of several results: `transforms_homogeneous_post_X_hook_result`.
inline PyObject* structure(PyObject* module, const State& state, const Function& f) {
  std::string name = (*f.scope ? f.scope + std::string("_") : "") + f.name + "_result";
  std::replace(name.begin(), name.end(), '.', '_');
  PyObject* const fields = tuple(f.results, [](const Argument& a) { return PyUnicode_FromString(a.name); });
  PyObject* const type = named_tuple(module, state, name, fields);
  Py_DecRef(fields);
  return type;
}

// For pickle: a function is found by the name of its module and by its scope.
inline PyObject* reduce_function_data(PyObject* self, PyObject*) {
  const Entry& entry = *reinterpret_cast<FunctionData*>(self)->entry;
  PyObject* const find = imported("pkgutil", "resolve_name");
  const std::string place = entry.module->name + ":" + entry.function->scope;
  PyObject* const result = find ? Py_BuildValue("(O(s))", find, place.c_str()) : nullptr;
  Py_DecRef(find);
  return result;
}

inline PyObject* type_of_function_data(PyObject* module, State& state) {
  static PyMethodDef methods[] = {
      {"__reduce__", reinterpret_cast<PyCFunction>(&reduce_function_data), METH_NOARGS, nullptr}, {}};
  state.name_of_function_data = state.name + ".function";
  PyType_Slot slots[] = {{Py_tp_methods, methods}, {0, nullptr}};
  PyType_Spec spec = {
      state.name_of_function_data.c_str(), sizeof(FunctionData), 0,
      Py_TPFLAGS_DEFAULT | Py_TPFLAGS_IMMUTABLETYPE | Py_TPFLAGS_DISALLOW_INSTANTIATION, slots};
  return PyType_FromModuleAndSpec(module, &spec, nullptr);
}

inline PyObject* function_data(const State& state, const Entry* entry) {
  auto* const type = reinterpret_cast<PyTypeObject*>(state.function_data);
  PyObject* const self = PyType_GenericAlloc(type, 0);
  if (self) reinterpret_cast<FunctionData*>(self)->entry = entry;
  return self;
}

inline bool add_function(PyObject* module, const State& state, const Function& f) {
  if (f.arguments.size() > kMaxArrays || f.results.size() > kMaxArrays) {
    PyErr_Format(PyExc_ImportError, "%s.%s has too many arrays", state.name.c_str(), f.name);
    return false;
  }
  PyObject* const scope = scope_of(module, f.scope);
  if (!scope) return false;
  auto* const entry = new Entry;
  entry->module = &state;
  entry->function = &f;
  for (const Argument& a : f.arguments) entry->keywords.push_back(PyUnicode_InternFromString(a.name));
  entry->keywords.push_back(PyUnicode_InternFromString("out"));
  if (f.results.size() != 1) {
    entry->structure = structure(module, state, f);
    if (!entry->structure) return false;
  }
  for (const Argument& a : f.results) {
    for (PyObject* type : state.types)
      entry->shapes.push_back(type ? Py_BuildValue("(NO)", lengths(a, false, 1), type) : nullptr);
  }
  entry->method = {
      f.name, reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(&call)), METH_FASTCALL | METH_KEYWORDS,
      f.documentation};
  PyObject* const self = function_data(state, entry);
  PyObject* const name = PyUnicode_FromString(state.name.c_str());
  PyObject* const function = self && name ? PyCFunction_NewEx(&entry->method, self, name) : nullptr;
  Py_XDECREF(self);
  Py_XDECREF(name);
  return add(scope, f.name, function);
}

// {'KFE': 2, …}
inline PyObject* indices(const List<LimbElement>& elements) {
  PyObject* const result = PyDict_New();
  for (const LimbElement& e : elements) {
    PyObject* const index = PyLong_FromLong(e.index);
    if (index) PyDict_SetItemString(result, e.own, index);
    Py_XDECREF(index);
  }
  return result;
}

// {'LF': Limb(name='LF', part='Leg', first_link=1, links={…}, joints={…}, frames={…}), …}
inline PyObject* limbs(PyObject* module, const State& state) {
  PyObject* const result = PyDict_New();
  PyObject* const fields = Py_BuildValue("(ssssss)", "name", "part", "first_link", "links", "joints", "frames");
  PyObject* const type = result && fields ? named_tuple(module, state, "Limb", fields) : nullptr;
  Py_DecRef(fields);
  bool is_good = type != nullptr;
  for (const Limb& l : state.tables->limbs) {
    PyObject* const limb = is_good ? PyObject_CallFunction(
                                         type, "(ssiNNN)", l.name, l.part, l.first_link, indices(l.links),
                                         indices(l.joints), indices(l.frames))
                                   : nullptr;
    is_good = limb && PyDict_SetItemString(result, l.name, limb) == 0;
    Py_DecRef(limb);
  }
  Py_DecRef(type);
  if (is_good) return result;
  Py_DecRef(result);
  return nullptr;
}

// The objects of Python and NumPy that functions need.
inline bool import_types(PyObject* module, State& state) {
  state.named_tuple = imported("collections", "namedtuple");
  state.function_data = state.named_tuple ? type_of_function_data(module, state) : nullptr;
  if (!state.function_data) return false;
  state.numpy_empty = imported("numpy", "empty");
  if (!state.numpy_empty) {
    if (PyErr_ExceptionMatches(PyExc_ImportError) == 0) return false;
    PyErr_Clear();
    return true;
  }
  state.types[0] = imported("numpy", "float64");
  state.types[1] = imported("numpy", "float32");
  return state.types[0] && state.types[1];
}

inline bool add_model(PyObject* module, const State& state) {
  const Module& m = *state.tables;
  const auto text = [](const char* s) { return PyUnicode_FromString(s); };
  const auto number = [](double x) { return PyFloat_FromDouble(x); };
  if (!add(module, "frame_names", tuple(m.frames, text))) return false;
  // Modules without links have only transforms.
  return m.links.empty() ||
         (add(module, "dof", PyLong_FromSize_t(m.joints.size())) && add(module, "joint_names", tuple(m.joints, text)) &&
          add(module, "position_names", tuple(m.positions, text)) && add(module, "link_names", tuple(m.links, text)) &&
          add(module, "link_parents", tuple(m.parents, [](int i) { return PyLong_FromLong(i); })) &&
          add(module, "joint_lower", tuple(m.lower, number)) && add(module, "joint_upper", tuple(m.upper, number)) &&
          add(module, "joint_velocity", tuple(m.velocity, number)) &&
          add(module, "joint_effort", tuple(m.effort, number)) && add(module, "limbs", limbs(module, state)));
}

inline bool add_parameters(PyObject* module, State& state) {
  const ParameterTable& table = state.tables->parameters;
  if (table.names.empty()) return true;
  state.parameters = type_of_parameters(module, state);
  if (!state.parameters) return false;
  Py_IncRef(state.parameters);
  const auto text = [](const char* s) { return PyUnicode_FromString(s); };
  return add(module, "Parameters", state.parameters) && add(module, "parameter_names", tuple(table.names, text));
}

// NumPy, whose arrays functions return, works in the first interpreter of a process only.
inline bool check_interpreter(PyObject* name) {
  if (PyInterpreterState_GetID(PyInterpreterState_Get()) == 0) return true;
  PyErr_Format(PyExc_ImportError, "%U cannot be imported in a subinterpreter: import it in the main interpreter", name);
  return false;
}

inline bool fill_module(PyObject* module, const Module& m) {
  PyObject* const name = PyModule_GetNameObject(module);
  PyObject* const bytes = name ? PyUnicode_AsUTF8String(name) : nullptr;
  auto* const state = bytes ? new State : nullptr;
  if (state) state->name = PyBytes_AsString(bytes);
  const bool is_allowed = state && check_interpreter(name);
  Py_DecRef(bytes);
  Py_DecRef(name);
  if (!is_allowed) return false;
  state->tables = &m;
  *static_cast<State**>(PyModule_GetState(module)) = state;
  if (!import_types(module, *state) || !add_parameters(module, *state) || !add_model(module, *state)) return false;
  for (const Function& f : m.functions)
    if (!add_function(module, *state, f)) return false;
  return add_attributes_on_demand(module);
}

// Adds to a new module what the tables say. Returns 0, or -1 with an exception.
inline int execute(PyObject* module, const Module& m) {
  try {
    return fill_module(module, m) ? 0 : -1;
  } catch (const std::bad_alloc&) {
    PyErr_NoMemory();
    return -1;
  }
}

// What the function PyInit_… returns: the definition of a module, which Python makes in a second phase (PEP 489). If it
// were made here, Python would take the module of another robot for this one if they had the same name.
class Definition {
 public:
  Definition(const Module& m, int (*exec)(PyObject*)) {
    std::size_t k = 0;
    slots_[k++] = {Py_mod_exec, reinterpret_cast<void*>(exec)};
    // Slot 3 is Py_mod_multiple_interpreters of Python 3.12, and its value 0 means that they are not supported. Older
    // versions would refuse the slot; `check_interpreter` does its work there.
    constexpr unsigned long kVersion3_12 = 0x030c0000;
    if (Py_Version >= kVersion3_12) slots_[k++] = {3, nullptr};
    definition_.m_name = m.name;
    definition_.m_doc = m.documentation;
    definition_.m_size = sizeof(State*);
    definition_.m_slots = slots_;
  }
  PyObject* initialise() { return PyModuleDef_Init(&definition_); }

 private:
  PyModuleDef_Slot slots_[3] = {};
  PyModuleDef definition_ = {PyModuleDef_HEAD_INIT, nullptr, nullptr, 0, nullptr, nullptr, nullptr, nullptr, nullptr};
};

}  // namespace robcogen::python
