// The layers of an object's light maps (radiance_maps/light_maps.h), in the body's space.
struct Layer {
    mat4 clip_from_body;
    vec4 eye;   // w: 1 in perspective
    vec4 axis;  // unit, along which the light looks; w: side of the map, in perspective at distance 1
};
const int kMaxLayers = 160;
layout(std140) uniform Layers { Layer layers[kMaxLayers]; };
uniform int layer_count;
uniform int light_resolution;  // texels along a side
uniform float metres_of_unit;

/// Metres that the map's side covers at a place.
float metres_across(int layer, vec3 place) {
    float units = layers[layer].axis.w;
    if (layers[layer].eye.w > 0.0) units *= max(dot(place - layers[layer].eye.xyz, layers[layer].axis.xyz), 1e-6);
    return units * metres_of_unit;
}
/// Area that a texel stands for across the light's rays at a place, m2: light's flux through it is irradiance times this,
/// however the surface lies, so that slopes that the light grazes need no weight.
float texel_area(int layer, vec3 place) {
    float side = metres_across(layer, place) / float(light_resolution);
    float slant = 1.0;  // of the ray against the axis
    if (layers[layer].eye.w > 0.0) {
        vec3 ray = place - layers[layer].eye.xyz;
        slant = dot(ray, layers[layer].axis.xyz) / max(length(ray), 1e-12);
    }
    return side * side * max(slant, 0.0);
}

/// What is known of the gathering; written by enter.comp and advance.comp alone.
layout(std430) buffer State {
    uint gathered_frames;  // this one counts
    uint changed;          // texels of light maps that are lit otherwise than before
    uint restarted;        // in the frame before
    uint unused;
    uvec4 gather_groups;
    uvec4 filter_groups;
    uvec4 next_filter_groups;
} state;

