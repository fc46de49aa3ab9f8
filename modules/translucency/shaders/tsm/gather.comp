// Adds the light of one light's map to the pixels of an object.
//
// The map is a pyramid of flux and of where it entered. About the place where the light would see the pixel lie 4x4 cells
// as large as the texels of the finest level, about them 12 twice as large, and so on until all of the body is covered. So the
// light close to the pixel and the light from the other side of the body are one sum, over distances in space, with no
// seam in between.
#include "translucency/pixel.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"
#include "translucency/light_view.glsl"
#include "translucency/tsm/pyramid.glsl"

layout(rgba32f) readonly uniform image2D light_map;
layout(r32f) readonly uniform image2D light_spread;
layout(rgba32f) readonly uniform image2D kernels;  // LevelKernels
uniform ivec2 levels;         // first and last level that is looked at
uniform vec4 first;         // rgb exitance of the first level's kernel at no distance, 1/m2; a: its Gaussian's rate, 1/m2
uniform vec4 own_share;     // of the pixel's own light; a: 1/farthest, 1/m
uniform float keeps;        // 0: takes the place of what the pixel had
uniform float gathers;      // 0: there is no map, and all light leaves where it entered
uniform uint light_index;

const float kLastColumn = 255.0;
/// The most that the variance of the depth in a cell can be through its slope, in squares of its width.
const float kSteepest = 30.0;

struct Gathered {
    vec3 exitance;  // lm/m2
    vec3 near;      // of it, what the pixel's own light stands for better
    float deep;     // luminance of what has forgotten where it entered
};

vec4 kernel_of(int level, float r) {
    float column = sqrt(r * own_share.a) * kLastColumn;
    int i = min(int(column), int(kLastColumn) - 1);
    vec4 low = imageLoad(kernels, ivec2(i, level)), high = imageLoad(kernels, ivec2(i + 1, level));
    return max(mix(low, high, column - float(i)), vec4(0.0));
}

/// Four cells beside one another, or four texels that they are mixed from.
struct Row {
    vec4 light0, light1, light2, light3;  // as the map's
    vec4 spread;                          // luminance times the square of metres beyond the middle
};

Row mixed(Row low, Row high, float a, float b) {
    return Row(a * low.light0 + b * high.light0, a * low.light1 + b * high.light1, a * low.light2 + b * high.light2,
               a * low.light3 + b * high.light3, a * low.spread + b * high.spread);
}

/// Where the 4x4 cells of a level lie: each between four texels, with the same weights for all.
struct Block {
    ivec4 x;  // columns, and the last
    int last_x;
    vec4 left, right;  // weights of a cell's columns, 0 outside of the map
    float cell;        // in the window
    vec3 pixel;        // in the window; metres that a unit of it spans at the pixel
    int level;
    bool first;        // known when it is compiled
    float slope;       // variance of the depth in a cell that slopes as the pixel does, m2
};

Row row_of(Block block, int y) {
    vec4 t0 = imageLoad(light_map, ivec2(block.x.x, y)), t1 = imageLoad(light_map, ivec2(block.x.y, y));
    vec4 t2 = imageLoad(light_map, ivec2(block.x.z, y)), t3 = imageLoad(light_map, ivec2(block.x.w, y));
    vec4 t4 = imageLoad(light_map, ivec2(block.last_x, y));
    float s0 = imageLoad(light_spread, ivec2(block.x.x, y)).x, s1 = imageLoad(light_spread, ivec2(block.x.y, y)).x;
    float s2 = imageLoad(light_spread, ivec2(block.x.z, y)).x, s3 = imageLoad(light_spread, ivec2(block.x.w, y)).x;
    float s4 = imageLoad(light_spread, ivec2(block.last_x, y)).x;
    return Row(block.left.x * t0 + block.right.x * t1, block.left.y * t1 + block.right.y * t2,
               block.left.z * t2 + block.right.z * t3, block.left.w * t3 + block.right.w * t4,
               block.left * vec4(s0, s1, s2, s3) + block.right * vec4(s1, s2, s3, s4));
}

/// Adds a cell whose middle is `offset` cells from the pixel, which is z metres beyond the view's middle.
void add_cell(inout Gathered sum, Block block, vec4 light, float spread, vec2 offset, float z) {
    float share = 1.0 / max(luminance_rec709(light.rgb), 1e-30), mean = light.a * share;
    // of a near and a far surface in one cell; their middle is nowhere
    float variance = max(spread * share - mean * mean - block.slope, 0.0);
    float deeper = mean - z, wider = in_perspective() * deeper;
    vec3 d = vec3(offset * (block.cell * (block.pixel.z + wider)) + block.pixel.xy * wider, deeper);
    float r2 = dot(d, d) + variance;
    vec4 kernel = kernel_of(block.level, sqrt(r2));
    vec3 exitance = light.rgb * kernel.rgb;
    sum.exitance += exitance;
    sum.deep += luminance_rec709(exitance) * kernel.a;
    if (block.first) sum.near += light.rgb * exp2(-1.44269504 * first.a * r2);
}

void add_ends(inout Gathered sum, Block block, Row row, float y, float z) {
    add_cell(sum, block, row.light0, row.spread.x, vec2(-1.5, y), z);
    add_cell(sum, block, row.light3, row.spread.w, vec2(1.5, y), z);
}
void add_middle(inout Gathered sum, Block block, Row row, float y, float z) {
    add_cell(sum, block, row.light1, row.spread.y, vec2(-0.5, y), z);
    add_cell(sum, block, row.light2, row.spread.z, vec2(0.5, y), z);
}

/// All 16 cells of the first level, and of others the 12 that lie around the level before.
void add_level(inout Gathered sum, int level, bool is_first, vec3 at, float metres, float slope) {
    Block block;
    block.level = level;
    block.first = is_first;
    int last = (map_size >> (levels.x + level)) - 1;
    ivec2 origin = level_origin(levels.x + level);
    vec2 low = at.xy * float(last + 1) - 2.0, base = floor(low), f = low - base;
    ivec4 x = ivec4(base.x) + ivec4(0, 1, 2, 3), y = ivec4(base.y) + ivec4(0, 1, 2, 3);
    bvec4 within_x = equal(clamp(x, 0, last), x), within_y = equal(clamp(y, 0, last), y);
    block.x = clamp(x, 0, last) + origin.x;
    block.last_x = clamp(x.w + 1, 0, last) + origin.x;
    int last_y = clamp(y.w + 1, 0, last) + origin.y;
    float end_x = clamp(x.w, -1, last - 1) == x.w ? 1.0 : 0.0, end_y = clamp(y.w, -1, last - 1) == y.w ? 1.0 : 0.0;
    block.left = (1.0 - f.x) * vec4(within_x);
    block.right = f.x * vec4(vec4(within_x).yzw, end_x);
    float cell = view.window.z / float(last + 1);
    block.cell = cell;
    block.pixel = vec3(view.window.xy + view.window.z * at.xy, metres);
    block.slope = slope * cell * cell * metres * metres;
    // of the rows, and all cells' area
    vec4 lower = (cell * cell * (1.0 - f.y)) * vec4(within_y);
    vec4 upper = (cell * cell * f.y) * vec4(vec4(within_y).yzw, end_y);
    y = clamp(y, 0, last) + origin.y;
    Row r0 = row_of(block, y.x), r1 = row_of(block, y.y), cells = mixed(r0, r1, lower.x, upper.x);
    add_ends(sum, block, cells, -1.5, at.z);
    add_middle(sum, block, cells, -1.5, at.z);
    r0 = row_of(block, y.z);
    cells = mixed(r1, r0, lower.y, upper.y);
    add_ends(sum, block, cells, -0.5, at.z);
    if (block.first) add_middle(sum, block, cells, -0.5, at.z);
    r1 = row_of(block, y.w);
    cells = mixed(r0, r1, lower.z, upper.z);
    add_ends(sum, block, cells, 0.5, at.z);
    if (block.first) add_middle(sum, block, cells, 0.5, at.z);
    r0 = row_of(block, last_y);
    cells = mixed(r1, r0, lower.w, upper.w);
    add_ends(sum, block, cells, 1.5, at.z);
    add_middle(sum, block, cells, 1.5, at.z);
}

shared uint seen_by_group;

/// What
vec3 exitance_at(Pixel pixel) {
    vec3 at = light_place(pixel.place);
    float metres = window_metres(at.z);
    vec3 unused;
    light_distance(light_index, pixel.place, unused);
    float facing = dot(pixel.normal, unused);
    float slope = min(1.0 / max(facing * facing, 1e-3), kSteepest);
    at = vec3((at.xy / metres - view.window.xy) / view.window.z, at.z - view.window.w);
    Gathered sum = Gathered(vec3(0.0), vec3(0.0), 0.0);
    add_level(sum, 0, true, at, metres, slope);  // apart from the others, which then have no code of its own
    int last = seen_by_group != 0u && gathers > 0.0 ? levels.y - levels.x : 0, level = 1;
    if (last >= 1) do {
        add_level(sum, level, false, at, metres, slope);
    } while (++level <= last);
    // the pixel's own light
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, pixel.place, to_light);
    float cosine = clamp(dot(pixel.normal, to_light), 0.0, 1.0);
    irradiance *= light_transmittance(light_index, pixel.place, pixel.normal) * enters_to_wander(pixel.place);
    vec3 even = irradiance * entering(cosine) * leaving_share(cosine);
    vec3 own = even;
    vec3 others = vec3(0.0);
    if (gathers > 0.0) {
        // without a shadow map only the light's own map knows what is lit
        float sharp = light_data(light_index).shadow.x > 0.0 ? 1.0 : 0.0;
        own *= own_share.rgb * sharp;
        others = max(sum.exitance - first.rgb * sum.near * sharp, vec3(0.0));
    }
    float here = luminance_rec709(others + own);
    float deep = clamp(1.0 - luminance_rec709(even) / max(here, 1e-30), 0.0, 1.0) * sum.deep / max(luminance_rec709(sum.exitance), 1e-30);
    vec3 near = near_pattern(pixel.cosine);
    return mix(near, deep_pattern(pixel.cosine), deep) * others + near * own;
}

void main() {
    Pixel pixel = pixel_here();
    if (gl_LocalInvocationIndex == 0u) seen_by_group = 0u;
    barrier();
    if (pixel.seen) seen_by_group = 1u;
    barrier();
    vec3 exitance = exitance_at(pixel);
    if (pixel.seen) {
        vec4 had = keeps * imageLoad(light_diffuse, pixel.at);
        imageStore(light_diffuse, pixel.at, had + vec4(irradiance_as(exitance), 0.0));
    }
}
