// A material's map where the light map has its texels: bind_slot() of texture_space/surface_finish.h.
#define SLOT(NAME) \
    uniform sampler2D NAME; \
    uniform float NAME##_share; \
    uniform vec3 NAME##_rows[2]; \
    vec2 NAME##_place(vec2 uv) { return vec2(dot(NAME##_rows[0], vec3(uv, 1.0)), dot(NAME##_rows[1], vec3(uv, 1.0))); }

/// What is darker counts as this dark: the picture divides by its power.
const float kLeastColour = 1e-3;
