// Surfaces as GpuScene uploads them (render/gpu_scene.cpp: keep the same).

struct SurfaceRecord {
    mat4 world_from_local;
    mat4 previous_world_from_local;
    vec4 normal_from_local[3];  // columns of the inverse transpose; w of the first: number of the surface
};
layout(std430) readonly buffer Surfaces { SurfaceRecord surfaces[]; };
