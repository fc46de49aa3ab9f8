#include "physics/all.glsl"
#include "tests/physics_sweep.glsl"

layout(local_size_x = 64) in;
layout(std430) readonly buffer Inputs { vec4 inputs[]; };
layout(std430) writeonly buffer Results { float results[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    for (int which = 0; which < kSweeps; ++which) results[i * uint(kSweeps) + uint(which)] = sweep(which, inputs[i]);
}
