#pragma once
// What objects refer to by name.

#include "glint/scene.h"

#include <map>
#include <string>
#include <string_view>

namespace glint::scene {

/// The materials and meshes of a description by name; of equal names the first counts. The description must
/// outlive it and keep its materials and objects.
class NameIndex {
  public:
    explicit NameIndex(const SceneDescription& description) {
        for (const Material& material : description.materials) materials_.emplace(material.name, &material);
        for (const Object& object : description.objects)
            if (std::holds_alternative<MeshShape>(object.shape)) meshes_.emplace(object.name, &object);
    }

    /// The mesh object that an instance refers to, or nullptr.
    const Object* mesh(const std::string& name) const { return find(meshes_, name); }

    /// The material of an object: its own, or its mesh's for an instance without one; nullptr if unknown.
    const Material* material_of(const Object& object) const {
        const auto* instance = std::get_if<InstanceShape>(&object.shape);
        const Object* shown = instance && object.material.empty() ? mesh(instance->mesh) : nullptr;
        return find(materials_, shown ? shown->material : object.material);
    }

  private:
    template <class T>
    using ByName = std::map<std::string_view, const T*>;

    template <class T>
    static const T* find(const ByName<T>& all, const std::string& name) {
        const auto found = all.find(name);
        return found == all.end() ? nullptr : found->second;
    }

    ByName<Material> materials_;
    ByName<Object> meshes_;
};

} // namespace glint::scene
