// The transparent solids around a ray (scene/media.h): eight numbers of 16 bits, highest rank first, 0 where
// there are no more.

// Told to the host: a ray was in more than eight.
bool media_overflowed = false;

uint media_head(uvec4 media) { return media.x >> 16; }
uint media_object(uint medium) { return words[settings.first_interior + medium - 1u]; }

#if GLINT_GLASS
uvec4 media_with(uvec4 media, uint medium) {
    for (int i = 0; i < 4; ++i) {
        uint first = media[i] >> 16;
        uint second = media[i] & 0xffffu;
        uint greater = max(medium, first);
        medium = min(medium, first);
        first = greater;
        greater = max(medium, second);
        medium = min(medium, second);
        media[i] = first << 16 | greater;
    }
    if (medium != 0u) media_overflowed = true;
    return media;
}

uint media_entry(uvec4 media, int i) {
    return i > 7 ? 0u : (i % 2 == 0 ? media[i / 2] >> 16 : media[i / 2] & 0xffffu);
}

uvec4 media_without(uvec4 media, uint medium) {
    int shift = 0;
    uvec4 left;
    for (int i = 0; i < 4; ++i) {
        if (media_entry(media, 2 * i) == medium) shift = 1;
        uint first = media_entry(media, 2 * i + shift);
        if (media_entry(media, 2 * i + 1) == medium) shift = 1;
        left[i] = first << 16 | media_entry(media, 2 * i + 1 + shift);
    }
    return left;
}

uvec4 media_across(uvec4 media, uint medium, bool entering) {
    return entering ? media_with(media, medium) : media_without(media, medium);
}

bool media_hide(uvec4 media, uint object) {
    uint head = media_head(media);
    return head != 0u && object_is(object, object_solid) &&
           object_rank(media_object(head)) > object_rank(object);
}

float media_index(uvec4 media) {
    uint head = media_head(media);
    return head == 0u ? settings.index_outside : material_index(object_material(media_object(head)));
}
#else
uvec4 media_across(uvec4 media, uint medium, bool entering) { return media; }
bool media_hide(uvec4 media, uint object) { return false; }
float media_index(uvec4 media) { return settings.index_outside; }
#endif
