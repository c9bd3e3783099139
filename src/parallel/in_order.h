#pragma once
// A pipeline with parallel producers and one ordered consumer.

#include "parallel/task_pool.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace glint::parallel {

/// Produces items on all threads of a pool and consumes them in task order, so the result does not depend on
/// scheduling. produce(task, worker, item) overwrites an Item, which may be a recycled one.
/// consume(task, item) is called for tasks 0, 1, 2 … by one thread at a time; the other threads keep
/// producing meanwhile. Only items not consumed yet are held. Throws like TaskPool::run(); after an exception
/// nothing more is consumed.
template <class Item, class Produce, class Consume>
void run_in_order(TaskPool& pool, std::size_t count, const Produce& produce, const Consume& consume) {
    std::mutex mutex;
    std::map<std::size_t, Item> waiting;
    std::vector<Item> recycled;
    std::size_t next = 0; ///< task to consume next
    bool is_consuming = false;

    const auto new_item = [&] {
        const std::lock_guard lock(mutex);
        if (recycled.empty()) return Item();
        Item item = std::move(recycled.back());
        recycled.pop_back();
        return item;
    };
    pool.run(count, [&](std::size_t task, int worker) {
        Item item = new_item();
        produce(task, worker, item);
        std::unique_lock lock(mutex);
        waiting.emplace(task, std::move(item));
        if (is_consuming) return;
        is_consuming = true; // stays set if consume() throws
        while (!waiting.empty() && waiting.begin()->first == next) {
            auto first = waiting.extract(waiting.begin());
            lock.unlock();
            consume(first.key(), std::as_const(first.mapped()));
            lock.lock();
            recycled.push_back(std::move(first.mapped()));
            ++next;
        }
        is_consuming = false;
    });
}

} // namespace glint::parallel
