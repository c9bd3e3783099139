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
/// at a time. Only what is finished ahead of its turn is kept. Exceptions as from TaskPool::run().
template <class Made, class Make, class Take>
void run_in_order(TaskPool& pool, std::size_t count, const Make& make, const Take& take) {
    std::mutex mutex;
    std::size_t next = 0;
    std::map<std::size_t, Made> early;
    std::vector<Made> used;

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
        const std::lock_guard lock(mutex);
        early.emplace(task, std::move(made));
        for (auto at = early.begin(); at != early.end() && at->first == next; at = early.erase(at)) {
            const std::size_t turn = std::exchange(next, count); // which is nobody's, should this one fail
            take(turn, std::as_const(at->second));
            used.push_back(std::move(at->second));
            next = turn + 1;
        }
    });
}

} // namespace glint
