// A slot is a pixel of the tile and the rays pending for it, which are kept in `work` between dispatches: a sample's
// ray tree need not be finished in one. Nothing here knows the light model: an estimator (loop.glsl) opens its slot,
// takes path after path, adds to `terms`, lets further paths wait, and closes the slot.

/// A ray on its way, with the share of its light that reaches the pixel.
struct Path {
    vec3 origin;
    vec3 direction;
    vec3 weight;
    uint depth;
    uint term; // reflection or transmission below the first hit, else `invalid_index`
    uvec4 interiors;
};

struct Slot {
    uint number;
    uvec2 pixel;
    uint sample_number; // of the sample under way, or the next
    bool begun;         // a sample is under way
    bool covered;       // it hit something
    float weight;       // of that sample: 1 or −1
    uint waiting;       // paths in `work`; the last is taken first
    bool has_path;      // `path` is taken before these
    uint budget;        // paths that may still be followed in this dispatch
};

Slot slot = Slot(0u, uvec2(0u), 0u, false, false, 1.0f, 0u, false, 0u);
Path path;               // the one that is followed
vec3 terms[GLINT_TERMS]; // what the sample's light is made of so far
uvec4 rays = uvec4(0u);  // primary, reflected, refracted, shadow
uint left_out = 0u;      // rays below min_weight

// The state of a slot in `work`.
const uint state_waiting = 0xffffu;
const uint state_begun = 0x10000u;
const uint state_negative = 0x20000u;
const uint state_covered = 0x40000u;
const uint state_running = 0x80000u; // a dispatch has opened the slot and has not saved it

/// Adds light of the path to a term; below the first hit, to the term of the branch that leads there.
void add_to_pixel(uint term, vec3 light) {
    if (path.term != invalid_index) term = path.term;
    terms[GLINT_TERMS == 1 ? 0u : term] += path.weight * light;
}

void save_vector(uint at, vec3 v) {
    work[at] = floatBitsToUint(v.x);
    work[at + settings.slot_count] = floatBitsToUint(v.y);
    work[at + 2u * settings.slot_count] = floatBitsToUint(v.z);
}
vec3 saved_vector(uint at) {
    return vec3(uintBitsToFloat(work[at]), uintBitsToFloat(work[at + settings.slot_count]),
                uintBitsToFloat(work[at + 2u * settings.slot_count]));
}

uint term_field(uint term) { return slot_field(slot.number, field_terms + fields_of_term * term); }
uint ray_field(uint ray) { return term_field(uint(GLINT_TERMS)) + ray * fields_of_ray * settings.slot_count; }

/// Lets a path wait; the last is taken first.
void let_wait(Path p) {
    uint at = ray_field(slot.waiting++);
    uint stride = settings.slot_count;
    save_vector(at, p.origin);
    save_vector(at + 3u * stride, p.direction);
    save_vector(at + 6u * stride, p.weight);
    work[at + 9u * stride] = p.depth | (p.term == invalid_index ? 0u : p.term << 16);
#if GLINT_GLASS
    for (int i = 0; i < 4; ++i) work[at + uint(10 + i) * stride] = p.interiors[i];
#endif
}

/// Takes a path next; the path that was next waits.
void follow(Path next) {
    if (slot.has_path) let_wait(path);
    path = next;
    slot.has_path = true;
}

Path last_waiting() {
    uint at = ray_field(--slot.waiting);
    uint stride = settings.slot_count;
    uint info = work[at + 9u * stride];
    Path p = Path(saved_vector(at), saved_vector(at + 3u * stride), saved_vector(at + 6u * stride), info & 0xffffu,
                  info >> 16 == 0u ? invalid_index : info >> 16, uvec4(0u));
#if GLINT_GLASS
    for (int i = 0; i < 4; ++i) p.interiors[i] = work[at + uint(10 + i) * stride];
#endif
    return p;
}

/// The step of the filter's table that has `tail`, by binary search.
uint filter_step(float tail) {
    uint low = 0u;
    uint high = uint(filter_steps);
    while (high - low > 1u) {
        uint middle = (low + high) / 2u;
        if (filter_table.tails[middle] <= tail)
            low = middle;
        else
            high = middle;
    }
    return low;
}

FilterOffset pixel_offset(float u) {
    uint step_at = filter_step(filter_tail(u));
    return filter_offset(u, settings.filter_radius, int(step_at), int(settings.negative_filter_steps),
                         filter_table.tails[step_at], filter_table.tails[step_at + 1u]);
}

void begin_sample() {
    vec2 offset = vec2(0.0f);
    slot.weight = 1.0f;
    if (settings.samples > 1u) {
        uint key = pixel_key(settings.seed_low, settings.seed_high, slot.pixel.x, slot.pixel.y);
        vec2 u = sample_pair(key, slot.sample_number, 0u);
        FilterOffset x = pixel_offset(u.x);
        FilterOffset y = pixel_offset(u.y);
        offset = vec2(x.distance_to, y.distance_to);
        slot.weight = x.weight * y.weight;
    }
    PinholeCamera camera =
        PinholeCamera(settings.camera_eye, settings.camera_forward, settings.camera_right, settings.camera_up,
                      settings.image_width, settings.image_height);
    vec3 direction = pinhole_direction(camera, int(slot.pixel.x), int(slot.pixel.y), offset.x, offset.y);
    path = Path(camera.eye, direction, vec3(1.0f), 0u, invalid_index, settings.interiors_at_eye);
    slot.begun = true;
    slot.covered = false;
    ++rays.x;
}

/// From `terms` to the film.
void end_sample() {
    uint stride = settings.slot_count;
    uint sums = film_fields_of_term * uint(GLINT_TERMS);
    uint at = slot.number + (slot.weight > 0.0f ? 0u : sums / 2u * stride);
    for (int i = 0; i < GLINT_TERMS; ++i) {
        for (int axis = 0; axis < 3; ++axis) film[at + uint(3 * i + axis) * stride] += terms[i][axis];
        terms[i] = vec3(0.0f);
    }
    uint counts = slot.number + sums * stride;
    if (slot.weight > 0.0f) film[counts] += 1.0f;
    if (slot.covered) film[counts + (slot.weight > 0.0f ? 1u : 2u) * stride] += 1.0f;
    slot.begun = false;
    ++slot.sample_number;
}

/// False if there is nothing to do.
bool open_slot() {
    slot.number = settings.first_slot + gl_GlobalInvocationID.x;
    if (slot.number >= settings.end_slot) return false;
    slot.pixel = slot_pixel(slot.number);
    uint state_at = slot_field(slot.number, field_state);
    slot.sample_number = work[slot_field(slot.number, field_sample)] + settings.first_sample;
    if (any(greaterThanEqual(slot.pixel, uvec2(settings.end_x, settings.end_y))) ||
        slot.sample_number >= settings.end_sample)
        return false;
    uint state = work[state_at];
    // The driver ended the estimator's loop early: see gpu/dispatch_budget.h.
    if ((state & state_running) != 0u) {
        atomicOr(work[counter_faults], fault_loops);
        return false;
    }
    work[state_at] = state | state_running;
    atomicAdd(work[counter_unfinished], 1u);
    for (uint i = 0u; i < uint(GLINT_TERMS); ++i) terms[i] = saved_vector(term_field(i));
    slot.waiting = state & state_waiting;
    slot.begun = (state & state_begun) != 0u;
    slot.weight = (state & state_negative) != 0u ? -1.0f : 1.0f;
    slot.covered = (state & state_covered) != 0u;
    slot.has_path = false;
    slot.budget = settings.max_nodes;
    return true;
}

void save_slot() {
    if (slot.has_path) let_wait(path);
    work[slot_field(slot.number, field_sample)] = slot.sample_number - settings.first_sample;
    work[slot_field(slot.number, field_state)] = slot.waiting | (slot.begun ? state_begun : 0u) |
                                                 (slot.weight < 0.0f ? state_negative : 0u) |
                                                 (slot.covered ? state_covered : 0u);
    for (uint i = 0u; i < uint(GLINT_TERMS); ++i) save_vector(term_field(i), terms[i]);
    if (slot.sample_number >= settings.end_sample) atomicAdd(work[counter_unfinished], 0xffffffffu); // one less
}

// ── The ray of an iteration of the loop

// What the loop does next.
const uint phase_next = 0u;   // take a path
const uint phase_path = 1u;   // trace it to a surface
const uint phase_lights = 2u; // find a light that is worth a shadow ray
const uint phase_shadow = 3u; // trace the shadow ray
uint phase = phase_next;

// The ray that is traced: from its origin on, or from behind the hit `after`.
SpawnedRay ray;
Hit after;
bool any_hit; // any hit will do

void start_ray(SpawnedRay next_ray, bool any) {
    ray = next_ray;
    after = no_hit(0.0f);
    any_hit = any;
}

/// Hits have t < tmax.
Hit trace_ray() { return trace(ray.origin, ray.direction, next_float(ray.tmax, -1.0f), after, any_hit); }

/// Takes the next path. False if the slot has nothing more to do in this dispatch. Then it is saved, here and not after
/// the loop, since a driver may end that early.
bool next_path() {
    bool idle = !slot.has_path && slot.waiting == 0u;
    if (idle && slot.begun) end_sample();
    if ((idle && slot.sample_number >= settings.end_sample) || slot.budget == 0u ||
        turns >= settings.max_walk_steps) {
        save_slot();
        return false;
    }
    if (idle)
        begin_sample();
    else if (!slot.has_path)
        path = last_waiting();
    slot.has_path = false;
    --slot.budget;
    phase = phase_path;
    start_ray(SpawnedRay(path.origin, path.direction, infinite_t()), false);
    return true;
}

void close_slot() {
    if (interiors_overflowed) atomicOr(work[counter_faults], fault_interiors);
    for (uint i = 0u; i < 4u; ++i)
        if (rays[i] != 0u) atomicAdd(work[counter_rays + i], rays[i]);
    if (left_out != 0u) atomicAdd(work[counter_left_out], left_out);
}
