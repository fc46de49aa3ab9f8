// How a light looks at an object: LightView of tsm/light_view.h.
uniform mat4 view_from_world;
uniform vec4 window;       // low corner, size, metres along the axis of the object's middle
uniform float perspective;  // 0 or 1

/// Metres that a unit of the window spans at a depth.
float window_metres(float z) { return mix(1.0, z, perspective); }
