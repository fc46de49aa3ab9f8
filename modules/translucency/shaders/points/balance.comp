// A step of scaling the kernel at both ends so that each point sends out all of its light, and receives as much: what
// leaves is what the half-space says, whatever the shape. A kernel of flat ground alone loses what would leave beyond the
// solid's end. Symmetric, so reciprocity stays (Sinkhorn & Knopp's balancing; the root for symmetric matrices is Knight,
// Ruiz & Ucar's).
#define SCALES_WRITTEN
#include "translucency/points/gather.glsl"

void scale(uint point, vec3 found) {
    vec3 before = scale_at(point);
    vec3 sum = found + before * kernel_at(0.0) * piece_at(point).area;
    // where the model returns nothing of a channel there is nothing to scale
    vec3 after = mix(sqrt(before / max(sum, vec3(1e-20))), vec3(1.0), lessThan(sum, vec3(1e-6)));
    imageStore(point_scales, node_texel(point), vec4(after, 0.0));
}

void main() {
    Four low = four_of_thread(0u), high = four_of_thread(4u);
    gather(low, high);
    for (uint i = 0u; i < 4u; ++i) {
        scale(low.points[i], exitance_of(low.sum, i).rgb);
        scale(high.points[i], exitance_of(high.sum, i).rgb);
    }
}
