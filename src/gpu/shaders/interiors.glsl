// What the interior list of a ray (gpu/interiors.shared.h) says of the space around it.

bool interiors_overflowed = false; // a ray was in more solids than a list can name

/// The list beyond a surface of `object`; what lets no light through is not listed.
uvec4 interiors_across(uvec4 list, uint object, bool entering) {
    uint interior = objects[object].interior;
    if (GLINT_GLASS == 0 || interior == 0u) return list;
    if (!entering) return interiors_without(list, interior);
    if (interiors_full(list)) interiors_overflowed = true;
    return interiors_with(list, interior);
}

/// The object that owns the space; of an empty list that which stands for the outside.
uint interiors_owner(uvec4 list) { return words[settings.first_interior + interiors_entry(list, 0)]; }

/// Is a surface of `object` that of a transparent solid inside one of higher rank?
bool interiors_hide(uvec4 list, uint object) {
    return GLINT_GLASS != 0 && objects[object].interior != 0u &&
           objects[interiors_owner(list)].rank > objects[object].rank;
}
