// Where a slot is: in the buffers, and in the picture.

uint slot_field(uint slot, uint field) { return work_counters + field * settings.slot_count + slot; }

/// Slots go through the tile in squares, and may leave pixels out between them.
uvec2 slot_pixel(uint slot) {
    uint square = slot / square_slots;
    uint columns = settings.tile_width / square_width;
    uvec2 corner = square_width * uvec2(square % columns, square / columns);
    uvec2 in_tile = corner + uvec2(slot % square_width, slot % square_slots / square_width);
    return uvec2(settings.tile_x, settings.tile_y) + settings.pixel_step * in_tile;
}
