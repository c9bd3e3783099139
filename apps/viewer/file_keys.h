#pragma once
// The keys of the scene file's text.

#include "glint/document.h"

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

    bool has(const std::string& path) const { return document_ != nullptr && !look_up(path).text.empty(); }
    /// As SceneDocument::numbers().
    const std::vector<double>& numbers(const std::string& path) const { return look_up(path).numbers; }
    /// As SceneDocument::longer_list().
    std::optional<std::string> longer_list(const std::string& path, const std::string& value) const;

  private:
    struct Found {
        std::string text;
        std::vector<double> numbers;
    };
    const Found& look_up(const std::string& path) const;

    const SceneDocument* document_ = nullptr;
    mutable std::map<std::string, Found> found_;
};

} // namespace glint::viewer
