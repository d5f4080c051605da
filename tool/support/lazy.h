// A value that is made on first use.
#pragma once

#include <mutex>
#include <optional>

namespace robcogen {

// Threads may call get() at the same time: one makes the value, the others wait.
template <class T>
class Lazy {
 public:
  template <class Make>
  const T& get(Make make) {
    const std::scoped_lock lock(mutex_);
    if (!value_) value_ = make();
    return *value_;
  }

 private:
  std::mutex mutex_;
  std::optional<T> value_;
};

}  // namespace robcogen
