// Lists of the solids around a ray.

#include "render/interior_list.h"

#include <gtest/gtest.h>

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

std::vector<std::uint32_t> listed(const InteriorList* list) {
    std::vector<std::uint32_t> objects;
    for (; list != nullptr; list = list->rest) objects.push_back(list->object);
    return objects;
}

using Objects = std::vector<std::uint32_t>;

TEST(InteriorList, TheHighestRankStandsFirstWhateverTheOrderOfEntering) {
    const SceneData scene = balls({2, 0, 1});
    InteriorArena arena;
    for (const Objects& order : {Objects{0, 1, 2}, Objects{2, 1, 0}, Objects{1, 2, 0}, Objects{0, 2, 1}}) {
        const InteriorList* list = nullptr;
        for (const std::uint32_t object : order) list = entered(list, object, scene, arena);
        EXPECT_EQ(listed(list), (Objects{0, 2, 1}));
    }
}

TEST(InteriorList, LeavingTakesOneEntryAway) {
    const SceneData scene = balls({0, 1, 2});
    InteriorArena arena;
    const InteriorList* list = nullptr;
    for (const std::uint32_t object : {0u, 1u, 2u, 1u}) list = entered(list, object, scene, arena);
    EXPECT_EQ(listed(list), (Objects{2, 1, 1, 0}));
    EXPECT_EQ(listed(left(list, 1, arena)), (Objects{2, 1, 0}));
    EXPECT_EQ(listed(left(list, 2, arena)), (Objects{1, 1, 0}));
    EXPECT_EQ(listed(left(list, 0, arena)), (Objects{2, 1, 1}));
}

TEST(InteriorList, LeavingWhatWasNotEnteredChangesNothing) {
    const SceneData scene = balls({0, 1, 2});
    InteriorArena arena;
    const InteriorList* list = entered(entered(nullptr, 0, scene, arena), 2, scene, arena);
    EXPECT_EQ(left(list, 1, arena), list);
    EXPECT_EQ(left(nullptr, 1, arena), nullptr);
}

TEST(InteriorList, ListsThatOthersShareStayAsTheyAre) {
    const SceneData scene = balls({0, 1, 2, 3});
    InteriorArena arena;
    const InteriorList* shared = entered(entered(nullptr, 0, scene, arena), 2, scene, arena);
    entered(shared, 1, scene, arena);
    entered(shared, 3, scene, arena);
    left(shared, 0, arena);
    EXPECT_EQ(listed(shared), (Objects{2, 0}));
}

TEST(InteriorList, AcrossEntersOrLeaves) {
    const SceneData scene = balls({0, 1});
    InteriorArena arena;
    const InteriorList* in = crossed(nullptr, 1, true, scene, arena);
    EXPECT_EQ(listed(in), Objects{1});
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
    for (std::uint32_t i = 0; i < 1000; ++i) list = arena.push(i, list);
    const Objects all = listed(list);
    ASSERT_EQ(all.size(), 1000u);
    for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(all[i], 999 - i);
    arena.clear();
    EXPECT_EQ(listed(arena.push(7, nullptr)), Objects{7});
}

} // namespace
} // namespace glint::rendering
