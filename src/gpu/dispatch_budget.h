#pragma once
// The size of dispatches, adapted to the time that the last ones took: long enough to hide the cost of a
// dispatch, short enough to keep the desktop responsive and to avoid driver timeouts.

#include "glint/gpu.h"
#include "gpu/program.h"

#include <algorithm>
#include <cstdint>

namespace glint::gpu {

class DispatchBudget {
  public:
    static constexpr std::uint32_t max_slots = std::uint32_t{1} << 19;

    explicit DispatchBudget(const GpuLimits& limits)
        : fixed_slots_(limits.pixels > 0), fixed_nodes_(limits.rays > 0) {
        if (fixed_slots_)
            slots_ = (std::min(limits.pixels, max_slots) + GpuProgram::group_size - 1) /
                     GpuProgram::group_size * GpuProgram::group_size;
        if (fixed_nodes_) nodes_ = limits.rays;
        if (limits.steps > 0) steps_ = limits.steps;
    }

    std::uint32_t slots() const { return slots_; } ///< of a dispatch
    std::uint32_t nodes() const { return nodes_; } ///< of ray trees, for each slot
    /// Once a slot's traversals have taken so many steps, its next node waits for the next dispatch. Mesa's
    /// llvmpipe silently ends all loops of eight invocations after 65,535 iterations in total; the next
    /// dispatch finds what was cut short (state_running in slots.glsl).
    std::uint32_t steps() const { return steps_; }

    /// Learns from a dispatch that took `seconds`; `whole`: it had slots().
    void learn(double seconds, bool whole) {
        if (seconds < min_seconds && whole) set_slots(std::min(slots_ * 2, max_slots));
        if (seconds <= max_seconds) return;
        if (slots_ > min_slots)
            set_slots(std::max(slots_ / 2, min_slots));
        else
            set_nodes(std::max(nodes_ / 2, 1u));
    }

    /// Few slots are left: long ray trees of a few slots should not need a dispatch for every four nodes.
    void few_left() { set_nodes(std::min(nodes_ * 2, 256u)); }
    void next_tile() { set_nodes(first_nodes); }

  private:
    static constexpr std::uint32_t min_slots = 64 * GpuProgram::group_size;
    static constexpr std::uint32_t first_nodes = 4;
    static constexpr double min_seconds = 0.01; ///< of a dispatch; below, the next is larger
    static constexpr double max_seconds = 0.06;

    void set_slots(std::uint32_t slots) {
        if (!fixed_slots_) slots_ = slots;
    }
    void set_nodes(std::uint32_t nodes) {
        if (!fixed_nodes_) nodes_ = nodes;
    }

    bool fixed_slots_;
    bool fixed_nodes_;
    std::uint32_t slots_ = min_slots;
    std::uint32_t nodes_ = first_nodes;
    std::uint32_t steps_ = 2048;
};

} // namespace glint::gpu
