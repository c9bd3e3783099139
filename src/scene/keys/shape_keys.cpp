// The tables of objects: [[plane]], [[sphere]], …

#include "scene/keys/bind.h"
#include "scene/keys/tables.h"

#include <algorithm>

namespace glint::scene::keys {
namespace {

constexpr auto standing = {PolyhedronKind::prism, PolyhedronKind::pyramid};
constexpr auto all_but_box = {PolyhedronKind::tetrahedron,  PolyhedronKind::octahedron,
                              PolyhedronKind::dodecahedron, PolyhedronKind::icosahedron,
                              PolyhedronKind::prism,        PolyhedronKind::pyramid};

/// A length that belongs to a shape.
template <auto member>
KeyRow extent(std::string_view key) {
    return number<member>(key).unit("scene units").range(length);
}

/// The keys that every object has.
std::vector<KeySpec> common_keys() {
    using O = Object;
    return {
        text<&O::name>("name").help("to be named by `-D` and by instances; unique within its table type"),
        text<&O::material>("material").required().help("the NAME of a `[material.NAME]`"),
        boolean<&O::visible>("visible").help("`false`: gone for all rays"),
        integer<&O::priority>("priority")
            .range(between(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()))
            .typical(-8, 8)
            .help(
                "where transparent solids overlap, the higher owns the space; where surfaces coincide, it is "
                "seen; among equals the later in the file"),
        bound<Mat4, &O::transform>("transform", KeyType::transform)
            .help("a list of the entries below, applied in order"),
    };
}

/// Adds the common keys behind the shape's own, except those that it defines otherwise.
TableSpec object_table(TableSpec table) {
    table.form = TableForm::list;
    table.object = true;
    for (KeySpec& common : common_keys()) {
        const auto same = [&](const KeySpec& own) { return own.key == common.key; };
        const auto own = std::find_if(table.keys.begin(), table.keys.end(), same);
        if (own == table.keys.end())
            table.keys.push_back(std::move(common));
        else
            std::rotate(own, own + 1, table.keys.end());
    }
    return table;
}

} // namespace

template <>
TableSpec shape_table<PlaneShape>() {
    using P = PlaneShape;
    return {
        .help = "All p with normal · p = offset, taken literally: the normal need not be of unit length.",
        .keys = {
            direction<&P::normal>("normal").required().help("square to the plane"),
            number<&P::offset>("offset").unit("scene units × length of the normal").help("normal · p"),
            boolean<&P::solid>("solid").help("`true`: the half-space behind the normal, not a thin sheet"),
        }};
}

template <>
TableSpec shape_table<SphereShape>() {
    return {.help = "A solid ball.",
            .keys = {
                point<&SphereShape::center>("center").required(),
                extent<&SphereShape::radius>("radius").required(),
            }};
}

template <>
TableSpec shape_table<CylinderShape>() {
    using C = CylinderShape;
    return {.help = "A solid cylinder with both caps.",
            .keys = {
                point<&C::base>("base").required().help("centre of the bottom disc"),
                direction<&C::axis>("axis").help("from bottom to top"),
                extent<&C::height>("height").required(),
                extent<&C::radius>("radius").required(),
            }};
}

template <>
TableSpec shape_table<ConeShape>() {
    using C = ConeShape;
    return {.help = "A solid cone with its cap.",
            .keys = {
                point<&C::base>("base").required().help("centre of the bottom disc"),
                direction<&C::axis>("axis").help("from the bottom disc to the apex"),
                extent<&C::height>("height").required(),
                extent<&C::radius>("radius").required().help("of the bottom disc"),
            }};
}

template <>
TableSpec shape_table<DiskShape>() {
    using D = DiskShape;
    return {.help = "A flat disk, seen from both sides.",
            .keys = {
                point<&D::center>("center").required(),
                direction<&D::normal>("normal").required().help("perpendicular to the disk"),
                extent<&D::radius>("radius").required(),
            }};
}

template <>
TableSpec shape_table<TriangleShape>() {
    return {.help = "One triangle, seen from both sides.",
            .keys = {
                bound<std::array<Vec3, 3>, &TriangleShape::vertices>("vertices", KeyType::vertices)
                    .unit("scene units")
                    .range(coordinate)
                    .required()
                    .help("three points, not on one line"),
            }};
}

template <>
TableSpec shape_table<RectangleShape>() {
    using R = RectangleShape;
    return {
        .help =
            "A flat parallelogram, seen from both sides: a rectangle where `u` and `v` are perpendicular. "
            "Its normal is u × v.",
        .keys = {
            point<&R::corner>("corner").required(),
            point<&R::u>("u").required().help("an edge from the corner"),
            point<&R::v>("v").required().help("the other edge from the corner, not parallel to `u`"),
        }};
}

template <>
TableSpec shape_table<PolyhedronShape>() {
    using P = PolyhedronShape;
    return {
        .selector = "kind",
        .help = "A solid with flat faces. Tetrahedron, octahedron and icosahedron stand with a vertex on +z, "
                "the dodecahedron with a face centre on +z; the first corner off the z axis, counted from "
                "the top, lies toward +x. The first corner of a prism or pyramid lies toward +x, turned with "
                "the axis by the shortest rotation from +z.",
        .keys = {
            choice<&P::kind>("kind").required(),
            point<&P::center>("center").help("of the box; of the circumscribed sphere of Platonic solids; of "
                                             "the bottom face of prism and pyramid"),
            bound<Vec3, &P::size>("size", KeyType::lengths)
                .unit("scene units")
                .range(length)
                .only({PolyhedronKind::box})
                .help("edge lengths"),
            extent<&P::radius>("radius")
                .only(all_but_box)
                .help("circumscribed; of the bottom face for prism and pyramid"),
            integer<&P::sides>("sides")
                .range(between(3, 65536))
                .typical(3, 24)
                .only(standing)
                .help("corners of the bottom face"),
            extent<&P::height>("height").only(standing),
            direction<&P::axis>("axis").only(standing).help("from the bottom face up"),
        }};
}

template <>
TableSpec shape_table<MeshShape>() {
    using S = MeshShape;
    return {
        .help = "Triangles from a PLY file.",
        .keys = {
            text<&S::file>("file", KeyType::file)
                .required()
                .help("relative to the scene file and within its folder, unless `--allow-outside`"),
            scale<&S::scale>("scale").help("before `transform`; negative mirrors"),
            choice<&S::normals>("normals").help(
                "`\"auto\"`: stored ones if any, else flat; `\"smooth\"`: weighted by angle"),
            number<&S::crease_angle>("crease_angle")
                .unit("degrees")
                .range({.low = 0, .high = 180, .low_open = true})
                .help("with `normals = \"smooth\"`: faces whose normals differ by more meet in a sharp edge"),
            choice<&S::facing>("facing").help(
                "where lights find its normals: turned to the viewer, or as its winding has them, so that "
                "the inside of an open mesh is lit through its back, as in the report's pictures"),
            choice<&S::vertex_colors>("vertex_colors")
                .help("`\"auto\"`: they replace the material's `color` where stored (bytes are sRGB)"),
            bound<std::optional<double>, &S::point_radius>("point_radius", KeyType::number_or_auto)
                .unit("scene units")
                .range(length)
                .help("files without faces: spheres of this radius"),
        }};
}

template <>
TableSpec shape_table<InstanceShape>() {
    return {.help = "A mesh again: its own scale and transform first, then this one's.",
            .keys = {
                text<&InstanceShape::mesh>("mesh").required().help("the `name` of a `[[mesh]]`"),
                text<&Object::material>("material").help("without it, the mesh's"),
            }};
}

namespace {

template <class... Shapes>
std::vector<TableSpec> tables_of(const std::variant<Shapes...>*) {
    std::vector<TableSpec> tables{object_table(shape_table<Shapes>())...};
    for (std::size_t i = 0; i < tables.size(); ++i) tables[i].name = shape_names[i];
    return tables;
}

} // namespace

std::vector<TableSpec> object_tables() { return tables_of(static_cast<const Shape*>(nullptr)); }

} // namespace glint::scene::keys
