// The interior list that rays carry on the GPU, against the CPU's.

#include "gpu/interiors.shared.h"
#include "render/interior_list.h"

#include <gtest/gtest.h>

#include <random>

namespace glint::gpu {
namespace {

constexpr std::uint32_t solids = 20;

/// Glass balls, each of a rank above the last.
scene::SceneData balls() {
    scene::SceneData scene;
    scene.materials.emplace_back();
    scene.materials.front().transparency = 1;
    for (std::uint32_t i = 0; i < solids; ++i) {
        scene::ObjectData object;
        object.rank = i;
        object.solid = true;
        scene.objects.push_back(object);
    }
    return scene;
}

/// Numbers of solids begin with 1.
std::vector<std::uint32_t> listed(const rendering::InteriorList* list, const scene::SceneData& scene) {
    std::vector<std::uint32_t> numbers = rendering::solids_of(list, scene);
    for (std::uint32_t& number : numbers) ++number;
    return numbers;
}
std::vector<std::uint32_t> listed(const uvec4& list) {
    std::vector<std::uint32_t> numbers;
    for (int i = 0; interiors_entry(list, i) != 0; ++i) numbers.push_back(interiors_entry(list, i));
    return numbers;
}

TEST(GpuInteriors, AreEnteredAndLeftAsOnTheCpu) {
    const scene::SceneData scene = balls();
    std::mt19937 random(3);
    for (int walk = 0; walk < 100; ++walk) {
        rendering::InteriorArena arena;
        const rendering::InteriorList* list = nullptr;
        uvec4 packed(0u);
        for (int step = 0; step < 40; ++step) {
            const auto object = static_cast<std::uint32_t>(random() % solids);
            const bool entering = random() % 3 != 0 && !interiors_full(packed);
            list = rendering::crossed(list, object, entering, scene, arena);
            packed = entering ? interiors_with(packed, object + 1) : interiors_without(packed, object + 1);
            ASSERT_EQ(listed(packed), listed(list, scene));
        }
    }
}

TEST(GpuInteriors, AFullListLosesItsLowest) {
    uvec4 list(0u);
    for (std::uint32_t number = 1; number <= 8; ++number) {
        EXPECT_FALSE(interiors_full(list));
        list = interiors_with(list, number);
    }
    EXPECT_TRUE(interiors_full(list));
    EXPECT_EQ(listed(interiors_with(list, 0xffff)),
              (std::vector<std::uint32_t>{0xffff, 8, 7, 6, 5, 4, 3, 2}));
}

} // namespace
} // namespace glint::gpu
