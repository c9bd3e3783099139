#pragma once
// The thread pool. No other part of the library starts or joins threads.

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>

namespace glint::parallel {

/// Thrown by TaskPool::run() if the pool was cancelled.
class TasksCancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "cancelled"; }
};

/// A pool of `threads` threads including the caller's, or of fewer if the system does not start so many;
/// helpers sleep between jobs.
class TaskPool {
  public:
    /// threads = 0: available_threads(). Once `*cancel` is set, no further task starts.
    explicit TaskPool(int threads = 0, const std::atomic<bool>* cancel = nullptr);
    ~TaskPool();
    TaskPool(const TaskPool&) = delete;
    TaskPool& operator=(const TaskPool&) = delete;

    int threads() const;

    /// Calls body(task, worker) once for each task in [0, count), with worker in [0, threads()), and returns
    /// when all are done. Worker w starts with task w, so every thread takes part if count ≥ threads(); the
    /// remaining tasks are handed out in order. The first exception stops the hand-out and is rethrown here;
    /// throws TasksCancelled if cancelling left tasks undone. Not reentrant.
    void run(std::size_t count, const std::function<void(std::size_t task, int worker)>& body);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint::parallel
