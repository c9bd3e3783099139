// From films to the picture that is shown, slot by slot.

layout(local_size_x = 64) in;
layout(rgba32f, binding = 0) uniform image2D known; // centres of pixels, where they were measured
layout(rgba32f, binding = 1) writeonly uniform image2D shown;

/// Correctly rounded, as on the CPU: in double the quotient of two floats is too precise to be rounded twice.
vec3 divided(vec3 sum, uint by) { return vec3(dvec3(sum) / double(by)); }

vec3 film_vector(uint slot, bool positive) {
    uint stride = settings.slot_count;
    uint at = slot + 3u * ((positive ? 0u : settings.film_terms) + settings.shown_term) * stride;
    return vec3(film[at], film[at + stride], film[at + 2u * stride]);
}

/// imaging/pixel_sum.h: pixel_value().
vec3 pixel_value(uint slot, uint count) {
    uint positives = uint(film[slot + film_fields_of_term * settings.film_terms * settings.slot_count]);
    uint negatives = count - positives;
    if (positives == 0u) return divided(film_vector(slot, false), negatives);
    bool lobes = count >= 16u && 4u * positives >= 3u * count;
    if (!lobes) return divided(film_vector(slot, true), positives);
    return divided(film_vector(slot, true) - film_vector(slot, false), positives - negatives);
}

/// Exact at both ends, where the other may be anything.
vec3 mixed(vec3 a, vec3 b, float share) { return share == 0.0f ? a : a + (b - a) * share; }

/// render/upsample.cpp: linear between the known pixels, or in blocks.
vec3 spread(ivec2 pixel, int step) {
    ivec2 size = imageSize(known);
    ivec2 before = pixel / step * step;
    if (settings.smooth_steps == 0u) return imageLoad(known, before).rgb;
    ivec2 after = before + step;
    if (after.x >= size.x) after.x = before.x;
    if (after.y >= size.y) after.y = before.y;
    vec2 share = vec2(pixel - before) / float(step);
    vec3 left = mixed(imageLoad(known, before).rgb, imageLoad(known, ivec2(before.x, after.y)).rgb, share.y);
    if (share.x == 0.0f) return left;
    vec3 right = mixed(imageLoad(known, ivec2(after.x, before.y)).rgb, imageLoad(known, after).rgb, share.y);
    return mixed(left, right, share.x);
}

void main() {
    uint slot = gl_GlobalInvocationID.x;
    if (slot >= settings.slot_count) return;
    uvec2 pixel = slot_pixel(slot);
    if (any(greaterThanEqual(pixel, uvec2(settings.end_x, settings.end_y)))) return;
    if (settings.show_mode == show_centres) {
        imageStore(known, ivec2(pixel), vec4(pixel_value(slot, 1u), 1.0f));
        return;
    }
    uint count = settings.known_samples;
    if (settings.show_mode == show_started) count += work[slot_field(slot, field_sample)];
    if (imageLoad(known, ivec2(pixel)).a == 0.0f) count = 0u; // finished before the adaptive passes
    vec3 value = count == 0u ? spread(ivec2(pixel), int(settings.known_step)) : pixel_value(slot, count);
    imageStore(shown, ivec2(pixel), vec4(value, 1.0f));
}
