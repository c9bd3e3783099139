// Where a slot is: in the buffers, and in the picture.

uint slot_field(uint slot, uint field) { return work_counters + field * settings.slot_count + slot; }

/// Slots may leave out pixels between them.
uvec2 slot_pixel(uint slot) {
    return uvec2(settings.tile_x, settings.tile_y) + settings.pixel_step * pixel_of_slot(slot, settings.tile_width);
}
