// The interior list of a ray (render/interior_list.h), for nested dielectrics: up to eight numbers of transparent
// solids, of 16 bits each, highest rank first, then zeros. Numbers grow with rank, so the list is sorted by them.

bool interiors_overflowed = false; // a ray was in more than eight

#if GLINT_GLASS
uvec4 interiors_with(uvec4 list, uint interior) {
    for (int i = 0; i < 4; ++i) {
        uint first = list[i] >> 16;
        uint second = list[i] & 0xffffu;
        uint greater = max(interior, first);
        interior = min(interior, first);
        list[i] = greater << 16 | max(interior, second);
        interior = min(interior, second);
    }
    if (interior != 0u) interiors_overflowed = true;
    return list;
}

uint interiors_entry(uvec4 list, int i) {
    return i > 7 ? 0u : (i % 2 == 0 ? list[i / 2] >> 16 : list[i / 2] & 0xffffu);
}

uvec4 interiors_without(uvec4 list, uint interior) {
    int shift = 0;
    uvec4 left;
    for (int i = 0; i < 4; ++i) {
        if (interiors_entry(list, 2 * i) == interior) shift = 1;
        uint first = interiors_entry(list, 2 * i + shift);
        if (interiors_entry(list, 2 * i + 1) == interior) shift = 1;
        left[i] = first << 16 | interiors_entry(list, 2 * i + 1 + shift);
    }
    return left;
}

/// The list beyond a surface of `object`; what lets no light through is not listed.
uvec4 interiors_across(uvec4 list, uint object, bool entering) {
    uint interior = objects[object].interior;
    if (interior == 0u) return list;
    return entering ? interiors_with(list, interior) : interiors_without(list, interior);
}

/// The solid that owns the space, or invalid_index.
uint interiors_owner(uvec4 list) {
    uint head = list.x >> 16;
    return head == 0u ? invalid_index : interior_object(head);
}

/// Is a surface of `object` hidden inside a transparent solid of higher rank?
bool interiors_hide(uvec4 list, uint object) {
    uint owner = interiors_owner(list);
    return owner != invalid_index && object_is(object, object_solid) && objects[owner].rank > objects[object].rank;
}

float interiors_index(uvec4 list) {
    uint owner = interiors_owner(list);
    return owner == invalid_index ? settings.index_outside : objects[owner].material.index;
}

/// What is left of light over a distance in there.
vec3 interiors_transmittance(uvec4 list, float distance_in) {
    uint owner = interiors_owner(list);
    vec3 sigma = owner == invalid_index ? vec3(0.0f) : objects[owner].material.absorption;
    return sigma == vec3(0.0f) ? vec3(1.0f) : transmittance(sigma, distance_in);
}
#else
uvec4 interiors_across(uvec4 list, uint object, bool entering) { return list; }
bool interiors_hide(uvec4 list, uint object) { return false; }
float interiors_index(uvec4 list) { return settings.index_outside; }
vec3 interiors_transmittance(uvec4 list, float distance_in) { return vec3(1.0f); }
#endif
