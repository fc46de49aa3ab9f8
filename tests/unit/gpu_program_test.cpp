#include <epoxy/gl.h>

#include <array>
#include <chrono>

#include "core/error.h"
#include "gpu/shader_library.h"
#include "gpu_fixture.h"

namespace tyndall::gpu {
namespace {

using GpuProgram = GpuTest;

/// Draws a fragment shader's `colour` over a target of one texture and returns its texels.
std::vector<glm::vec4> drawn(const Program& program, int width = 4, int height = 4) {
    Texture target({Shape::flat, Format::rgba32f, width, height}, "target");
    const std::array<Framebuffer::Attachment, 1> colours{{{&target}}};
    const Framebuffer framebuffer(colours, {}, "target");
    framebuffer.bind();
    program.use();
    draw_fullscreen();
    return target.read();
}

TEST_F(GpuProgram, FullScreenTriangleGivesUvFromTheBottomLeft) {
    ShaderLibrary library;
    library.set_text("test/uv.frag", "in vec2 uv;\nout vec4 colour;\nvoid main() { colour = vec4(uv, 0, 1); }\n");
    const auto texels = drawn(library.program({.name = "uv", .fragment = "test/uv.frag"}));
    EXPECT_NEAR(texels[0].x, 0.125f, 1e-5f);
    EXPECT_NEAR(texels[0].y, 0.125f, 1e-5f);
    EXPECT_NEAR(texels[7].x, 0.875f, 1e-5f);
    EXPECT_NEAR(texels[12].y, 0.875f, 1e-5f);
}

TEST_F(GpuProgram, UniformsOfEveryKindArrive) {
    ShaderLibrary library;
    library.set_text("test/sum.frag", R"(
uniform int a; uniform uint b; uniform float c; uniform ivec2 d; uniform ivec3 e;
uniform vec2 f; uniform vec3 g; uniform vec4 h; uniform mat3 m; uniform mat4 n; uniform float list[3]; uniform bool on;
out vec4 colour;
void main() {
    colour = vec4(float(a) + float(b) + c + float(d.x + d.y) + float(e.x + e.y + e.z),
                  f.x + f.y + g.x + g.y + g.z, h.x + h.w + (on ? 0.5 : 0.0), m[1][0] + n[3][1] + list[0] + list[2]);
})");
    const Program& program = library.program({.name = "sum", .fragment = "test/sum.frag"});
    program.set("a", 1);
    program.set("b", 2u);
    program.set("c", 0.5f);
    program.set("d", glm::ivec2(3, 4));
    program.set("e", glm::ivec3(5, 6, 7));
    program.set("f", glm::vec2(1, 2));
    program.set("g", glm::vec3(3, 4, 5));
    program.set("h", glm::vec4(1, 0, 0, 2));
    program.set("on", 1);
    glm::mat3 m(0.0f);
    m[1][0] = 10.0f;
    glm::mat4 n(0.0f);
    n[3][1] = 20.0f;
    program.set("m", m);
    program.set("n", n);
    program.set("list", 100.0f);
    program.set("list[2]", 200.0f);
    program.set("not_there", 1.0f);
    EXPECT_TRUE(program.has("list[1]") && program.has("a") && !program.has("not_there"));
    EXPECT_EQ(drawn(program)[0], glm::vec4(28.5f, 15.0f, 3.5f, 330.0f));
}

TEST_F(GpuProgram, TexturesBindByNameEvenInArrays) {
    ShaderLibrary library;
    library.set_text("test/tex.frag", R"(
uniform sampler2D maps[2];
uniform sampler2D other;
out vec4 colour;
void main() { colour = vec4(texture(maps[0], vec2(0.5)).r, texture(maps[1], vec2(0.5)).r, texture(other, vec2(0.5)).r, 1); }
)");
    std::vector<Texture> textures;
    for (int i = 0; i < 3; ++i) {
        textures.emplace_back(TextureDesc{Shape::flat, Format::r32f}, "map");
        textures.back().clear(0, glm::vec4(static_cast<float>(i + 1)));
    }
    const Program& program = library.program({.name = "tex", .fragment = "test/tex.frag"});
    program.texture("maps[0]", textures[0]);
    program.texture("maps[1]", textures[1]);
    program.texture("other", textures[2].name(), sampler({.filter = Filter::nearest}));
    EXPECT_EQ(drawn(program)[0], glm::vec4(1, 2, 3, 1));
    program.texture("maps", textures[2]);  // the first of the array
    EXPECT_EQ(drawn(program)[0].x, 3.0f);
}

TEST_F(GpuProgram, ShadowSamplersPassWhatIsNearer) {
    ShaderLibrary library;
    library.set_text("test/shadow.frag", R"(
uniform sampler2DShadow shadow;
out vec4 colour;
void main() { colour = vec4(texture(shadow, vec3(0.5, 0.5, 0.6)), texture(shadow, vec3(0.5, 0.5, 0.5)), texture(shadow, vec3(0.5, 0.5, 0.4)), 1); }
)");
    Texture depth({Shape::flat, Format::depth32f, 2, 2}, "shadow map");
    depth.clear(0, glm::vec4(0.5f));
    const Program& program = library.program({.name = "shadow", .fragment = "test/shadow.frag"});
    program.texture("shadow", depth, {.filter = Filter::nearest, .compare = true});
    EXPECT_EQ(drawn(program)[0], glm::vec4(1, 1, 0, 1));  // reversed-Z: 0.6 is nearer than 0.5
}

TEST_F(GpuProgram, ComputeStoresToImagesAndBlocks) {
    ShaderLibrary library;
    library.set_text("test/fill.comp", R"(
layout(local_size_x = 8) in;
layout(rgba16f) writeonly uniform image3D volume;
layout(std140) uniform Settings { vec4 scale; };
layout(std430) buffer Sums { uint total; };
void main() {
    ivec3 p = ivec3(gl_GlobalInvocationID);
    imageStore(volume, p, vec4(vec3(p), 1.0) * scale);
    atomicAdd(total, 1u);
}
)");
    Texture volume({Shape::volume, Format::rgba16f, 8, 2, 4}, "volume");
    const std::array<float, 8> settings{0, 0, 0, 0, 1, 2, 3, 1};
    const Buffer uniforms(std::span<const float>(settings), "settings");
    const uint32_t zero = 0;
    const Buffer sums(sizeof zero, &zero, "sums");
    const Program& program = library.program({.name = "fill", .compute = "test/fill.comp"});
    program.image("volume", volume, 0, true);
    program.block("Settings", uniforms);
    program.block("Sums", sums);
    program.use();
    glDispatchCompute(1, 2, 4);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    EXPECT_EQ(volume.read(0, 3)[13], glm::vec4(0.0f)) << "the first vec4 of the block is zero";
    GLint alignment = 0;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    if (alignment > 16) return;
    program.block("Settings", uniforms, 16, 16);
    glDispatchCompute(1, 2, 4);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    EXPECT_EQ(volume.read(0, 3)[13], glm::vec4(5, 2, 9, 1));
    uint32_t total = 0;
    sums.read(0, sizeof total, &total);
    EXPECT_EQ(total, 128u);
}

TEST_F(GpuProgram, GeometryShadersReachEveryLayer) {
    ShaderLibrary library;
    library.set_text("test/point.vert", "void main() { gl_Position = vec4(0); }");
    library.set_text("test/layers.geom", R"(
layout(triangles) in;
layout(triangle_strip, max_vertices = 9) out;
void main() {
    for (int layer = 0; layer < 3; ++layer) {
        for (int i = 0; i < 3; ++i) {
            gl_Layer = layer;
            gl_Position = vec4(vec2((i << 1) & 2, i & 2) * 2.0 - 1.0, 0.0, 1.0);
            EmitVertex();
        }
        EndPrimitive();
    }
})");
    library.set_text("test/layer.frag", "out vec4 colour; void main() { colour = vec4(float(gl_Layer + 1)); }");
    Texture target({Shape::array, Format::r32f, 4, 4, 3}, "layers");
    const std::array<Framebuffer::Attachment, 1> colours{{{&target}}};
    const Framebuffer framebuffer(colours, {}, "layers");
    framebuffer.bind();
    library
        .program({.name = "layers",
                  .vertex = "test/point.vert",
                  .geometry = "test/layers.geom",
                  .fragment = "test/layer.frag"})
        .use();
    draw_fullscreen();
    for (int layer = 0; layer < 3; ++layer)
        EXPECT_EQ(target.read(0, layer)[6].x, static_cast<float>(layer + 1)) << layer;
}

TEST_F(GpuProgram, TimersMeasureWork) {
    ShaderLibrary library;
    library.set_text("test/slow.frag", R"(
uniform int steps;
in vec2 uv;
out vec4 colour;
void main() {
    float x = uv.x;
    for (int i = 0; i < steps; ++i) x = sin(x + uv.y);
    colour = vec4(x);
})");
    const Program& program = library.program({.name = "slow", .fragment = "test/slow.frag"});
    program.set("steps", 1000);
    (void)drawn(program, 128, 128);
    Timer timer;
    EXPECT_LT(timer.milliseconds(), 0.0);
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 20; ++i) {  // more than the ring holds
        timer.begin();
        (void)drawn(program, 128, 128);
        timer.end();
    }
    glFinish();
    const std::chrono::duration<double, std::milli> all = std::chrono::steady_clock::now() - start;
    const double one = timer.milliseconds();
    EXPECT_GT(one, 0.0);
    EXPECT_LT(one, all.count()) << Timer::method();
    const Timer moved(std::move(timer));
}

}  // namespace
}  // namespace tyndall::gpu
