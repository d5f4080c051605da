// Functions of a module as a handler of XLA, which JAX calls without Python (robcogen/jax.py registers it).
//
// The structures are those of version 0.1 of XLA's typed foreign function interface. They are declared here, so that a
// module needs no header of XLA, and one file serves every JAX that supports this version: later versions append
// members.
#pragma once

#include <cstdint>
#include <numeric>

#include "robcogen/python/computation.h"

namespace robcogen::python::xla {

inline constexpr int kMajorVersion = 0, kMinorVersion = 1;
inline constexpr int kMetadata = 1, kScalar = 3;               // types of extensions and attributes
inline constexpr int kInteger = 5, kFloat = 11, kDouble = 12;  // types of numbers
inline constexpr int kInvalidArgument = 3, kOutOfMemory = 8;   // codes of errors

struct Extension {
  std::size_t bytes;
  int type;
  Extension* next;
};
struct Version {
  std::size_t bytes;
  Extension* extensions;
  int of_interface, of_additions;  // major, minor
};
struct Metadata {
  std::size_t bytes;
  Version version;
  std::uint32_t traits;
};
struct MetadataExtension {
  Extension base;
  Metadata* metadata;
};
struct Error;
struct NewError {
  std::size_t bytes;
  Extension* extensions;
  const char* message;
  int code;
};
struct Interface {
  std::size_t bytes;
  Extension* extensions;
  Version version;
  void* internal;
  Error* (*create_error)(NewError*);
};
struct Buffer {
  std::size_t bytes;
  Extension* extensions;
  int type;
  void* data;
  std::int64_t rank;
  std::int64_t* lengths;
};
struct Buffers {
  std::size_t bytes;
  Extension* extensions;
  std::int64_t count;
  int* types;
  Buffer** items;
};
struct Scalar {
  int type;
  void* value;
};
struct Attributes {
  std::size_t bytes;
  Extension* extensions;
  std::int64_t count;
  int* types;
  void** names;
  Scalar** items;
};
struct Frame {
  std::size_t bytes;
  Extension* extensions;
  const Interface* interface;
  void* context;
  int stage;
  Buffers arguments, results;
  Attributes attributes;
};

// One call: arrays with the same number of leading dimensions, in each of which an argument has the length of the
// results, or 1 if it is the same for all.
class Call {
 public:
  Call(const State& module, const Frame& frame) : frame_(frame) { entry_.module = &module; }

  // Returns an error for the user; empty if there is none.
  std::string run() {
    std::string error = find_function();
    if (error.empty()) error = read_buffers();
    if (!error.empty() || states_ == 0) return error;
    merge_dimensions();
    for (std::ptrdiff_t first = 0; first < states_; first += together_) {
      error = compute_from(first);
      if (!error.empty()) return error;
    }
    return "";
  }

 private:
  struct Array {
    const Argument* argument;
    const Buffer* buffer;
    std::ptrdiff_t size;                     // numbers of a state
    std::vector<std::int64_t> leading = {};  // lengths
    bool is_same = true, varies = true;      // for all states; in every leading dimension
  };

  const Frame& frame_;
  Entry entry_;
  const Variant* variant_ = nullptr;
  std::vector<Array> inputs_, outputs_;
  std::vector<std::int64_t> leading_;
  std::ptrdiff_t states_ = 1, together_ = 1;
  int type_ = kDouble;

  std::string find_function() {
    const Attributes& attributes = frame_.attributes;
    const bool has_index =
        attributes.count == 1 && attributes.types[0] == kScalar && attributes.items[0]->type == kInteger;
    const List<Function>& functions = entry_.module->tables->functions;
    const std::int64_t index = has_index ? *static_cast<const std::int64_t*>(attributes.items[0]->value) : -1;
    if (index < 0 || index >= static_cast<std::int64_t>(functions.size()))
      return "a module of robcogen: the attribute is not the index of a function";
    entry_.function = &functions[static_cast<std::size_t>(index)];
    for (const Variant& v : entry_.function->variants)
      if (v.inputs == frame_.arguments.count) variant_ = &v;
    const auto results = static_cast<std::int64_t>(entry_.function->results.size());
    const bool fits = variant_ && results > 0 && frame_.results.count == results;
    return fits ? "" : named("the number of arrays is wrong");
  }

  std::string named(const std::string& what) const { return entry_.function->name + (": " + what); }

  // The shape of the array for one state. That of parameters is of their values.
  std::vector<std::ptrdiff_t> shape_of(const Argument& a) const {
    if (a.is_parameters) return {static_cast<std::ptrdiff_t>(entry_.module->tables->parameters.names.size())};
    std::vector<std::ptrdiff_t> shape;
    for (int d = 0; d < a.rank; ++d) shape.push_back(length(a, d));
    return shape;
  }

  std::string read_buffers() {
    type_ = frame_.results.items[0]->type;
    if (type_ != kDouble && type_ != kFloat) return named("arrays must be float64 or float32");
    for (std::int64_t k = 0; k < frame_.results.count; ++k)
      if (std::string error =
              read(entry_.function->results[static_cast<std::size_t>(k)], *frame_.results.items[k], outputs_);
          !error.empty())
        return error;
    leading_ = outputs_[0].leading;
    for (const std::int64_t length : leading_) states_ *= length;
    for (std::int64_t k = 0; k < frame_.arguments.count; ++k)
      if (std::string error =
              read(entry_.function->arguments[static_cast<std::size_t>(k)], *frame_.arguments.items[k], inputs_);
          !error.empty())
        return error;
    return "";
  }

  std::string read(const Argument& argument, const Buffer& buffer, std::vector<Array>& list) {
    const std::vector<std::ptrdiff_t> shape = shape_of(argument);
    const std::int64_t lead = buffer.rank - static_cast<std::int64_t>(shape.size());
    bool fits = lead >= 0 && buffer.type == type_ && std::equal(shape.begin(), shape.end(), buffer.lengths + lead);
    Array array{
        &argument, &buffer, std::accumulate(shape.begin(), shape.end(), std::ptrdiff_t{1}, std::multiplies<>())};
    if (fits) array.leading.assign(buffer.lengths, buffer.lengths + lead);
    const bool is_output = &list == &outputs_;
    const std::vector<std::int64_t> wanted = outputs_.empty() ? array.leading : outputs_[0].leading;
    fits = fits && array.leading.size() == wanted.size();
    for (std::size_t d = 0; fits && d < wanted.size(); ++d) {
      fits = array.leading[d] == wanted[d] || (!is_output && array.leading[d] == 1);
      array.is_same = array.is_same && array.leading[d] == 1;
      array.varies = array.varies && array.leading[d] == wanted[d];
    }
    if (!fits) return named(std::string(argument.name) + " has a wrong shape or type");
    list.push_back(std::move(array));
    return "";
  }

  // Finds how many states can be computed together: all, or those of the last dimension if an argument varies in some
  // dimensions only; one if the parameters vary, as functions over many states have the same for all.
  void merge_dimensions() {
    together_ = states_;
    for (const Array& a : inputs_) {
      if (a.argument->is_parameters && !a.is_same) together_ = 1;
      if (!a.is_same && !a.varies) together_ = std::min<std::ptrdiff_t>(together_, leading_.back());
    }
  }

  // The place of a state in an array, counted in states.
  std::ptrdiff_t place(const Array& a, std::ptrdiff_t state) const {
    if (a.varies) return state;
    std::ptrdiff_t result = 0, stride = 1;
    for (std::size_t d = leading_.size(); d-- > 0; state /= leading_[d]) {
      if (a.leading[d] == 1) continue;
      result += state % leading_[d] * stride;
      stride *= a.leading[d];
    }
    return result;
  }

  void* data(const Array& a, std::ptrdiff_t state) const {
    return static_cast<char*>(a.buffer->data) + place(a, state) * a.size * (type_ == kFloat ? 4 : 8);
  }

  std::string compute_from(std::ptrdiff_t first) {
    const char letter = type_ == kFloat ? 'f' : 'd';
    Inputs inputs;
    Results results;
    inputs.variant = variant_;
    inputs.is_float = type_ == kFloat;
    inputs.is_batch = true;
    inputs.states = together_;
    Parameters parameters(*entry_.module->tables);
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      const Array& a = inputs_[k];
      View& view = inputs.views.add(k);
      if (a.argument->is_parameters) {
        inputs.caches = parameters.of(data(a, first), type_);
        continue;
      }
      const bool differs = a.varies || (!a.is_same && a.leading.back() != 1);
      view.set_memory(data(a, first), letter, differs ? together_ : 1, *a.argument);
      if (const std::string wrong = wrong_quaternion(*a.argument, view); !wrong.empty()) return named(wrong);
      view.broadcast();
    }
    for (std::size_t r = 0; r < outputs_.size(); ++r)
      results.views.add(r).set_memory(data(outputs_[r], first), letter, together_, *outputs_[r].argument);
    compute(entry_, inputs, results);
    return "";
  }

  // What the library computes from values of the parameters.
  class Parameters {
   public:
    explicit Parameters(const Module& module) : table_(module.parameters) {}
    Parameters(const Parameters&) = delete;
    Parameters& operator=(const Parameters&) = delete;
    ~Parameters() {
      if (caches_) table_.destroy(caches_);
    }
    const void* of(const void* values, int type) {
      std::vector<double> numbers(table_.names.size());
      for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = type == kFloat ? static_cast<const float*>(values)[i] : static_cast<const double*>(values)[i];
      return caches_ = table_.make(numbers.data());
    }

   private:
    const ParameterTable& table_;
    void* caches_ = nullptr;
  };
};

// The module whose functions the handler calls. Each shared library has a variable of its own.
static State module_of_handler;  // NOLINT

inline Error* fail(const Frame& frame, const std::string& message, int code) {
  NewError error = {offsetof(NewError, code) + sizeof(int), nullptr, message.c_str(), code};
  return frame.interface->create_error(&error);
}

inline Error* handler(Frame* frame) {
  if (frame->extensions && frame->extensions->type == kMetadata) {
    Metadata& metadata = *reinterpret_cast<MetadataExtension*>(frame->extensions)->metadata;
    metadata.version.of_interface = kMajorVersion;
    metadata.version.of_additions = kMinorVersion;
    return nullptr;
  }
  if (frame->bytes < sizeof(Frame)) return fail(*frame, "this version of XLA is not supported", kInvalidArgument);
  try {
    const std::string error = Call(module_of_handler, *frame).run();
    return error.empty() ? nullptr : fail(*frame, error, kInvalidArgument);
  } catch (const std::bad_alloc&) {
    return fail(*frame, "out of memory", kOutOfMemory);
  }
}

// The handler as JAX registers it.
inline PyObject* capsule(const Module& module) {
  module_of_handler.tables = &module;
  return PyCapsule_New(reinterpret_cast<void*>(&handler), nullptr, nullptr);
}

}  // namespace robcogen::python::xla
