// Surfaces of several objects in one place, which a ray meets at once (render/contact.h): the hits there are collected,
// one an iteration of the loop, before it is decided which is seen.

#if GLINT_CONTACTS

struct Contact {
    bool exists;        // else the last hit is alone
    SurfacePoint first; // the others are compared with it
    float apart;        // as ObjectRecord has it for the first
    float limit;        // of the ray, which is shortened meanwhile
    float margin;       // what start points are off the seen one
    uvec4 beyond;       // the solids around the ray behind all
    bool refracts;      // one of them bounds a transparent solid
    float panes;        // the product of their τ
    vec3 panes_tint;    // and of their tints
    float solid;        // τ of the solid's surface of the highest rank, and its object
    uint solid_object;
    vec3 solid_tint;
    Hit seen;           // kind_none: all are hidden
    SurfacePoint point; // of the seen one
    Hit last;
};
Contact contact;
uint met = 0u; // hits collected so far

bool in_contact_zone(uint object, vec3 p) {
    return all(lessThanEqual(objects[object].contact_low, p)) && all(lessThanEqual(p, objects[object].contact_high));
}

/// Of coincident surfaces: is `a` seen rather than `b`?
bool covers(Hit a, Hit b) {
    bool opaque_a = !(objects[a.object].material.transparency > 0.0f);
    bool opaque_b = !(objects[b.object].material.transparency > 0.0f);
    return opaque_a == opaque_b ? objects[a.object].rank > objects[b.object].rank : opaque_a;
}

void collect_transparency(uint object) {
    float transparency = objects[object].material.transparency;
    vec3 tint = objects[object].material.transmitted_tint;
    if (objects[object].interior == 0u) {
        contact.panes *= transparency;
        contact.panes_tint *= tint;
    } else if (contact.solid_object == invalid_index ||
               objects[object].rank > objects[contact.solid_object].rank) {
        contact.solid = transparency;
        contact.solid_object = object;
        contact.solid_tint = tint;
    }
}

void collect(Hit hit, SurfacePoint point, uvec4 interiors) {
    ++met;
    contact.margin = max(contact.margin, margin_past(contact.first, point));
    contact.beyond = interiors_across(contact.beyond, hit.object, enters(point.n, ray.direction));
    contact.refracts = contact.refracts || objects[hit.object].interior != 0u;
    bool shown = !interiors_hide(interiors, hit.object);
    if (shown) collect_transparency(hit.object);
    if (shown && (contact.seen.kind == kind_none || covers(hit, contact.seen))) {
        contact.seen = hit;
        contact.point = point;
    }
    contact.last = hit;
    after = hit;
}

void begin_contact(Hit hit, SurfacePoint point, uvec4 interiors) {
    contact.first = point;
    contact.apart = objects[hit.object].contact_apart;
    contact.limit = ray.tmax;
    contact.margin = 0.0f;
    contact.beyond = interiors;
    contact.refracts = false;
    contact.panes = 1.0f;
    contact.solid = 1.0f;
    contact.solid_object = invalid_index;
    contact.panes_tint = vec3(1.0f);
    contact.solid_tint = vec3(1.0f);
    contact.seen = no_hit(0.0f);
    ray.tmax = min(ray.tmax, last_coincident_t(point.n, ray.direction, hit.t, objects[hit.object].contact_reach));
    collect(hit, point, interiors);
}

/// True if the ray goes on, for more hits in one place or behind what is hidden there. Otherwise the hit becomes the one
/// that is seen there.
bool collects(inout Hit hit, inout SurfacePoint point, inout uvec4 interiors) {
    if (met == 0u) {
        contact.exists = false;
        if (hit.kind == kind_none || !in_contact_zone(hit.object, point.p)) return false;
        begin_contact(hit, point, interiors);
        return true;
    }
    if (hit.kind != kind_none && coincide(contact.first, point, contact.apart)) {
        collect(hit, point, interiors);
        return true;
    }
    contact.exists = met > 1u;
    met = 0u;
    ray.tmax = contact.limit;
    hit = contact.seen;
    point = contact.point;
    if (hit.kind == kind_none) interiors = contact.beyond;
    return hit.kind == kind_none;
}

#endif

/// The solids around a ray behind a hit and what coincides with it.
uvec4 interiors_behind(uvec4 interiors, Hit hit, SurfacePoint point) {
#if GLINT_CONTACTS
    if (contact.exists) return contact.beyond;
#endif
    return interiors_across(interiors, hit.object, enters(point.n, ray.direction));
}

/// The share of light that goes through a hit's surface and those that coincide with it (render/contact.h).
float transparency_at(Hit hit) {
#if GLINT_CONTACTS
    if (contact.exists) return contact.panes * contact.solid;
#endif
    return objects[hit.object].material.transparency;
}

/// Its tint.
vec3 tint_at(Hit hit) {
#if GLINT_CONTACTS
    if (contact.exists) return contact.panes_tint * contact.solid_tint;
#endif
    return objects[hit.object].material.transmitted_tint;
}

/// The last of the hits in one place.
Hit last_met(Hit hit) {
#if GLINT_CONTACTS
    if (contact.exists) return contact.last;
#endif
    return hit;
}
