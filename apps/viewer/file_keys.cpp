// Cached lookups in the document.
#include "file_keys.h"

namespace glint::viewer {

const FileKeys::Found& FileKeys::look_up(const std::string& path) const {
    const auto known = found_.find(path);
    if (known != found_.end()) return known->second;
    Found found;
    if (document_ != nullptr) {
        found.text = document_->value(path).value_or("");
        if (!found.text.empty()) found.numbers = document_->numbers(path);
    }
    return found_.emplace(path, std::move(found)).first->second;
}

std::optional<std::string> FileKeys::longer_list(const std::string& path, const std::string& value) const {
    return document_ != nullptr ? document_->longer_list(path, value) : std::nullopt;
}

} // namespace glint::viewer
