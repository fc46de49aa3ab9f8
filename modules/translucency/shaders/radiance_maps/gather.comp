// What leaves at each texel of the views' maps, of the light that has entered elsewhere: a number of samples more.
//
// Samples are places on a light's map. Their density is that of the kernel's own Gaussians about where the light's ray
// through the texel enters, as broad as they are so far below it, less far and at the surface, and one that is even over
// the map; what is found is divided by it. So nothing has to be chosen by hand, and the mean is the integral.
#include "translucency/interior.glsl"
#include "translucency/directions.glsl"
#include "translucency/radiance_maps/layers.glsl"
#include "physics/sequences.glsl"
#ifdef DIRECTIONAL
#include "physics/bssrdf.glsl"
#endif

layout(local_size_x = 64) in;
uniform sampler2DArray places;
uniform sampler2DArray scales;  // what the kernel is multiplied by where the light leaves
uniform usampler2D texels;
uniform sampler2DArray entry_places;
uniform sampler2DArray entry_fluxes;
uniform sampler2D blue_noise;
layout(rgba32f) uniform image2DArray leaving;  // exitance, lm/m2; a: luminance of what comes from deep
uniform int texel_count;
uniform int samples;
uniform float piece_radius;  // metres

const int kColumns = 1024;
const float kEvenly = 0.2;  // share of samples that are even over the map

/// How samples are spread over a layer: cumulated shares of eight Gaussians, the widest first, each with four times the
/// rate of the one before; the rest is even over the map. Each stands for two of the kernel's.
struct Spread {
    vec4 wide, narrow;             // cumulated
    vec4 wide_share, narrow_share;
    vec2 middle;                   // uv
    float across;                  // metres of the map's side
};
/// Rates of the eight over that of the widest.
const vec4 kWide = vec4(1.0, 4.0, 16.0, 64.0), kNarrow = 256.0 * kWide;

/// Adds to the shares those of the kernel as it is `below2` squared metres away, `share` in all.
void add_below(inout Spread spread, vec4 wide, vec4 narrow, float below2, float share) {
    vec4 rates = -1.44269504 * interior.kernel_rate.x * below2 * kWide;
    vec4 deep_wide = wide * exp2(rates), deep_narrow = narrow * exp2(256.0 * rates);
    share /= max(dot(deep_wide + deep_narrow, vec4(1.0)), 1e-30);
    spread.wide_share += share * deep_wide;
    spread.narrow_share += share * deep_narrow;
}

/// `below2`: squared metres from the texel to where the light's ray through it enters. In a shadow, what is lit may be
/// nearer than that, but seldom beside the texel: hence the third.
void spread_below(inout Spread spread, vec4 wide, vec4 narrow, float below2, float evenly) {
    float share = (1.0 - evenly) / 3.0;
    spread.wide_share = share * wide;
    spread.narrow_share = share * narrow;
    add_below(spread, wide, narrow, below2, share);
    add_below(spread, wide, narrow, 0.12 * below2, share);
    vec4 w = spread.wide_share, n = spread.narrow_share;
    spread.wide = vec4(w.x, w.x + w.y, w.x + w.y + w.z, w.x + w.y + w.z + w.w);
    spread.narrow = spread.wide.w + vec4(n.x, n.x + n.y, n.x + n.y + n.z, n.x + n.y + n.z + n.w);
}

/// Below: the largest cumulated share that is not above xi; next: the smallest above; rate: of the Gaussian in between.
#define CHOOSE(limit) here = vec4(greaterThanEqual(xi, vec4(limit))); \
    below = mix(below, vec4(limit), here); rate = rate * (1.0 + 3.0 * here);
#define UPPER(limit) next = mix(vec4(limit), next, vec4(greaterThanEqual(xi, vec4(limit))));

/// Four places on the map by two numbers each, and their density over it.
void sampled(Spread spread, vec4 xi, vec4 turn, out vec4 u, out vec4 v, out vec4 density) {
    vec4 below = vec4(0.0), next = vec4(1.0), here, rate = vec4(interior.kernel_rate.x);
    CHOOSE(spread.wide.x) CHOOSE(spread.wide.y) CHOOSE(spread.wide.z) CHOOSE(spread.wide.w)
    CHOOSE(spread.narrow.x) CHOOSE(spread.narrow.y) CHOOSE(spread.narrow.z) CHOOSE(spread.narrow.w)
    UPPER(spread.narrow.w) UPPER(spread.narrow.z) UPPER(spread.narrow.y) UPPER(spread.narrow.x)
    UPPER(spread.wide.w) UPPER(spread.wide.z) UPPER(spread.wide.y) UPPER(spread.wide.x)
    vec4 within = clamp((xi - below) / max(next - below, 1e-9), 0.0, 0.999999);
    vec4 r = sqrt(-log(1.0 - within) / rate) / spread.across, angle = 6.28318531 * turn;
    bvec4 evenly = greaterThanEqual(xi, vec4(spread.narrow.w));
    u = mix(spread.middle.x + r * cos(angle), within, evenly);
    v = mix(spread.middle.y + r * sin(angle), turn, evenly);
    vec4 x = (u - spread.middle.x) * spread.across, y = (v - spread.middle.y) * spread.across;
    float rate0 = interior.kernel_rate.x;
    vec4 g = exp2(-1.44269504 * rate0 * (x * x + y * y)), sum = spread.wide_share.x * g;
    vec4 wide = spread.wide_share * kWide, narrow = spread.narrow_share * kNarrow;
    g *= g; g *= g; sum += wide.y * g;
    g *= g; g *= g; sum += wide.z * g;
    g *= g; g *= g; sum += wide.w * g;
    g *= g; g *= g; sum += narrow.x * g;
    g *= g; g *= g; sum += narrow.y * g;
    g *= g; g *= g; sum += narrow.z * g;
    g *= g; g *= g; sum += narrow.w * g;
    density = sum * (rate0 * spread.across * spread.across / 3.14159265) + (1.0 - spread.narrow.w);
}

/// Exitance of four places a unit of flux, a channel each.
struct Exitances {
    vec4 red, green, blue;
};
#define GAUSSIAN(k) w = interior.kernel[k].rgb; e.red += w.r * g; e.green += w.g * g; e.blue += w.b * g; g *= g;

Exitances kernel_of_four(vec4 r2) {
    Exitances e = Exitances(vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 g = exp2(-1.44269504 * interior.kernel_rate.x * r2);
    vec3 w;
    GAUSSIAN(15) GAUSSIAN(14) GAUSSIAN(13) GAUSSIAN(12) GAUSSIAN(11) GAUSSIAN(10) GAUSSIAN(9) GAUSSIAN(8)
    GAUSSIAN(7) GAUSSIAN(6) GAUSSIAN(5) GAUSSIAN(4) GAUSSIAN(3) GAUSSIAN(2) GAUSSIAN(1) GAUSSIAN(0)
    return e;
}

#ifdef DIRECTIONAL
Diffusion diffusion;  // set once, at the beginning
vec3 directional(vec3 kernel, vec3 apart, float r2, float entry_normal, float direction, vec3 normal) {
    // places that touch are no points to one another
    float far = smoothstep(2.0 * piece_radius, 4.0 * piece_radius, sqrt(r2));
    return mix(kernel, interior.published.rgb * directional_dipole(diffusion, apart, unpacked_normal(direction),
                                                                   unpacked_normal(entry_normal - 1.0), normal), far);
}
#endif

/// Luminance a unit of area of what leaves here if all around is lit as this place is (deep light comes from farther).
float even_light(int layer, ivec2 texel, vec4 entry, float below2, vec3 normal) {
    vec3 flux = texelFetch(entry_fluxes, ivec3(texel, layer), 0).rgb;
    float area = texel_area(layer, entry.xyz), side2 = area * 9.0;
    vec3 ray = layers[layer].eye.w > 0.0 ? normalize(entry.xyz - layers[layer].eye.xyz) : layers[layer].axis.xyz;
    float here = max(1.0 - below2 / (side2 + 0.25 * first_path() * first_path()), 0.0);
    return here * luminance_rec709(flux) * max(-dot(ray, normal), 0.0) / area;
}

/// What four samples found: flux of the entry, and where it is.
struct Entries {
    vec4 fluxes[4];
    vec4 places[4];
};
Entries entries_at(int layer, vec4 u, vec4 v) {
    Entries entries;
    for (int i = 0; i < 4; ++i) {
        ivec2 at = ivec2(floor(vec2(u[i], v[i]) * float(light_resolution)));
        ivec3 texel = ivec3(clamp(at, ivec2(0), ivec2(light_resolution - 1)), layer);
        entries.fluxes[i] = texelFetch(entry_fluxes, texel, 0);
        if (at != texel.xy) entries.fluxes[i].rgb = vec3(0.0);
        entries.places[i] = texelFetch(entry_places, texel, 0);
    }
    return entries;
}

/// Of four samples: exitance over density, and luminance of it that comes from deep inside.
vec4 found_by_four(int layer, vec3 place, vec3 normal, Spread spread, vec4 xi, vec4 turn) {
    vec4 u, v, density, r2;
    sampled(spread, xi, turn, u, v, density);
    Entries entries = entries_at(layer, u, v);
    for (int i = 0; i < 4; ++i) {
        vec3 apart = (place - entries.places[i].xyz) * metres_of_unit;
        r2[i] = dot(apart, apart);
    }
    Exitances e = kernel_of_four(r2);
    vec4 deep = 1.0 - exp2(-interior.kernel_rate.y * sqrt(r2));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        vec3 kernel = vec3(e.red[i], e.green[i], e.blue[i]);
#ifdef DIRECTIONAL
        vec3 apart = (place - entries.places[i].xyz) * metres_of_unit;
        kernel = directional(kernel, apart, r2[i], entries.places[i].w, entries.fluxes[i].w, normal);
#endif
        vec3 leaves = entries.fluxes[i].rgb * kernel / density[i];
        sum += vec4(leaves, luminance_rec709(leaves) * deep[i]);
    }
    return sum;
}

vec4 gathered(int layer, vec3 place, vec3 normal, vec2 rotation, uint first, int count, vec4 wide, vec4 narrow,
              inout float even) {
    Spread spread;
    vec4 clip = layers[layer].clip_from_body * vec4(place, 1.0);
    bool seen = clip.w > 0.0;  // else the light looks away from here
    spread.middle = seen ? 0.5 + 0.5 * clip.xy / clip.w : vec2(0.5);
    spread.across = metres_across(layer, place);
    float size = float(light_resolution);
    ivec2 texel = ivec2(floor(spread.middle * size)), clamped = clamp(texel, ivec2(0), ivec2(light_resolution - 1));
    vec4 hit = texelFetch(entry_places, ivec3(clamped, layer), 0);
    float below2 = 0.0;
    if (seen && texel == clamped && hit.w > 0.0) {
        vec3 below = (place - hit.xyz) * metres_of_unit;
        below2 = dot(below, below);
        spread.across = metres_across(layer, hit.xyz);
        even += even_light(layer, texel, hit, below2, normal);
    }
    spread_below(spread, wide, narrow, below2, seen ? kEvenly : 1.0);
    vec4 sum = vec4(0.0);
    int i = 0;
    do {
        vec4 xi, turn;
        for (int k = 0; k < 4; ++k) {
            vec2 both = fract(r2_sequence(first + uint(i + k)) + rotation);
            xi[k] = both.x;
            turn[k] = both.y;
        }
        sum += found_by_four(layer, place, normal, spread, xi, turn);
    } while ((i += 4) < count);
    return sum * (size * size / float(count));
}

void main() {
    int i = int((gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x);
    if (i >= texel_count) return;
    uint number = texelFetch(texels, ivec2(i % kColumns, i / kColumns), 0).x;
    ivec3 texel = ivec3(number & 1023u, (number >> 10) & 1023u, number >> 20);
    vec4 seen = texelFetch(places, texel, 0);
    vec3 normal = unpacked_normal(seen.w - 1.0);
    int count = 4 * max(1, samples / (4 * max(layer_count, 1)));
    uint frame = state.gathered_frames - 1u;
#ifdef DIRECTIONAL
    diffusion = make_diffusion(interior.sigma_s_reduced.rgb, interior.sigma_a.rgb, 0.0, interior_eta());
#endif
    // another corner of the mask for each view
    ivec2 shift = ivec2(texel.z * 23, texel.z * 41);
    vec2 rotation = vec2(texelFetch(blue_noise, (texel.xy + shift) & 63, 0).x,
                         texelFetch(blue_noise, (texel.xy + shift + ivec2(29, 37)) & 63, 0).x);
    vec4 sum = vec4(0.0);
    float even = 0.0;
    for (int layer = 0; layer < layer_count; ++layer)
        sum += gathered(layer, seen.xyz, normal, rotation, frame * uint(count), count, interior.plane_wide, interior.plane_narrow, even);
    float unscaled = luminance_rec709(sum.rgb);
    sum.rgb *= texelFetch(scales, texel, 0).rgb;
    float scale = luminance_rec709(sum.rgb) / max(unscaled, 1e-30);
    vec4 before = frame > 0u ? imageLoad(leaving, texel) : vec4(0.0);
    vec3 mean = mix(before.rgb, sum.rgb, 1.0 / float(frame + 1u));
    float deep = clamp(1.0 - scale * even / max(luminance_rec709(mean), 1e-30), 0.0, 1.0) * scale * sum.a;
    imageStore(leaving, texel, vec4(mean, mix(before.a, deep, 1.0 / float(frame + 1u))));
}
