// The list of kernels and targets.

#include "ways.h"

#include <vector>

namespace glint::stress {

std::span<const Way> ways() {
    static constexpr Way all[] = {
        {"auto", {}},
        {"scalar", {Kernel::scalar, SimdTarget::plain}},
        {"single plain", {Kernel::single, SimdTarget::plain}},
        {"single sse4", {Kernel::single, SimdTarget::sse4}},
        {"single avx2", {Kernel::single, SimdTarget::avx2}},
        {"single avx512", {Kernel::single, SimdTarget::avx512}},
        {"packet plain", {Kernel::packets, SimdTarget::plain}},
        {"packet sse4", {Kernel::packets, SimdTarget::sse4}},
        {"packet avx2", {Kernel::packets, SimdTarget::avx2}},
        {"packet avx512", {Kernel::packets, SimdTarget::avx512}},
        {"stream plain", {Kernel::streams, SimdTarget::plain}},
        {"stream sse4", {Kernel::streams, SimdTarget::sse4}},
        {"stream avx2", {Kernel::streams, SimdTarget::avx2}},
        {"stream avx512", {Kernel::streams, SimdTarget::avx512}},
    };
    static_assert(std::size(all) <= max_ways);
    static const std::vector<Way> here = [] {
        std::vector<Way> able;
        for (const Way& way : all)
            if (is_available(way.choice.target)) able.push_back(way);
        return able;
    }();
    return here;
}

} // namespace glint::stress
