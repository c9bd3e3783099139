// A slot is one pixel of the tile and what is under way for it. Between two dispatches it waits in `work`:
// a sample's rays need not be followed to the end in one.

// Fields of a slot: sample, state, terms, then the rays that wait.
const uint state_waiting = 0xffffu; // how many rays wait
const uint state_begun = 0x10000u;
const uint state_negative = 0x20000u; // the sample's weight is −1
const uint state_covered = 0x40000u;  // it hit something
const uint state_running = 0x80000u;  // a dispatch has begun with the slot, and has not saved it
const uint fields_before_rays = field_terms + fields_of_term * uint(GLINT_TERMS);

void save_vector(uint at, vec3 v) {
    work[at] = floatBitsToUint(v.x);
    work[at + settings.slot_count] = floatBitsToUint(v.y);
    work[at + 2u * settings.slot_count] = floatBitsToUint(v.z);
}
vec3 saved_vector(uint at) {
    return vec3(uintBitsToFloat(work[at]), uintBitsToFloat(work[at + settings.slot_count]),
                uintBitsToFloat(work[at + 2u * settings.slot_count]));
}

uint ray_field(uint slot, uint ray) { return slot_field(slot, fields_before_rays + ray * fields_of_ray); }

void save_path(uint slot, uint ray, Path path) {
    uint at = ray_field(slot, ray);
    uint stride = settings.slot_count;
    save_vector(at, path.origin);
    save_vector(at + 3u * stride, path.direction);
    save_vector(at + 6u * stride, path.weight);
    work[at + 9u * stride] = path.depth | (path.term == none ? 0u : path.term << 16);
#if GLINT_GLASS
    for (int i = 0; i < 4; ++i) work[at + uint(10 + i) * stride] = path.media[i];
#endif
}

Path saved_path(uint slot, uint ray) {
    uint at = ray_field(slot, ray);
    uint stride = settings.slot_count;
    Path path;
    path.origin = saved_vector(at);
    path.direction = saved_vector(at + 3u * stride);
    path.weight = saved_vector(at + 6u * stride);
    uint info = work[at + 9u * stride];
    path.depth = info & 0xffffu;
    path.term = info >> 16 == 0u ? none : info >> 16;
    path.media = uvec4(0u);
#if GLINT_GLASS
    for (int i = 0; i < 4; ++i) path.media[i] = work[at + uint(10 + i) * stride];
#endif
    return path;
}

/// imaging/filter.cpp: along_axis(), its table searched by halving. The offset, and the sign of the filter.
vec2 filter_offset(float u) {
    bool left = u < 0.5f;
    float tail = left ? 2.0f * u : 2.0f - 2.0f * u;
    uint low = 0u;
    uint high = settings.filter_steps;
    while (high - low > 1u) {
        uint middle = (low + high) / 2u;
        if (tables[settings.first_tail + middle].x <= tail)
            low = middle;
        else
            high = middle;
    }
    float outer = tables[settings.first_tail + low].x;
    float inner = tables[settings.first_tail + low + 1u].x;
    float distance_to = filter_distance(settings.filter_radius, int(low), int(settings.filter_steps), tail, outer, inner);
    return vec2(left ? -distance_to : distance_to, low < settings.negative_filter_steps ? -1.0f : 1.0f);
}

/// The camera ray of a sample, and its weight.
Path primary_path(uvec2 pixel, uint number, uint samples, out float weight) {
    vec2 offset = vec2(0.0f);
    weight = 1.0f;
    if (samples > 1u) {
        vec2 u = sample_pair(pixel_key(settings.seed_low, settings.seed_high, pixel.x, pixel.y), number, 0u);
        vec2 x = filter_offset(u.x);
        vec2 y = filter_offset(u.y);
        offset = vec2(x.x, y.x);
        weight = x.y * y.y;
    }
    PinholeCamera camera = PinholeCamera(settings.camera_eye, settings.camera_forward,
                                         settings.camera_right, settings.camera_up,
                                         settings.image_width, settings.image_height);
    vec3 direction = pinhole_direction(camera, int(pixel.x), int(pixel.y), offset.x, offset.y);
    return Path(camera.eye, direction, vec3(1.0f), 0u, none, settings.interiors_at_eye);
}
