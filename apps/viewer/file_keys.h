#pragma once
// The keys of the scene file's text, and the paths that name them.

#include "glint/document.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

/// Caches lookups: panels ask for the same keys in every frame.
class FileKeys {
  public:
    FileKeys() = default;
    /// The document must neither change nor move while this is used.
    explicit FileKeys(const SceneDocument& document) : document_(&document) {}

    /// As SceneDocument::numbers(), also for keys that the file does not have.
    const std::vector<double>& numbers(const std::string& path) const;
    /// As SceneDocument::longer_list().
    std::optional<std::string> longer_list(const std::string& path, const std::string& value) const;

  private:
    const SceneDocument* document_ = nullptr;
    mutable std::map<std::string, std::vector<double>> numbers_;
};

/// The path of an object's table, "sphere.ball": by its name, else by its number among its kind.
std::string table_of(const Object& object, std::size_t number_in_kind);

/// The same key path, with the object's name where it has one and the path has its number.
std::string named_key(const SceneDescription& scene, const std::string& key);

} // namespace glint::viewer
