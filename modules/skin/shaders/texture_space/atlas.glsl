// A map's texels as lists: GpuAtlas of texture_space/gpu_atlas.h.
layout(local_size_x = 64) in;
const uint kListColumns = 1024u;
uniform uint list_size;

ivec2 list_texel(uint entry) { return ivec2(entry % kListColumns, entry / kListColumns); }
/// A place on the map from how lists hold it.
ivec2 map_texel(float packed_place) {
    int place = int(packed_place);
    return ivec2(place & 4095, place >> 12);
}
