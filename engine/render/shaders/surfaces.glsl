// Surfaces and materials as GpuScene uploads them (render/gpu_scene.cpp, render/material_table.h: keep the same).

struct SurfaceRecord {
    mat4 world_from_local;
    mat4 previous_world_from_local;
    vec4 normal_from_local[3];  // columns of the inverse transpose
    uvec4 material;             // x index into materials[]
};
layout(std430) readonly buffer Surfaces { SurfaceRecord surfaces[]; };

struct MaterialRecord {
    vec4 base_colour;
    vec4 emissive_normal_scale;                // rgb cd/m2
    vec4 metallic_roughness_occlusion_cutoff;
    vec4 specular_colour_weight;
    vec4 ior_model;                            // x index of refraction, y number of the shading model
    vec4 uv_rows[14];                          // two rows a map: xyz = row of the transform, w of the first = UV set
};
layout(std430) readonly buffer Materials { MaterialRecord materials[]; };
