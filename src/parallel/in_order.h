#pragma once

#include "parallel/task_pool.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace glint {

/// Makes things on all threads of a pool and takes them one by one in the order of their tasks, so that what
/// is put together from them depends on no thread. make(task, worker, made) overwrites a Made, which may have
/// been used before; take(task, made) is called for 0, 1, 2 … as soon as all before are taken, by one thread
/// at a time, for which the others do not wait. Only what is not taken yet is kept. Exceptions as from
/// TaskPool::run(); after one nothing more is taken.
template <class Made, class Make, class Take>
void run_in_order(TaskPool& pool, std::size_t count, const Make& make, const Take& take) {
    std::mutex mutex;
    std::map<std::size_t, Made> waiting;
    std::vector<Made> used;
    std::size_t next = 0; ///< to be taken
    bool is_taking = false;

    const auto empty = [&] {
        const std::lock_guard lock(mutex);
        if (used.empty()) return Made();
        Made made = std::move(used.back());
        used.pop_back();
        return made;
    };
    pool.run(count, [&](std::size_t task, int worker) {
        Made made = empty();
        make(task, worker, made);
        std::unique_lock lock(mutex);
        waiting.emplace(task, std::move(made));
        if (is_taking) return;
        is_taking = true; // for good, where take() throws
        while (!waiting.empty() && waiting.begin()->first == next) {
            auto first = waiting.extract(waiting.begin());
            lock.unlock();
            take(first.key(), std::as_const(first.mapped()));
            lock.lock();
            used.push_back(std::move(first.mapped()));
            ++next;
        }
        is_taking = false;
    });
}

} // namespace glint
