// Lists of the solids around a ray.

#include "scene/media.h"

#include <gtest/gtest.h>

namespace glint {
namespace {

/// Glass balls, ranked by `ranks`; object i has index 1 + i / 10.
FrozenScene balls(const std::vector<std::uint32_t>& ranks) {
    FrozenScene scene;
    scene.index_outside = 1.05f;
    for (std::uint32_t i = 0; i < ranks.size(); ++i) {
        MaterialRecord m{};
        m.transparency = 1;
        m.index = 1 + static_cast<float>(i) / 10;
        scene.materials.push_back(m);
        FrozenObject o;
        o.material = i;
        o.rank = ranks[i];
        o.solid = true;
        scene.objects.push_back(o);
    }
    return scene;
}

std::vector<std::uint32_t> listed(const Media* list) {
    std::vector<std::uint32_t> objects;
    for (; list != nullptr; list = list->rest) objects.push_back(list->object);
    return objects;
}

using Objects = std::vector<std::uint32_t>;

TEST(Media, TheHighestRankStandsFirstWhateverTheOrderOfEntering) {
    const FrozenScene scene = balls({2, 0, 1});
    MediaArena arena;
    for (const Objects& order : {Objects{0, 1, 2}, Objects{2, 1, 0}, Objects{1, 2, 0}, Objects{0, 2, 1}}) {
        const Media* list = nullptr;
        for (const std::uint32_t object : order) list = with(list, object, scene, arena);
        EXPECT_EQ(listed(list), (Objects{0, 2, 1}));
    }
}

TEST(Media, LeavingTakesOneEntryAway) {
    const FrozenScene scene = balls({0, 1, 2});
    MediaArena arena;
    const Media* list = nullptr;
    for (const std::uint32_t object : {0u, 1u, 2u, 1u}) list = with(list, object, scene, arena);
    EXPECT_EQ(listed(list), (Objects{2, 1, 1, 0}));
    EXPECT_EQ(listed(without(list, 1, arena)), (Objects{2, 1, 0}));
    EXPECT_EQ(listed(without(list, 2, arena)), (Objects{1, 1, 0}));
    EXPECT_EQ(listed(without(list, 0, arena)), (Objects{2, 1, 1}));
}

TEST(Media, LeavingWhatWasNotEnteredChangesNothing) {
    const FrozenScene scene = balls({0, 1, 2});
    MediaArena arena;
    const Media* list = with(with(nullptr, 0, scene, arena), 2, scene, arena);
    EXPECT_EQ(without(list, 1, arena), list);
    EXPECT_EQ(without(nullptr, 1, arena), nullptr);
}

TEST(Media, ListsThatOthersShareStayAsTheyAre) {
    const FrozenScene scene = balls({0, 1, 2, 3});
    MediaArena arena;
    const Media* shared = with(with(nullptr, 0, scene, arena), 2, scene, arena);
    with(shared, 1, scene, arena);
    with(shared, 3, scene, arena);
    without(shared, 0, arena);
    EXPECT_EQ(listed(shared), (Objects{2, 0}));
}

TEST(Media, AcrossEntersOrLeaves) {
    const FrozenScene scene = balls({0, 1});
    MediaArena arena;
    const Media* in = across(nullptr, 1, true, scene, arena);
    EXPECT_EQ(listed(in), Objects{1});
    EXPECT_EQ(across(in, 1, false, scene, arena), nullptr);
}

TEST(Media, SolidsOfLowerRankAreHiddenOthersNot) {
    FrozenScene scene = balls({0, 1, 2});
    MediaArena arena;
    const Media* list = with(nullptr, 1, scene, arena);
    EXPECT_TRUE(hidden(list, 0, scene));
    EXPECT_FALSE(hidden(list, 1, scene));
    EXPECT_FALSE(hidden(list, 2, scene));
    EXPECT_FALSE(hidden(nullptr, 0, scene));
    scene.objects[0].solid = false;
    EXPECT_FALSE(hidden(list, 0, scene)) << "panes are never hidden";
}

TEST(Media, TheOwnerGivesTheIndex) {
    const FrozenScene scene = balls({0, 2, 1});
    MediaArena arena;
    EXPECT_EQ(index_of(nullptr, scene), 1.05f);
    const Media* list = with(with(nullptr, 1, scene, arena), 2, scene, arena);
    EXPECT_EQ(index_of(list, scene), 1.1f);
}

TEST(MediaArena, HoldsMoreThanOneBlockAndForgets) {
    MediaArena arena;
    const Media* list = nullptr;
    for (std::uint32_t i = 0; i < 1000; ++i) list = arena.push(i, list);
    const Objects all = listed(list);
    ASSERT_EQ(all.size(), 1000u);
    for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(all[i], 999 - i);
    arena.clear();
    EXPECT_EQ(listed(arena.push(7, nullptr)), Objects{7});
}

} // namespace
} // namespace glint
