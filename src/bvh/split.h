#pragma once
// Runs of boxes cut in two by the surface area heuristic over bins (Wald, "On fast Construction of SAH-based
// Bounding Volume Hierarchies", 2007). Private to builders.

#include "bvh/quad.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace glint {

/// A box and, in lane 3 of lo, the number of what it bounds. Finite, lo <= hi.
struct Ref {
    Quad lo;
    Quad hi;

    static Ref of(Quad lo, Quad hi, std::uint32_t id) {
        lo[3] = std::bit_cast<float>(id);
        hi[3] = 0.0f;
        return {lo, hi};
    }
    std::uint32_t id() const { return std::bit_cast<std::uint32_t>(lo[3]); }
    QuadBox box() const { return {lo, hi}; }
    /// Half of each summand: the sum of two large coordinates would overflow.
    Quad middle() const { return without_last(lo) * quad(0.5f) + without_last(hi) * quad(0.5f); }
};

/// A run of references, and room behind it for more.
struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t limit = 0; ///< the room's end
    QuadBox box;           ///< of the references
    QuadBox middles;       ///< of their centres
    int depth = 0;
    int misses = 0; ///< of searches for more than a cut between bins, in a row

    std::size_t size() const { return end - begin; }
    std::size_t room() const { return limit - begin; }
    void add(const Ref& ref) {
        box.grow(ref.box());
        middles.grow(ref.middle());
    }
};

/// From this depth on ranges are halved, which ends after at most 32 more levels.
inline constexpr int deepest_search = 60;
inline constexpr int most_bins = 32;

/// Which bin a centre falls into, along each axis.
struct Binning {
    Quad lo;    ///< 0 along an axis without (finite) extent
    Quad scale; ///< 0 likewise
    int bins;

    Binning(const QuadBox& middles, int count);
    QuadInts operator()(Quad p) const { return __builtin_convertvector((p - lo) * scale, QuadInts); }
};

struct Bins {
    std::array<std::array<QuadBox, most_bins>, 3> boxes;
    std::array<std::array<std::uint32_t, most_bins>, 3> counts;

    void clear(int bins);
    void fill(const Binning& binning, const Ref* begin, const Ref* end);
    void add(const Bins& other, int bins);

  private:
    void add(const Binning& binning, const Ref& ref);
};

/// Where a range would be cut, and what that would cost: the sum of area times elements, both sides.
struct Cut {
    int axis = -1; ///< -1: all centres are one
    int bin = 0;   ///< first bin of the right side
    float cost = std::numeric_limits<float>::infinity();
};

/// The cheapest cut between bins; areas are multiplied by scale^2. With `pairs` odd numbers of elements count
/// as the next even one.
Cut cheapest_cut(const Bins& bins, const Binning& binning, float scale, bool pairs = false);

/// What the bins on either side of a cut bound.
std::pair<QuadBox, QuadBox> boxes_of(const Bins& bins, const Binning& binning, const Cut& cut);

/// Sorts a range to either side of a cut. The room is divided in proportion to the sizes.
std::pair<Range, Range> split_by(const Range& range, const Bins& bins, const Binning& binning, const Cut& cut,
                                 Ref* refs);

/// Halves a range along the longest side of its centres; equal centres as they come.
std::pair<Range, Range> split_in_half(const Range& range, Ref* refs);

/// Gives two neighbours [begin, middle) and [middle, end) the room of a whole, in proportion to their sizes:
/// the right one moves.
void share_room(Range& left, Range& right, std::size_t limit, Ref* refs);

} // namespace glint
