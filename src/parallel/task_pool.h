#pragma once
// The one owner of threads. No other room starts, joins or counts them.

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>

namespace glint {

/// The number of cores that this process may use, at least 1.
int available_threads();

/// Thrown by TaskPool::run() where the pool's flag was set.
class TasksCancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "cancelled"; }
};

/// Exactly `threads` threads, the caller's among them, parked between jobs.
class TaskPool {
  public:
    /// 0: available_threads(). Once `cancel` is set, no task begins any more.
    explicit TaskPool(int threads = 0, const std::atomic<bool>* cancel = nullptr);
    ~TaskPool();
    TaskPool(const TaskPool&) = delete;
    TaskPool& operator=(const TaskPool&) = delete;

    int threads() const;

    /// Calls body(task, worker) once for each task in [0, count), worker in [0, threads()), and returns when
    /// all are done. Worker w begins with task w, so that every thread takes part whenever count ≥ threads();
    /// the rest is handed out in order. The first exception ends the hand-out and is thrown again here;
    /// TasksCancelled where tasks were left out because the pool was cancelled. Not reentrant.
    void run(std::size_t count, const std::function<void(std::size_t task, int worker)>& body);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint
