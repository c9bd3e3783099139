// Lists of the solids around a ray.

#include "render/interior_list.h"

#include <gtest/gtest.h>

#include <numeric>

namespace glint::rendering {

using scene::SceneData;

namespace {

/// Glass balls, ranked by `ranks`; object i has index 1 + i / 10.
SceneData balls(const std::vector<std::uint32_t>& ranks) {
    SceneData scene;
    scene.index_outside = 1.05f;
    for (std::uint32_t i = 0; i < ranks.size(); ++i) {
        MaterialRecord m{};
        m.transparency = 1;
        m.index = 1 + static_cast<float>(i) / 10;
        scene.materials.push_back(m);
        scene::ObjectData o;
        o.material = i;
        o.rank = ranks[i];
        o.solid = true;
        scene.objects.push_back(o);
    }
    return scene;
}

using Objects = std::vector<std::uint32_t>;

TEST(InteriorList, TheHighestRankOwnsTheSpaceWhateverTheOrderOfEntering) {
    const SceneData scene = balls({2, 0, 1});
    InteriorArena arena;
    for (const Objects& order : {Objects{0, 1, 2}, Objects{2, 1, 0}, Objects{1, 2, 0}, Objects{0, 2, 1}}) {
        const InteriorList* list = nullptr;
        for (const std::uint32_t object : order) list = entered(list, object, scene, arena);
        EXPECT_EQ(list->owner, 0u);
        EXPECT_EQ(solids_of(list, scene), (Objects{0, 2, 1}));
    }
}

TEST(InteriorList, LeavingTakesOneEntryAway) {
    const SceneData scene = balls({0, 1, 2});
    InteriorArena arena;
    const InteriorList* list = nullptr;
    for (const std::uint32_t object : {0u, 1u, 2u, 1u}) list = entered(list, object, scene, arena);
    EXPECT_EQ(solids_of(list, scene), (Objects{2, 1, 1, 0}));
    EXPECT_EQ(solids_of(left(list, 1, scene, arena), scene), (Objects{2, 1, 0}));
    EXPECT_EQ(solids_of(left(list, 2, scene, arena), scene), (Objects{1, 1, 0}));
    EXPECT_EQ(left(list, 2, scene, arena)->owner, 1u);
    EXPECT_EQ(solids_of(left(list, 0, scene, arena), scene), (Objects{2, 1, 1}));
}

TEST(InteriorList, LeavingWhatWasNotEnteredChangesNothing) {
    const SceneData scene = balls({0, 1, 2});
    InteriorArena arena;
    const InteriorList* list = entered(entered(nullptr, 0, scene, arena), 2, scene, arena);
    EXPECT_EQ(left(list, 1, scene, arena), list);
    EXPECT_EQ(left(nullptr, 1, scene, arena), nullptr);
}

TEST(InteriorList, ListsThatOthersShareStayAsTheyAre) {
    const SceneData scene = balls({0, 1, 2, 3});
    InteriorArena arena;
    const InteriorList* shared = entered(entered(nullptr, 0, scene, arena), 2, scene, arena);
    entered(shared, 1, scene, arena);
    entered(shared, 3, scene, arena);
    left(shared, 0, scene, arena);
    EXPECT_EQ(solids_of(shared, scene), (Objects{2, 0}));
}

TEST(InteriorList, WalkingThroughNestedSolidsCopiesNothing) {
    constexpr std::uint32_t count = 1000;
    std::vector<std::uint32_t> ranks(count);
    std::iota(ranks.rbegin(), ranks.rend(), 0u); // the outermost owns the space of all
    const SceneData scene = balls(ranks);
    InteriorArena arena;
    std::vector<const InteriorList*> lists{nullptr};
    for (std::uint32_t i = 0; i < count; ++i) lists.push_back(entered(lists.back(), i, scene, arena));
    for (std::uint32_t i = count; i > 0; --i) {
        EXPECT_EQ(lists[i]->owner, 0u);
        EXPECT_EQ(left(lists[i], i - 1, scene, arena), lists[i - 1]);
    }
}

TEST(InteriorList, AcrossEntersOrLeaves) {
    const SceneData scene = balls({0, 1});
    InteriorArena arena;
    const InteriorList* in = crossed(nullptr, 1, true, scene, arena);
    EXPECT_EQ(solids_of(in, scene), Objects{1});
    EXPECT_EQ(crossed(in, 1, false, scene, arena), nullptr);
}

TEST(InteriorList, SolidsOfLowerRankAreHiddenOthersNot) {
    SceneData scene = balls({0, 1, 2});
    InteriorArena arena;
    const InteriorList* list = entered(nullptr, 1, scene, arena);
    EXPECT_TRUE(is_hidden(list, 0, scene));
    EXPECT_FALSE(is_hidden(list, 1, scene));
    EXPECT_FALSE(is_hidden(list, 2, scene));
    EXPECT_FALSE(is_hidden(nullptr, 0, scene));
    scene.objects[0].solid = false;
    EXPECT_FALSE(is_hidden(list, 0, scene)) << "panes are never hidden";
}

TEST(InteriorList, TheOwnerGivesTheIndex) {
    const SceneData scene = balls({0, 2, 1});
    InteriorArena arena;
    EXPECT_EQ(refractive_index(nullptr, scene), 1.05f);
    const InteriorList* list = entered(entered(nullptr, 1, scene, arena), 2, scene, arena);
    EXPECT_EQ(refractive_index(list, scene), 1.1f);
}

TEST(InteriorArena, HoldsMoreThanOneBlockAndForgets) {
    InteriorArena arena;
    const InteriorList* list = nullptr;
    for (std::uint32_t i = 0; i < 1000; ++i) list = arena.push({i, i, list});
    for (std::uint32_t i = 1000; i > 0; --i, list = list->rest) ASSERT_EQ(list->object, i - 1);
    EXPECT_EQ(list, nullptr);
    arena.clear();
    EXPECT_EQ(arena.push({7, 7, nullptr})->object, 7u);
}

} // namespace
} // namespace glint::rendering
