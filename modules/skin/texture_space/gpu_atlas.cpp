#include "texture_space/gpu_atlas.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <glm/vec4.hpp>
#include <span>
#include <utility>
#include <vector>

namespace tyndall::skin {
namespace {

template <class T>
gpu::Texture make_list(std::vector<T> entries, gpu::Format format, std::string_view label) {
    const int rows = std::max(1, (int(entries.size()) + kListColumns - 1) / kListColumns);
    entries.resize(size_t(rows) * kListColumns);
    gpu::Texture texture({.format = format, .width = kListColumns, .height = rows}, label);
    texture.upload(0, 0, entries.data());
    return texture;
}

/// A place as one number, exact below 4096 texels a side.
float packed(const glm::ivec2& at) {
    return float(at.y * 4096 + at.x);
}

glm::vec4 packed(const TexelSteps& steps, const glm::ivec2& at) {
    return {steps.along_u, steps.lean, steps.along_v, packed(at)};
}

/// The atlas' gutters: those far from covered texels, then those near, then padding; and how many are far.
std::pair<std::vector<const GutterTexel*>, int> sorted_gutters(const Atlas& atlas) {
    constexpr int kNear = 2;  // texels; half as many on a coarser map
    std::vector<uint8_t> near(size_t(atlas.extent()) * size_t(atlas.extent()), 0);
    for (const AtlasTexel& texel : atlas.texels)
        for (int y = -kNear; y <= kNear; ++y)
            for (int x = -kNear; x <= kNear; ++x) near[atlas.index(texel.at + glm::ivec2(x, y))] = 1;
    std::vector<const GutterTexel*> sorted;
    for (const GutterTexel& gutter : atlas.gutters) sorted.push_back(&gutter);
    const auto pads = sorted.end() - std::ptrdiff_t(atlas.padding);
    const auto far_end = std::stable_partition(
        sorted.begin(), pads, [&](const GutterTexel* gutter) { return near[atlas.index(gutter->at)] == 0; });
    const int far = int(far_end - sorted.begin());
    return {std::move(sorted), far};
}

}  // namespace

GpuAtlas::GpuAtlas(const Atlas& atlas, bool surface)
    : extent(atlas.extent()), gutters(int(atlas.gutters.size() - atlas.padding)), padding(int(atlas.padding)) {
    std::vector<glm::vec4> step_list, tap_list, weight_list, place_list, normal_list;
    std::vector<float> chart_list, gutter_chart_list;
    const auto add = [&](const AtlasTexel& texel) {
        step_list.push_back(packed(texel.steps, texel.at));
        chart_list.push_back(float(texel.chart));
        place_list.emplace_back(texel.position, packed(texel.at));
        normal_list.emplace_back((1.0f + texel.curvature) * texel.normal, float(texel.chart));
    };
    const std::vector<size_t> begins = chunk_begins(atlas);
    for (size_t chunk = 0; chunk + 1 < begins.size(); ++chunk) {
        for (size_t i = begins[chunk]; i < begins[chunk + 1]; ++i) add(atlas.texels[i]);
        while (step_list.size() % kChunkTexels != 0) add({.normal = {0.0f, 0.0f, 1.0f}});
    }
    covered = int(step_list.size());
    const auto [sorted, far] = sorted_gutters(atlas);
    far_gutters = far;
    for (const GutterTexel* entry : sorted) {
        const GutterTexel& gutter = *entry;
        tap_list.emplace_back(packed(gutter.taps[0]), packed(gutter.taps[1]), packed(gutter.taps[2]),
                              packed(gutter.taps[3]));
        weight_list.emplace_back(gutter.weights[0], gutter.weights[1], gutter.weights[2], packed(gutter.at));
        gutter_chart_list.push_back(float(gutter.chart));
        if (gutter.chart == 0) continue;
        step_list.push_back(packed(gutter.steps, gutter.at));
        chart_list.push_back(float(gutter.chart));
    }
    steps = make_list(std::move(step_list), gpu::Format::rgba32f, "skin.atlas.steps");
    charts = make_list(std::move(chart_list), gpu::Format::r32f, "skin.atlas.charts");
    taps = make_list(std::move(tap_list), gpu::Format::rgba32f, "skin.atlas.taps");
    weights = make_list(std::move(weight_list), gpu::Format::rgba32f, "skin.atlas.weights");
    gutter_charts = make_list(std::move(gutter_chart_list), gpu::Format::r32f, "skin.atlas.gutter_charts");
    if (!surface) return;
    places = make_list(std::move(place_list), gpu::Format::rgba32f, "skin.atlas.places");
    normals = make_list(std::move(normal_list), gpu::Format::rgba32f, "skin.atlas.normals");
}

gpu::Texture GpuAtlas::make_map(std::string_view label, gpu::Format format) const {
    gpu::Texture map({.format = format, .width = extent, .height = extent}, label);
    map.clear(0, glm::vec4(0.0f));
    return map;
}

void ChunkList::update(const GpuAtlas& atlas, const ChunkSet& set, bool gutters) {
    entries_ = unsigned(atlas.covered + (gutters ? atlas.gutters : 0));
    numbers_.clear();
    for (size_t i = 0; i < set.size(); ++i)
        if (set[i] != 0) numbers_.push_back(float(i));
    if (gutters)
        for (size_t i = size_t(atlas.covered) / kChunkTexels; i * kChunkTexels < entries_; ++i)
            numbers_.push_back(float(i));
    count_ = int(numbers_.size());
    const int rows = std::max(1, (count_ + kListColumns - 1) / kListColumns);
    if (list_.name() == 0 || list_.desc().height < rows)
        list_ = gpu::Texture({.format = gpu::Format::r32f, .width = kListColumns, .height = rows}, "skin.chunks");
    numbers_.resize(size_t(list_.desc().height) * kListColumns);
    list_.upload(0, 0, numbers_.data());
}

void ChunkList::dispatch(const gpu::Program& program) const {
    bind_list(program, "chunk_list", list_);
    program.set("list_size", entries_);
    dispatch_list(count_ * kChunkTexels);
}

void dispatch_list(int count) {
    if (count > 0) glDispatchCompute(GLuint((count + kChunkTexels - 1) / kChunkTexels), 1, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void bind_list(const gpu::Program& program, std::string_view name, const gpu::Texture& texture) {
    program.texture(name, texture, {.filter = gpu::Filter::nearest});
    program.image(name, texture, 0, true);
}

}  // namespace tyndall::skin
