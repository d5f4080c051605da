// Functions of a generated library as functions of a Python module. The generated source has tables and calls; this
// does the rest: arguments by position and keyword, states and many states, results. Errors are ValueError and
// TypeError that name the function and the argument.
#pragma once

#include <algorithm>
#include <new>
#include <type_traits>
#include <utility>

#include "robcogen/batch.h"
#include "robcogen/python/arrays.h"

namespace robcogen::python {

template <class Scalar>
using Kernel = void (*)(const Scalar* const* in, Scalar* const* out);
template <class Scalar>
using Batch = void (*)(
    std::ptrdiff_t n,
    const Scalar* parameters,
    const batch::Strided<const Scalar>* in,
    const batch::Strided<Scalar>* out);

// An overload: the first `inputs` arguments.
struct Variant {
  int inputs;
  Kernel<double> in_double;
  Kernel<float> in_float;
  Batch<double> batch_in_double;  // or nullptr
  Batch<float> batch_in_float;
};

struct Function {
  const char* scope;  // `transforms.homogeneous`, or empty
  const char* name;
  const char* documentation;
  std::vector<Argument> arguments;
  int required;
  std::vector<Argument> results;
  std::vector<Variant> variants;  // fewest inputs first
};

// What parameters are for the library; all null without any.
struct ParameterTable {
  std::vector<const char*> names;
  std::vector<double> defaults;  // not a number: none
  void* (*make)(const double* values);
  void (*destroy)(void* caches);
  const double* (*in_double)(const void* caches);
  const float* (*in_float)(const void* caches);
};

struct LimbElement {
  const char* own;
  int index;
};

// An instance of a part in the document (robcogen/limb.h).
struct Limb {
  const char* name;
  const char* part;
  int first_link;
  std::vector<LimbElement> links, joints, frames;
};

struct Module {
  const char* name;
  const char* documentation;
  std::vector<Function> functions;
  ParameterTable parameters;
  std::vector<const char*> joints, positions, links, frames;  // positions: the elements of q
  std::vector<int> parents;                                   // by link; -1: the base
  std::vector<double> lower, upper, velocity, effort;
  std::vector<Limb> limbs = {};
};

inline constexpr int kMaxArrays = 32;
inline constexpr std::ptrdiff_t kBlock = 64;  // states whose arrays are copied at a time: they stay in the cache
inline constexpr double kStandardGravity[3] = {0, 0, -9.81};

// What belongs to a function while the module lives.
struct Entry {
  const Module* module = nullptr;
  const Function* function = nullptr;
  std::string name;  // `hyl.inverse_dynamics`
  std::vector<PyObject*> keywords;
  PyTypeObject* structure = nullptr;
  std::vector<PyObject*> shapes;  // arguments of numpy.empty for one state: of each result in double, then in float
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

// The arguments by their places, out behind them; null: not given.
inline bool place(const Entry& entry, PyObject* const* args, Py_ssize_t count, PyObject* names, PyObject** given) {
  const std::size_t most = entry.function->arguments.size();
  if (count > static_cast<Py_ssize_t>(most))
    return refuse(
        entry, "takes " + std::to_string(most) + " arguments, " + std::to_string(count) + " are given",
        PyExc_TypeError);
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

// Numbers of one state, on the stack where they are few.
template <class Scalar>
class Scratch {
 public:
  Scalar* take(std::ptrdiff_t count) {
    if (used_ + count <= kFew) {
      used_ += count;
      return few_ + used_ - count;
    }
    many_.emplace_back(new Scalar[static_cast<std::size_t>(count)]);
    return many_.back().get();
  }

 private:
  static constexpr std::ptrdiff_t kFew = 512;
  Scalar few_[kFew];
  std::ptrdiff_t used_ = 0;
  std::vector<std::unique_ptr<Scalar[]>> many_;
};

// A tuple of the lengths of a result.
inline PyObject* lengths(const Argument& a, bool is_batch, std::ptrdiff_t states) {
  PyObject* const tuple = PyTuple_New(a.rank + (is_batch ? 1 : 0));
  Py_ssize_t k = 0;
  if (is_batch) PyTuple_SetItem(tuple, k++, PyLong_FromSsize_t(states));
  if (a.rank > 0) PyTuple_SetItem(tuple, k++, PyLong_FromLong(a.rows));
  if (a.rank > 1) PyTuple_SetItem(tuple, k++, PyLong_FromLong(a.columns));
  return tuple;
}

// Without numpy: a memoryview.
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

inline PyObject* empty_array(Entry& entry, std::size_t r, bool is_float, bool is_batch, std::ptrdiff_t states) {
  const Argument& a = entry.function->results[r];
  if (!numpy_empty) return memory(a, is_float, is_batch, states);
  if (!is_batch) return PyObject_CallObject(numpy_empty, entry.shapes[2 * r + (is_float ? 1 : 0)]);
  PyObject* const shape = lengths(a, true, states);
  PyObject* const array = PyObject_CallFunctionObjArgs(numpy_empty, shape, types[is_float ? 1 : 0], nullptr);
  Py_DecRef(shape);
  return array;
}

// Views by their places; only those that are used are made.
class Views {
 public:
  Views() = default;
  Views(const Views&) = delete;
  Views& operator=(const Views&) = delete;
  ~Views() {
    for (std::size_t k = 0; k < count_; ++k) (*this)[k].~View();
  }
  // Those up to this place exist from now on.
  View& add(std::size_t k) {
    for (; count_ <= k; ++count_) new (memory_ + count_ * sizeof(View)) View;
    return (*this)[k];
  }
  View& operator[](std::size_t k) { return *std::launder(reinterpret_cast<View*>(memory_ + k * sizeof(View))); }

 private:
  std::size_t count_ = 0;
  alignas(View) unsigned char memory_[kMaxArrays * sizeof(View)];
};

// A call: its arguments as views, what it computes, its results.
class Call {
 public:
  Call(Entry& entry, PyObject** given) : entry_(entry), function_(*entry.function), given_(given) {}
  ~Call() {
    for (std::size_t r = 0; r < made_count_; ++r) Py_DecRef(made_[r]);
  }

  PyObject* run() {
    if (!choose_variant() || !read_inputs()) return nullptr;
    return is_float_ ? run_as<float>() : run_as<double>();
  }

 private:
  Entry& entry_;
  const Function& function_;
  PyObject** given_;
  const Variant* variant_ = nullptr;
  const void* caches_ = nullptr;
  Views in_, out_;
  PyObject* made_[kMaxArrays];
  std::size_t made_count_ = 0;
  bool is_float_ = false, is_batch_ = false;
  std::ptrdiff_t states_ = 1;

  std::size_t inputs() const { return static_cast<std::size_t>(variant_->inputs); }

  bool choose_variant() {
    int last = function_.required;
    for (std::size_t k = 0; k < function_.arguments.size(); ++k)
      if (given_[k]) last = std::max(last, static_cast<int>(k) + 1);
    for (const Variant& v : function_.variants)
      if (!variant_ && v.inputs >= last) variant_ = &v;
    return variant_ != nullptr;
  }

  bool read_inputs() {
    bool has_float = false, has_double = false;
    const char* first = nullptr;
    for (std::size_t k = 0; k < inputs(); ++k) {
      const Argument& a = function_.arguments[k];
      if (a.is_parameters) {
        in_.add(k);
        if (PyObject_TypeCheck(given_[k], parameters_type) == 0)
          return refuse(entry_, "parameters must be of the type Parameters of the module", PyExc_TypeError);
        caches_ = reinterpret_cast<ParametersObject*>(given_[k])->caches;
        continue;
      }
      View& view = in_.add(k);
      if (!given_[k]) {
        const bool is_gravity = std::strcmp(a.name, "gravity") == 0;
        if (!is_gravity && std::strcmp(a.name, "external") != 0)
          return refuse(entry_, std::string(a.name) + " is missing", PyExc_TypeError);
        const std::vector<double> zeros(static_cast<std::size_t>(size(a)), 0.0);
        view.set_constant(is_gravity ? kStandardGravity : zeros.data(), a);
        continue;
      }
      if (!view.read(given_[k], a, function_.name)) return false;
      (view.is_float() ? has_float : has_double) |= view.is_array();
      if (!view.is_batch()) continue;
      is_batch_ = true;
      if (view.states() == 1) continue;
      if (first && view.states() != states_)
        return refuse(
            entry_, std::string(first) + " has " + std::to_string(states_) + " states, " + a.name + " has " +
                        std::to_string(view.states()));
      first = a.name;
      states_ = view.states();
    }
    is_float_ = has_float && !has_double;
    for (std::size_t k = 0; k < inputs(); ++k) in_[k].broadcast();
    return true;
  }

  template <class Scalar>
  PyObject* run_as() {
    if (!prepare_results()) return nullptr;
    if (!is_batch_) {
      compute<Scalar>();
    } else {
      PyThreadState* const thread = PyEval_SaveThread();
      compute<Scalar>();
      PyEval_RestoreThread(thread);
    }
    return collect();
  }

  const Argument& result(std::size_t r) const { return function_.results[r]; }

  bool prepare_results() {
    PyObject* const out = given_[function_.arguments.size()];
    const std::size_t count = function_.results.size();
    const bool is_tuple = out && (count != 1 || PyTuple_Check(out));
    if (is_tuple && (!PyTuple_Check(out) || PyTuple_Size(out) != static_cast<Py_ssize_t>(count)))
      return refuse(entry_, "out must be a tuple of " + std::to_string(count) + " arrays");
    for (std::size_t r = 0; r < count; ++r) {
      PyObject* array = nullptr;
      if (out) {
        array = is_tuple ? PyTuple_GetItem(out, static_cast<Py_ssize_t>(r)) : out;
        Py_IncRef(array);
      } else {
        array = empty_array(entry_, r, is_float_, is_batch_, states_);
      }
      if (!array) return false;
      made_[made_count_++] = array;
      if (!out_.add(r).read_result(array, result(r), function_.name)) return false;
      if (out && !check_out(r)) return false;
    }
    return true;
  }

  bool check_out(std::size_t r) {
    const std::string name = std::string("out for ") + result(r).name;
    View& out = out_[r];
    if (out.is_float() != is_float_)
      return refuse(
          entry_, name + " must be " + (is_float_ ? "float32, like the arguments" : "float64, like the arguments"));
    if (out.is_batch() != is_batch_ || out.states() != states_) {
      const std::string states = std::to_string(states_);
      return refuse(
          entry_, name + " must have the shape " + shape(result(r), is_batch_ ? states : "") + ", has " +
                      shape(result(r), out.is_batch() ? std::to_string(out.states()) : ""));
    }
    if (out.overlaps_itself()) return refuse(entry_, name + " has elements that share their place");
    for (std::size_t k = 0; k < inputs(); ++k)
      if (!function_.arguments[k].is_parameters && out.overlaps(in_[k]))
        return refuse(entry_, name + " overlaps " + function_.arguments[k].name);
    for (std::size_t k = 0; k < r; ++k)
      if (out.overlaps(out_[k])) return refuse(entry_, name + " overlaps that for " + result(k).name);
    return true;
  }

  template <class Scalar>
  const Scalar* caches() const {
    if (!caches_) return nullptr;
    const ParameterTable& table = entry_.module->parameters;
    if constexpr (sizeof(Scalar) == 4) {
      return table.in_float(caches_);
    } else {
      return table.in_double(caches_);
    }
  }

  template <class Scalar>
  void compute() {
    if (is_batch_ && states_ > 1 && compute_together<Scalar>()) return;
    Scratch<Scalar> scratch;
    const Scalar* in[kMaxArrays];
    Scalar *copies[kMaxArrays] = {}, *out[kMaxArrays], *results[kMaxArrays] = {};
    for (std::ptrdiff_t state = 0; state < states_; ++state) {
      for (std::size_t k = 0; k < inputs(); ++k) {
        if (function_.arguments[k].is_parameters) {
          in[k] = caches<Scalar>();
          continue;
        }
        in[k] = in_[k].template in_place<Scalar>(state);
        if (in[k]) continue;
        if (!copies[k]) copies[k] = scratch.take(size(function_.arguments[k]));
        in_[k].gather(state, copies[k]);
        in[k] = copies[k];
      }
      for (std::size_t r = 0; r < function_.results.size(); ++r) {
        out[r] = out_[r].template in_place<Scalar>(state);
        if (out[r]) continue;
        if (!results[r]) results[r] = scratch.take(size(result(r)));
        out[r] = results[r];
      }
      call(in, out);
      for (std::size_t r = 0; r < function_.results.size(); ++r)
        if (out[r] == results[r]) out_[r].scatter(state, out[r]);
    }
  }

  void call(const double* const* in, double* const* out) const { variant_->in_double(in, out); }
  void call(const float* const* in, float* const* out) const { variant_->in_float(in, out); }

  // By the functions over many states, where the library has them. Arrays that these cannot read or write in place go
  // through copies, of a block of states at a time.
  template <class Scalar>
  bool compute_together() {
    const Batch<Scalar> function = many<Scalar>();
    if (!function) return false;
    batch::Strided<const Scalar> in[kMaxArrays] = {};
    batch::Strided<Scalar> out[kMaxArrays] = {};
    Scalar *copies[kMaxArrays] = {}, *results[kMaxArrays] = {};
    Scratch<Scalar> scratch;
    std::ptrdiff_t block = states_;
    for (std::size_t k = 0; k < inputs(); ++k) {
      const Argument& a = function_.arguments[k];
      if (a.is_parameters || place(in_[k], in[k])) continue;
      const bool is_same = !in_[k].is_batch() || in_[k].states() == 1;
      if (!is_same) block = std::min(block, kBlock);
      Scalar* const copy = scratch.take(size(a) * (is_same ? 1 : kBlock));
      in[k] = {copy, 1, is_same ? 0 : size(a)};
      if (is_same)
        in_[k].gather(0, copy);
      else
        copies[k] = copy;
    }
    for (std::size_t r = 0; r < function_.results.size(); ++r) {
      if (place(out_[r], out[r])) continue;
      block = std::min(block, kBlock);
      results[r] = scratch.take(size(result(r)) * kBlock);
      out[r] = {results[r], 1, size(result(r))};
    }
    for (std::ptrdiff_t first = 0; first < states_; first += block) {
      const std::ptrdiff_t count = std::min(block, states_ - first);
      for (std::size_t k = 0; k < inputs(); ++k)
        if (copies[k]) in_[k].gather(first, count, copies[k]);
      function(count, caches<Scalar>(), in, out);
      for (std::size_t r = 0; r < function_.results.size(); ++r)
        if (results[r]) out_[r].scatter(first, count, results[r]);
      for (std::size_t k = 0; k < inputs(); ++k)
        if (!copies[k]) in[k].data += block * in[k].state;
      for (std::size_t r = 0; r < function_.results.size(); ++r)
        if (!results[r]) out[r].data += block * out[r].state;
    }
    return true;
  }

  template <class Scalar>
  Batch<Scalar> many() const {
    if constexpr (sizeof(Scalar) == 4) {
      return variant_->batch_in_float;
    } else {
      return variant_->batch_in_double;
    }
  }

  // Whether the functions over many states can read or write the array where it is; `states` is it then.
  template <class Number>
  static bool place(const View& view, batch::Strided<Number>& states) {
    states.data = view.template first<Number>();
    return view.template strides<std::remove_const_t<Number>>(states.element, states.state);
  }

  PyObject* finished(std::size_t r) {
    PyObject* const array = made_[r];
    if (result(r).rank > 0 || is_batch_ || given_[function_.arguments.size()]) {
      Py_IncRef(array);
      return array;
    }
    double number = 0;
    out_[r].gather(0, &number);
    return PyFloat_FromDouble(number);
  }

  PyObject* collect() {
    if (function_.results.size() == 1) return finished(0);
    PyObject* const structure = PyStructSequence_New(entry_.structure);
    if (!structure) return nullptr;
    for (std::size_t r = 0; r < function_.results.size(); ++r)
      PyStructSequence_SetItem(structure, static_cast<Py_ssize_t>(r), finished(r));
    return structure;
  }
};

inline PyObject* call(PyObject* self, PyObject* const* args, Py_ssize_t count, PyObject* names) {
  Entry& entry = *static_cast<Entry*>(PyCapsule_GetPointer(self, nullptr));
  PyObject* given[kMaxArrays + 1] = {};
  if (!place(entry, args, count, names, given)) return nullptr;
  try {
    return Call(entry, given).run();
  } catch (const std::bad_alloc&) {
    return PyErr_NoMemory();
  }
}

}  // namespace robcogen::python
