// Threads that share the calls of a task, for functions over many states (robcogen/parallel.h).
//
// Link the threads of the system: Threads::Threads in CMake.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace robcogen::batch {

// A few threads that wait for work. Construction allocates; calls do not, and any thread may call.
class ThreadPool {
 public:
  // `count` threads work at a time, including the caller. Throws std::system_error if the system has too few threads.
  explicit ThreadPool(unsigned count = std::thread::hardware_concurrency()) {
    workers_.threads.reserve(count);
    for (unsigned i = 1; i < count; ++i) workers_.threads.emplace_back([this] { wait_for_work(); });
  }
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  unsigned threads() const noexcept { return static_cast<unsigned>(workers_.threads.size()) + 1; }

  // Calls task(0), …, task(count - 1), each once, in any order, and returns when all have ended. The task must not
  // throw. While another thread's task runs, or within a task, the caller alone makes the calls.
  template <class Task>
  void operator()(std::ptrdiff_t count, const Task& task) noexcept {
    Work work(count, &task, [](const void* t, std::ptrdiff_t i) noexcept { (*static_cast<const Task*>(t))(i); });
    const bool is_shared = count > 1 && publish(&work);
    work.take();
    if (is_shared) withdraw();
  }

 private:
  // The calls of one task, which several threads take one after another.
  class Work {
   public:
    using Call = void (*)(const void* task, std::ptrdiff_t i) noexcept;

    Work(std::ptrdiff_t count, const void* task, Call call) noexcept : count_(count), task_(task), call_(call) {}

    void take() noexcept {
      for (std::ptrdiff_t i = next_++; i < count_; i = next_++) call_(task_, i);
    }

   private:
    std::atomic<std::ptrdiff_t> next_ = 0;
    std::ptrdiff_t count_;
    const void* task_;
    Call call_;
  };

  // Ends the threads, even if the constructor throws after some have started.
  struct Workers {
    explicit Workers(ThreadPool* owner) noexcept : pool(owner) {}
    ~Workers() {
      {
        const std::lock_guard lock(pool->mutex_);
        pool->ends_ = true;
      }
      pool->start_.notify_all();
      for (std::thread& thread : threads) thread.join();
    }

    ThreadPool* pool;
    std::vector<std::thread> threads;
  };

  // False if there is work already.
  bool publish(Work* work) {
    {
      const std::lock_guard lock(mutex_);
      if (work_ != nullptr || working_ != 0) return false;
      work_ = work;
      ++round_;
    }
    start_.notify_all();
    return true;
  }

  // Returns when no thread works on the task any more. A thread that wakes up late finds no work.
  void withdraw() {
    std::unique_lock lock(mutex_);
    work_ = nullptr;
    end_.wait(lock, [this] { return working_ == 0; });
  }

  void wait_for_work() {
    std::unique_lock lock(mutex_);
    for (std::uint64_t seen = 0;;) {
      start_.wait(lock, [&] { return ends_ || round_ != seen; });
      if (ends_) return;
      seen = round_;
      Work* const work = work_;
      if (work == nullptr) continue;
      ++working_;
      lock.unlock();
      work->take();
      lock.lock();
      if (--working_ == 0) end_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable start_, end_;
  Work* work_ = nullptr;
  std::uint64_t round_ = 0;  // number of tasks that were published
  int working_ = 0;          // threads that work on the task, without the caller
  bool ends_ = false;
  Workers workers_{this};  // last: destroyed first
};

}  // namespace robcogen::batch
