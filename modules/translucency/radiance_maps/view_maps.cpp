#include "radiance_maps/view_maps.h"

#include <epoxy/gl.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "body_size.h"
#include "body_space.h"
#include "render/draw_state.h"

namespace tyndall::translucency {
namespace {

constexpr int kColumns = 1024;  ///< of the list, as in shaders/radiance_maps/gather.comp
/// Texels of the next finer level that the foremost may be away from others that count as the same surface.
constexpr float kSameSurface = 4.0f;

/// Triangles have edges no longer than this many radii: vertices have colours of their own.
constexpr float kLongestEdge = 0.1f;

/// Directions on a spiral, evenly over the sphere (Vogel's; no two rows of them line up, as with Halton's points).
glm::vec3 direction(int i, int count) {
    const float z = 1.0f - (2.0f * float(i) + 1.0f) / float(count);
    const float angle = float(i) * std::numbers::pi_v<float> * (3.0f - std::sqrt(5.0f));
    const float r = std::sqrt(std::max(1.0f - z * z, 0.0f));
    return {r * std::cos(angle), r * std::sin(angle), z};
}

struct ViewsBlock {
    std::array<glm::vec4, 3 * ViewMaps::kMaxViews> rows{};  ///< u, v, toward the camera and the map's side
};

/// One texel of four: the mean of those near the foremost.
glm::vec4 halved(const std::array<glm::vec4, 4>& four, const glm::vec3& axis, float apart) {
    const glm::vec4* front = nullptr;
    for (const glm::vec4& one : four)
        if (one.w > 0.0f && (front == nullptr || glm::dot(glm::vec3(one - *front), axis) < 0.0f)) front = &one;
    if (front == nullptr) return glm::vec4(0.0f);
    glm::vec3 sum(0.0f);
    float count = 0.0f;
    for (const glm::vec4& one : four)
        if (one.w > 0.0f && glm::distance(glm::vec3(one), glm::vec3(*front)) < apart) {
            sum += glm::vec3(one);
            count += 1.0f;
        }
    return {sum / count, front->w};
}

std::vector<glm::vec4> halved(const std::vector<glm::vec4>& fine, int size, const glm::vec3& axis, float apart) {
    const size_t width = size_t(size), half = width / 2;
    std::vector<glm::vec4> coarse(half * half);
    for (size_t y = 0; y < half; ++y)
        for (size_t x = 0; x < half; ++x) {
            const glm::vec4* at = &fine[2 * y * width + 2 * x];
            coarse[y * half + x] = halved({at[0], at[1], at[width], at[width + 1]}, axis, apart);
        }
    return coarse;
}

}  // namespace

ViewMaps::ViewMaps(gpu::ShaderLibrary& shaders, const Mesh& mesh, int views, int resolution)
    : drawn_(cut_mesh(mesh, kLongestEdge * mesh.bounds.radius())), resolution_(resolution), mesh_(drawn_) {
    middle = mesh.bounds.centre();
    for (const glm::vec3& vertex : drawn_.positions) radius = std::max(radius, glm::distance(vertex, middle));
    sphere_radius = body_radius(mesh, glm::mat3(1.0f));
    ViewsBlock block;
    for (int i = 0; i < views; ++i) {
        const glm::vec3 toward = direction(i, views);
        const MapView& view = views_.emplace_back(parallel_view(drawn_.positions, -toward, resolution));
        const glm::mat4 rows = glm::transpose(view.clip_from_body);
        const glm::vec4 half(0, 0, 0, 0.5f);
        glm::vec4* out = &block.rows[3 * size_t(i)];
        out[0] = 0.5f * rows[0] + half;
        out[1] = 0.5f * rows[1] + half;
        out[2] = glm::vec4(toward, view.side);
    }
    block_ = gpu::Buffer(sizeof block, &block, "translucency.maps.views");
    places_ = gpu::Texture({.shape = gpu::Shape::array,
                            .format = gpu::Format::rgba32f,
                            .width = resolution_,
                            .height = resolution_,
                            .layers = this->views(),
                            .mips = kLevels},
                           "translucency.maps.places");
    const std::vector<glm::vec3> nothing(4 * drawn_.positions.size());
    draw(shaders, gpu::Buffer(std::span<const glm::vec3>(nothing), "translucency.maps.own"), places_, {"PLACES"});
    list_and_halve();
}

void ViewMaps::draw_scales(gpu::ShaderLibrary& shaders, const gpu::Buffer& own, const gpu::Texture& scales) const {
    draw(shaders, own, scales, {"SCALES"});
}

void ViewMaps::draw(gpu::ShaderLibrary& shaders, const gpu::Buffer& own, const gpu::Texture& target,
                    std::vector<std::string> defines) const {
    const gpu::Texture depth({.format = gpu::Format::depth32f, .width = resolution_, .height = resolution_},
                             "translucency.maps.depth");
    const gpu::Program& program = shaders.program({.name = "translucency.radiance_maps.map",
                                                   .vertex = "translucency/radiance_maps/map.vert",
                                                   .fragment = "translucency/radiance_maps/map.frag",
                                                   .defines = std::move(defines)});
    program.use();
    const DrawState state(DepthState::write);
    for (int i = 0; i < views(); ++i) {
        const std::array<gpu::Framebuffer::Attachment, 1> colour{{{.texture = &target, .layer = i}}};
        const gpu::Framebuffer view(colour, {.texture = &depth}, "translucency.maps.view");
        view.bind();
        view.clear_colour(0, glm::vec4(0.0f));
        view.clear_depth();
        program.set("clip_from_body", views_[size_t(i)].clip_from_body);
        mesh_.draw(own);
    }
}

/// In the order of little squares, so that texels that are worked on together lie together.
void ViewMaps::list_and_halve() {
    constexpr int kSquare = 8;
    std::vector<uint32_t> list;
    for (int view = 0; view < views(); ++view) {
        std::vector<glm::vec4> level = places_.read(0, view);
        for (int corner_y = 0; corner_y < resolution_; corner_y += kSquare)
            for (int corner_x = 0; corner_x < resolution_; corner_x += kSquare)
                for (int i = 0; i < kSquare * kSquare; ++i) {
                    const int x = corner_x + i % kSquare, y = corner_y + i / kSquare;
                    if (x >= resolution_ || y >= resolution_) continue;
                    if (level[size_t(y) * size_t(resolution_) + size_t(x)].w > 0.0f)
                        list.push_back(uint32_t(x | y << 10 | view << 20));
                }
        const MapView& seen = views_[size_t(view)];
        for (int mip = 1, size = resolution_; mip < kLevels; ++mip, size /= 2) {
            const float texel = seen.side / float(size);
            level = halved(level, size, seen.axis, kSameSurface * texel);
            places_.upload(mip, view, level.data());
        }
    }
    texel_count_ = uint32_t(list.size());
    const int rows = std::max(1, (int(list.size()) + kColumns - 1) / kColumns);
    list.resize(size_t(rows) * kColumns, 0);
    texels_ = gpu::Texture({.format = gpu::Format::r32ui, .width = kColumns, .height = rows}, "translucency.maps.list");
    texels_.upload(0, 0, list.data());
}

size_t ViewMaps::bytes() const {
    const size_t texels = size_t(resolution_) * size_t(resolution_) * size_t(views());
    return mesh_.bytes() + texels * 16 * 21 / 16 + 4 * size_t(texels_.desc().width) * size_t(texels_.desc().height);
}

}  // namespace tyndall::translucency
