// Which samples are looked at, and which are interpolated from their neighbours on the line: a sample between two looks
// takes both, unless the depth breaks between; both sides of a break are looked at, and what lies on no plane with its two
// looks (an edge without a break). Near the light's place looks are closer together, since light falls off from there.
layout(local_size_x = 64) in;

uniform int slices;
uniform int samples;
uniform int initial_step;  // samples between looks
uniform float threshold;   // relative change of the distance that counts as a break
uniform vec2 epipole;      // pixels
layout(rgba32f) uniform readonly image2D slice_ends;
layout(r32f) uniform readonly image2D distances;
layout(rg32f) uniform writeonly image2D sources;  // samples to the left and right; both itself where it is looked at

// The step where sample i lies: halved until it is at most a quarter of the way from the light.
int step_at(int i, float from_light) {
    int width = initial_step;
    while (width > 1 && from_light + float(i / width * width) < 4.0 * float(width)) width /= 2;
    return width;
}

bool breaks(float a, float b) { return abs(a - b) > threshold * min(a, b); }

// Along a line, planes are linear in 1 / distance.
bool off_plane(float left, float here, float right, float share) {
    return abs(here * mix(1.0 / left, 1.0 / right, share) - 1.0) > 0.2 * threshold;
}

// One thread for each initial step of each slice.
void main() {
    int slice = int(gl_GlobalInvocationID.x);
    if (slice >= slices) return;
    int first = int(gl_GlobalInvocationID.y) * initial_step;
    vec4 ends = imageLoad(slice_ends, ivec2(slice, 0));
    float from_light = distance(ends.xy, epipole) / max(distance(ends.xy, ends.zw), 1e-3) * float(samples - 1);
    int left[65];
    float at[65];
    for (int i = 0; i <= initial_step; ++i) at[i] = imageLoad(distances, ivec2(slice, min(first + i, samples - 1))).r;
    for (int i = 0; i < initial_step; ++i) {
        bool begins = i == 0 || (first + i) % step_at(first + i, from_light) == 0;
        left[i] = begins || breaks(at[i - 1], at[i]) ? i : left[i - 1];
    }
    int right = initial_step;
    for (int i = initial_step - 1; i >= 0; --i) {
        bool begins_after = (first + i + 1) % step_at(first + i + 1, from_light) == 0;
        if (breaks(at[i], at[i + 1])) right = i;
        else if (begins_after) right = i + 1;
        float share = float(i - left[i]) / float(max(right - left[i], 1));
        bool looked_at = left[i] == i || right == i || off_plane(at[left[i]], at[i], at[right], share);
        ivec2 both = looked_at ? ivec2(i) : ivec2(left[i], right);
        if (first + i < samples) imageStore(sources, ivec2(slice, first + i), vec4(first + both, 0.0, 0.0));
    }
}
