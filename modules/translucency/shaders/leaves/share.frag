// What share of a thin surface's diffuse colour is of light that comes through.
#include "render/shaders/material.glsl"

layout(location = 0) out vec4 leaf_share;

void main() { leaf_share = vec4(material_at().through, 1.0); }
