#pragma once
// What the text of the scene file says, key by key.

#include "glint/document.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

/// Each key is looked up once: panels ask for the same ones frame after frame.
class FileKeys {
  public:
    FileKeys() = default;
    /// The document must stay as it is, and where it is, as long as it is asked for.
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
