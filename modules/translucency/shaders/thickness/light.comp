// Adds one light: where it arrives, wrapped; and through the body, by how thick it is about here and by the eye's direction (Barre-Brisebois & Bouchard 2011; Real-Time Rendering (14.30)).
#include "translucency/pixel.glsl"
#include "translucency/around.glsl"

uniform sampler3D thickness;
uniform mat4 grid_from_world;
uniform float grid_metres;     // of a unit of the thickness
uniform sampler2D through;     // share of light that leaves beyond a distance, over the root of it over the farthest
uniform float farthest;        // metres
uniform vec4 lobe;             // distortion, power, ambient, scale
uniform float keeps;           // 0: takes the place of what the pixel had

void main() {
    ivec2 at = first_seen();
    do {
        Pixel pixel = pixel_at(at);
        vec3 to_light;
        vec3 irradiance = light_irradiance(light_index, pixel.place, to_light);
        vec3 around = irradiance * transmittance_to_body(pixel.place, to_light);
        vec3 light = wrapped_light(irradiance, around, pixel.place, pixel.normal, dot(pixel.normal, to_light));
        float metres = grid_metres * textureLod(thickness, (grid_from_world * vec4(pixel.place, 1.0)).xyz, 0.0).x;
        vec3 passes = texelFetch(through, ivec2(int(sqrt(min(metres / farthest, 1.0)) * 2047.0 + 0.5), 0), 0).rgb;
        vec3 share = passes / (1.0 + passes);  // of the two sides
        vec3 front = light * (1.0 - share) * near_pattern(pixel.cosine);
        vec3 view = -eye_ray((vec2(at) + 0.5) / frame.size_time.xy);
        vec3 bent = normalize(to_light + lobe.x * pixel.normal + 1e-6 * view);
        float toward_eye = pow(max(dot(view, -bent), 1e-6), lobe.y);
        // a quarter: of parallel light a body receives so much a unit of its surface, if it is as round as a sphere
        float pattern = 0.25 * lobe.w * (lobe.z + (1.0 - lobe.z) * (lobe.y + 1.0) * toward_eye);
        vec3 back = around * pattern * share * deep_pattern(pixel.cosine);
        vec3 exitance = (front + back) * mean_entering() * mean_leaving();
        if (pixel.seen) {
            vec4 had = keeps * imageLoad(light_diffuse, at);
            imageStore(light_diffuse, at, had + vec4(irradiance_as(exitance), 0.0));
        }
        at = next_seen(at);
    } while (within_column(at));
}
