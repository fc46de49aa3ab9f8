// A phase function by its scattering angle (phase_table.h).
#include "physics/constants.glsl"

uniform sampler2D phase_table;  // 1/sr, the first forward
const float kPhaseColumns = 1024.0;

vec3 phase_at(float u) {
    float column = acos(clamp(u, -1.0, 1.0)) * (kInversePi * (kPhaseColumns - 1.0)) + 0.5;
    return textureLod(phase_table, vec2(column / kPhaseColumns, 0.5), 0.0).rgb;
}
