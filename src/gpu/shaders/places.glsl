// Where slots are: in the buffers, and in the picture.

const uint counters = 16u; // of work: unfinished slots, faults, rays by kind
const uint counter_unfinished = 0u;
const uint counter_faults = 1u;
const uint counter_rays = 2u; // primary, reflected, refracted, shadow
const uint fault_media = 1u;
const uint fault_loops = 2u;

uint slot_field(uint slot, uint field) { return counters + field * settings.turn.z + slot; }

/// Slots go through the tile in squares of 8 × 8, and may leave pixels out between them.
uvec2 slot_pixel(uint slot) {
    uint square = slot / 64u;
    uint columns = settings.tile.z / 8u;
    uvec2 place = 8u * uvec2(square % columns, square / columns) + uvec2(slot % 8u, slot % 64u / 8u);
    return settings.tile.xy + settings.pass.x * place;
}
