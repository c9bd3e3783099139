// G16: the order of a scene's parts decides nothing. G19: light adds up.

#include "gallery.h"
#include "scene_kit.h"

#include "glint/image.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glint {

using trace::Hit;
using trace::World;
namespace {

using namespace kit;

class G16 : public testing::TestWithParam<Exhibit> {};
class G19 : public testing::TestWithParam<Exhibit> {};

INSTANTIATE_TEST_SUITE_P(Gallery, G16, testing::ValuesIn(gallery()),
                         [](const auto& exhibit) { return exhibit.param.name; });
INSTANTIATE_TEST_SUITE_P(Gallery, G19, testing::ValuesIn(gallery()),
                         [](const auto& exhibit) { return exhibit.param.name; });

/// A shuffle that is the same everywhere.
template <class T>
void shuffle(std::vector<T>& items, unsigned seed) {
    for (std::size_t i = items.size(); i > 1; --i) {
        seed = seed * 1664525u + 1013904223u;
        std::swap(items[i - 1], items[(seed >> 8) % i]);
    }
}

/// Ties between two surfaces at one distance along the rays that follow a pixel's tree: order may decide
/// those.
int ties(const SceneDescription& scene) {
    const Scene scene_data = build_scene(scene);
    const World& world = scene_data.data().world;
    rendering::Whitted tracer(scene_data.data());
    int count = 0;
    for (int i = 0; i < 400; ++i) {
        rendering::RayTree tree;
        const Vec3 aside = Vec3(rotation(static_cast<unsigned>(i))[0]) * 0.25;
        const Vec3 direction = glm::normalize(glm::normalize(scene.camera->direction) + aside);
        tracer.trace(camera_ray(vec3(scene.camera->eye), vec3(direction)), &tree);
        for (const rendering::RayNode& node : tree.nodes) {
            Ray ray;
            ray.origin = node.origin;
            ray.direction = node.direction;
            const Hit hit = world.closest(ray);
            if (hit && (hit.on_edge || world.next(ray, hit).t == hit.t)) ++count;
        }
    }
    return count;
}

/// Overlapping solids are told apart by their place in the file: here by priorities that keep it.
SceneDescription with_priorities(SceneDescription scene) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        scene.objects[i].priority = scene.objects[i].priority * 100 + static_cast<int>(i);
    return scene;
}

TEST_P(G16, OrderOfObjectsAndMaterialsKeepsEveryBit) {
    SceneDescription scene = with_priorities(GetParam().scene);
    EXPECT_EQ(ties(scene), 0);
    const std::string expected = picture_hash(rendered(GetParam().scene).image);
    for (unsigned seed : {1u, 2u, 3u}) {
        shuffle(scene.objects, seed);
        shuffle(scene.materials, seed);
        EXPECT_EQ(picture_hash(rendered(scene).image), expected) << seed;
    }
}

TEST_P(G16, OrderOfTrianglesKeepsEveryBit) {
    SceneDescription scene = GetParam().scene;
    const std::string expected = picture_hash(rendered(scene).image);
    for (unsigned seed : {1u, 2u, 3u}) {
        for (Object& object : scene.objects) {
            auto* mesh = std::get_if<MeshShape>(&object.shape);
            if (mesh == nullptr) continue;
            Mesh shuffled = *mesh->data;
            shuffle(shuffled.triangles, seed);
            mesh->data = std::make_shared<const Mesh>(shuffled);
        }
        EXPECT_EQ(picture_hash(rendered(scene).image), expected) << seed;
    }
}

/// The largest |a − b| relative to b, per value.
double max_relative_difference(const Image& a, const Image& b) {
    constexpr double least = 1e-30; // numbers near 0 have fewer digits
    double largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double x = a.pixels[i], y = b.pixels[i];
        if (x != y) largest = std::max(largest, std::abs(x - y) / std::max(std::abs(y), least));
    }
    return largest;
}

TEST_P(G16, OrderOfLightsChangesNoMoreThanRounding) {
    SceneDescription scene = GetParam().scene;
    add_light(scene, Vec3(-3.3, -5.1, 4.9), 17);
    add_light(scene, Vec3(1.3, -7.1, 2.9), 5, Vec3(0.2, 0.4, 0.9));
    const Image expected = rendered(scene).image;
    std::reverse(scene.lights.begin(), scene.lights.end());
    EXPECT_LE(max_relative_difference(rendered(scene).image, expected), 1e-6);
}

struct Brighten {
    double factor;
    void operator()(AmbientLight& l) const { l.color *= factor; }
    void operator()(PointLight& l) const { l.intensity *= factor; }
    void operator()(DirectionalLight& l) const { l.irradiance *= factor; }
    void operator()(SpotLight& l) const { l.intensity *= factor; }
};

/// Every source of light, background and lamps included.
SceneDescription brightened(SceneDescription scene, double factor) {
    for (Light& light : scene.lights) std::visit(Brighten{factor}, light.kind);
    scene.render.background *= factor;
    for (Material& m : scene.materials) m.emission *= factor;
    return scene;
}

TEST_P(G19, TwiceTheLightIsTwiceThePictureInEveryBit) {
    SceneDescription scene = GetParam().scene;
    scene.whitted.clamp = false;
    Image expected = rendered(scene).image;
    for (float& v : expected.pixels) v *= 2;
    EXPECT_EQ(picture_hash(rendered(brightened(scene, 2)).image), picture_hash(expected));
}

TEST_P(G19, ThePictureOfTwoLightsIsTheSumOfTheirPictures) {
    SceneDescription both = GetParam().scene;
    both.whitted.clamp = false;
    SceneDescription first = both;
    SceneDescription second = both;
    second.lights.clear();
    second.render.background = Vec3(0);
    for (Material& m : second.materials) m.emission = Vec3(0);
    add_light(second, Vec3(-3.3, -5.1, 4.9), 17);
    add_light(both, Vec3(-3.3, -5.1, 4.9), 17);
    Image sum = rendered(first).image;
    const Image rest = rendered(second).image;
    for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += rest.pixels[i];
    EXPECT_LE(max_relative_difference(rendered(both).image, sum), 1e-6);
}

TEST_P(G19, ManyWeakLightsAreOneStrongOne) {
    SceneDescription one = GetParam().scene;
    one.whitted.clamp = false;
    one.lights.clear();
    SceneDescription many = one;
    add_light(one, Vec3(-3.3, -5.1, 4.9), 21);
    for (int i = 0; i < 7; ++i) add_light(many, Vec3(-3.3, -5.1, 4.9), 3);
    EXPECT_LE(max_relative_difference(rendered(many).image, rendered(one).image), 1e-6);
}

} // namespace
} // namespace glint
