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

#ifdef CHUNKS
layout(r32f) readonly uniform image2D chunk_list;
/// The list's entry to work on.
uint list_entry() {
    return uint(imageLoad(chunk_list, list_texel(gl_WorkGroupID.x)).x) * 64u + gl_LocalInvocationID.x;
}
#else
uint list_entry() { return gl_GlobalInvocationID.x; }
#endif
