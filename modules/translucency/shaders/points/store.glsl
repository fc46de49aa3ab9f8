// What leaves at a point, of the light that has entered elsewhere and of its own.
uniform sampler2D open_light;  // of the point's own flux what pixels do not know of (around.comp)
layout(rgba32f) writeonly uniform image2D point_light;  // two a point: exitance of others' light, lm/m2, a share of it from deep inside; share of its own illuminance

void store(uint point, vec4 found) {
    Piece piece = piece_at(point);
    vec3 scale = scale_at(point);
    vec4 flux = texelFetch(node_fluxes, node_texel(point), 0);
    vec3 moved = texelFetch(node_places, node_texel(point), 0).xyz - piece.place;
    vec3 own = scale * kernel_at(dot(moved, moved));
    vec3 unknown = texelFetch(open_light, node_texel(point), 0).rgb;
    vec3 others = scale * found.rgb + own * unknown;
    // Deep inside was at most what is more than ground lit evenly by this point's light would give.
    vec3 even = flux.rgb / (max(scale, vec3(1e-6)) * piece.area);
    float here = luminance_rec709(others + own * (flux.rgb - unknown));
    float deep = clamp(1.0 - luminance_rec709(even) / max(here, 1e-30), 0.0, 1.0) * found.a / max(luminance_rec709(found.rgb), 1e-30);
    float share = flux.w > 0.0 ? texelFetch(node_places, node_texel(point), 0).w / flux.w : mean_entering();
    imageStore(point_light, node_texel(2u * point), vec4(others, deep));
    imageStore(point_light, node_texel(2u * point + 1u), vec4(own * scale * piece.area * share * mean_leaving(), 0.0));
}
