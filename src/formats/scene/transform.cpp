// Reading transforms.

#include "formats/scene/table_reader.h"
#include "math/trig.h"

#include <algorithm>
#include <cmath>

namespace glint::formats {
namespace {

// Rodrigues' formula; exact for quarter turns about the axes.
Mat4 rotation(const Vec3& axis, double degrees) {
    const Vec3 a = axis / std::sqrt(glm::dot(axis, axis));
    const double s = sin_degrees(degrees);
    const double c = cos_degrees(degrees);
    const double t = 1 - c;
    Mat4 m{1};
    m[0] = {t * a.x * a.x + c, t * a.x * a.y + s * a.z, t * a.x * a.z - s * a.y, 0};
    m[1] = {t * a.x * a.y - s * a.z, t * a.y * a.y + c, t * a.y * a.z + s * a.x, 0};
    m[2] = {t * a.x * a.z + s * a.y, t * a.y * a.z - s * a.x, t * a.z * a.z + c, 0};
    return m;
}

// Reports an entry without exactly one transformation.
void check_one(TableReader& entry) {
    if (!entry.good()) return;
    int count = 0;
    for (const char* key : {"translate", "rotate", "scale", "matrix"}) count += entry.has(key) ? 1 : 0;
    if (entry.has("angle") && !entry.has("rotate"))
        entry.error(entry.position_of("angle"), "\"angle\" needs \"rotate\", the axis to turn about",
                    "expected { rotate = [x, y, z], angle = degrees }");
    else if (entry.has("rotate") && !entry.has("angle"))
        entry.error(entry.position_of("rotate"), "\"rotate\" needs \"angle\"",
                    "expected { rotate = [x, y, z], angle = degrees }");
    else if (count > 1)
        entry.error(entry.header(),
                    "an entry of \"transform\" holds one of translate, rotate, scale and matrix",
                    "write one entry each, in the order in which they apply");
    else if (count == 0)
        entry.error(entry.header(), "an empty entry of \"transform\"",
                    "expected translate, rotate, scale or matrix");
}

Mat4 read_entry(const TreeValue& table, const ReadContext& context) {
    const TableSpec& spec = *find_table("transform");
    TableReader entry(table, spec, spec.header(), {}, context);
    check_one(entry);

    TransformEntry read;
    entry.read(read);
    if (!entry.good()) return Mat4{1};

    if (entry.has("rotate")) return rotation(read.rotate, read.angle);
    for (int i = 0; i < 3; ++i) read.matrix[i] *= read.scale[i];
    read.matrix[3] += glm::dvec4(read.translate, 0);
    return read.matrix;
}

} // namespace

Mat4 read_transform(const TreeValue& list, const ReadContext& context) {
    Mat4 whole{1};
    for (const TreeValue& item : list.items) {
        if (item.kind == TreeValue::Kind::table)
            whole = read_entry(item, context) * whole;
        else
            context.problems.error(
                item.where, "expected a table in \"transform\", found " + std::string(item.kind_words()),
                "for example { translate = [1, 0, 0] }");
    }
    return whole;
}

} // namespace glint::formats
