// The mean over frames of what was marched, where it still holds. Light is told from what it was by its share of the guide,
// which is known now as it was then.
//
// Light has no one place on a ray; it is looked for where it was seen if it came from half way. What is not found in that way
// is outside of what the pixel's neighbours have now, and is brought back to that.
#include "participating_media/march/guide.glsl"

uniform sampler2D marched;  // rgb radiance, a its guide
uniform sampler2D before;   // the same, a mean over the last frames
uniform int frames;         // in a row in which nothing but the camera moved

out vec4 accumulated;  // rgb radiance, a its guide

const float kLeastWeight = 0.0625;   // of a frame in the mean
const float kFadeBetween = 0.125;    // more of it for each pixel by which the picture moves: each frame interpolates once more
const float kFadeApart = 0.5;        // and for each pixel by which near and far light on the ray move apart
const float kOtherGuide = 0.1;       // relative change of the guide beyond which another thing is seen

vec3 share_of(vec4 light) { return light.rgb / max(light.a, 1e-30); }

/// Where a place seen from the eye was on the screen of the last frame.
vec2 place_before(vec3 from_eye, out float w) {
    vec4 clip = frame.previous_view_projection * vec4(frame.eye_near.xyz + from_eye, 1.0);
    w = clip.w;
    return clip.xy / max(clip.w, 1e-6) * 0.5 + 0.5;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 size = textureSize(marched, 0);
    vec4 now = texelFetch(marched, at, 0);
    vec3 share = share_of(now), least = share, most = share;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            vec3 other = share_of(texelFetch(marched, clamp(at + ivec2(x, y), ivec2(0), size - 1), 0));
            least = min(least, other);
            most = max(most, other);
        }
    }
    ivec2 pixel = marched_pixel(at);
    vec2 uv = pixel_uv(pixel);
    vec3 ray = pixel_metres(pixel) * eye_ray(uv);
    float w;
    vec2 shift = place_before(0.5 * ray, w) - uv;  // of the picture since the last frame
    vec2 old_place = (vec2(at) + 0.5) / vec2(size) + shift;
    vec4 old = textureLod(before, old_place, 0.0);
    bool holds = frames > 0 && w > 0.0 && all(greaterThan(old_place, vec2(0.0))) && all(lessThan(old_place, vec2(1.0))) &&
                 abs(old.a - now.a) <= kOtherGuide * now.a;
    float between = length(shift * vec2(size));
    float apart = length((place_before(0.25 * ray, w) - place_before(ray, w)) * vec2(size));
    float weight = min(max(1.0 / float(frames + 1), kLeastWeight) + kFadeBetween * between + kFadeApart * apart, 1.0);
    vec3 mean = mix(clamp(share_of(old), least, most), share, weight);
    accumulated = vec4((holds ? mean : share) * now.a, now.a);
}
