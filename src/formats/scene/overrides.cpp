// Applying -D overrides.

#include "formats/scene/overrides.h"

#include "formats/scene/key_path.h"

namespace glint {

void apply_overrides(TreeValue& root, const SceneSource& source, Problems& problems) {
    int origin = 0;
    for (const std::string& text : source.overrides()) {
        const SourcePos where{++origin, 0, 0};
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos)
            throw Error(ErrorKind::usage, "-D " + text + " has no value",
                        "expected path=value, for example whitted.max_depth=3");
        const std::string_view value = trimmed(std::string_view(text).substr(equals + 1));
        const KeyTarget target = find_target(root, std::string_view(text).substr(0, equals), where, problems);
        if (target.table) put_value(target, read_value(value, where), where);
    }
}

} // namespace glint
