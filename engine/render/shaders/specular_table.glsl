// The GGX lobe's directional albedo (physics/tables.h).
#include "physics/standard_surface.glsl"

uniform sampler2D specular_table;

vec2 specular_table_at(float nov, float roughness) {
    return textureLod(specular_table, standard_table_coordinate(nov, roughness, float(textureSize(specular_table, 0).x)),
                      0.0).xy;
}
