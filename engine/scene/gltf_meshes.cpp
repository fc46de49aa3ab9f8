#include "scene/gltf_meshes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/error.h"
#include "core/parallel.h"
#include "scene/gltf_accessor.h"

namespace tyndall {
namespace {

/// The most vertices and indices of a file, all primitives together: a few bytes of a file may ask for any number.
constexpr size_t kMaxElements = 24'000'000;

/// The accessor of an attribute, or -1.
int attribute(const tinygltf::Primitive& primitive, const char* name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

/// Triangles from the corners of a list, strip or fan (glTF 2.0, section 3.7.2.1).
std::vector<uint32_t> as_triangles(std::vector<uint32_t> corners, int mode) {
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        corners.resize(corners.size() / 3 * 3);
        return corners;
    }
    std::vector<uint32_t> triangles;
    for (size_t i = 0; i + 2 < corners.size(); ++i)
        if (mode == TINYGLTF_MODE_TRIANGLE_STRIP)
            triangles.insert(triangles.end(), {corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
        else
            triangles.insert(triangles.end(), {corners[i + 1], corners[i + 2], corners[0]});
    return triangles;
}

bool usable(const glm::vec3& v) {
    const float length = glm::length(v);
    return std::isfinite(length) && length > 1e-12f;
}

void normalise(std::vector<glm::vec3>& normals) {
    for (glm::vec3& n : normals) n = usable(n) ? glm::normalize(n) : glm::vec3(0.0f, 1.0f, 0.0f);
}

/// Unit length and orthogonal to the normals; false when a tangent is of no use.
bool orthonormalise(std::vector<glm::vec4>& tangents, const std::vector<glm::vec3>& normals) {
    for (size_t i = 0; i < tangents.size(); ++i) {
        const glm::vec3 t(tangents[i]);
        const glm::vec3 on_plane = t - normals[i] * glm::dot(normals[i], t);
        if (!usable(on_plane)) return false;
        tangents[i] = glm::vec4(glm::normalize(on_plane), tangents[i].w < 0.0f ? -1.0f : 1.0f);
    }
    return true;
}

void make_finite(std::vector<glm::vec2>& uvs) {
    for (glm::vec2& uv : uvs)
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = glm::vec2(0.0f);
}

void warn_of_ignored(GltfFile& file, const tinygltf::Primitive& primitive) {
    if (!primitive.targets.empty()) file.warn("morph targets are ignored");
    for (const auto& [name, accessor] : primitive.attributes) {
        if (name.starts_with("COLOR_")) file.warn("vertex colours are ignored");
        if (name.starts_with("JOINTS_")) file.warn("skins are ignored");
        if (name.starts_with("TEXCOORD_") && name != "TEXCOORD_0" && name != "TEXCOORD_1")
            file.warn("UV sets beyond the second are ignored");
    }
}

}  // namespace

const std::vector<GltfMeshes::Primitive>& GltfMeshes::primitives(int index, std::string_view pointer) {
    const tinygltf::Mesh& mesh = file_.at(file_.model.meshes, index, "mesh", pointer);
    const auto [entry, is_new] = meshes_.try_emplace(index);
    if (!is_new) return entry->second;
    const std::string here = "/meshes/" + std::to_string(index);
    for (size_t i = 0; i < mesh.primitives.size(); ++i)
        add(mesh.primitives[i], here + "/primitives/" + std::to_string(i), entry->second,
            name_ + ": " + (mesh.name.empty() ? here : mesh.name));
    return entry->second;
}

void GltfMeshes::add(const tinygltf::Primitive& primitive, std::string pointer, std::vector<Primitive>& list,
                     const std::string& name) {
    if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
        file_.fail(pointer, "unknown mode " + std::to_string(primitive.mode), "0 to 6");
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES) return file_.warn("points and lines are ignored");
    const int positions = attribute(primitive, "POSITION");
    if (positions < 0) return file_.warn("primitives without positions are ignored");
    if (primitive.material != -1) (void)file_.at(file_.model.materials, primitive.material, "material", pointer);
    warn_of_ignored(file_, primitive);
    size_t count = file_.at(file_.model.accessors, positions, "accessor", pointer).count;
    if (primitive.indices >= 0) {
        const size_t indices = file_.at(file_.model.accessors, primitive.indices, "accessor", pointer).count;
        count = indices > kMaxElements ? indices : std::min(count, kMaxElements) + indices;
    }
    if (count > kMaxElements - elements_)
        file_.fail(pointer, "too many vertices and indices", std::to_string(kMaxElements) + " in all at most");
    elements_ += count;
    auto mesh = std::make_shared<MeshAsset>(MeshAsset{.id = new_asset_id(), .name = name});
    list.push_back({mesh, primitive.material});
    jobs_.push_back({&primitive, std::move(pointer), std::move(mesh)});
}

void GltfMeshes::read(const Job& job) const {
    const auto optional = [&]<class T>(std::vector<T>& out, const char* name, size_t count) {
        const int accessor = attribute(*job.primitive, name);
        if (accessor < 0) return;
        out = read_vectors<T>(file_, accessor, count, job.pointer + "/attributes/" + name);
        if (out.size() != count)
            file_.fail(job.pointer + "/attributes/" + name, std::to_string(out.size()) + " elements",
                       std::to_string(count) + ", one for each position");
    };
    Mesh& mesh = job.mesh->mesh;
    mesh.positions = read_vectors<glm::vec3>(file_, attribute(*job.primitive, "POSITION"), kMaxElements,
                                             job.pointer + "/attributes/POSITION");
    const size_t count = mesh.positions.size();
    optional(mesh.normals, "NORMAL", count);
    if (!mesh.normals.empty()) optional(mesh.tangents, "TANGENT", count);  // without normals they mean nothing
    optional(mesh.uv0, "TEXCOORD_0", count);
    optional(mesh.uv1, "TEXCOORD_1", count);
    std::vector<uint32_t> corners;
    if (job.primitive->indices >= 0) {
        corners = read_indices(file_, job.primitive->indices, kMaxElements, job.pointer + "/indices");
    } else {
        corners.resize(count);
        std::iota(corners.begin(), corners.end(), 0u);
    }
    mesh.indices = as_triangles(std::move(corners), job.primitive->mode);
    mesh.bounds = bounds_of(mesh.positions);
    validate(mesh, file_.path.string() + ": " + job.pointer);

    make_finite(mesh.uv0);
    make_finite(mesh.uv1);
    if (mesh.normals.empty()) compute_normals(mesh, 0.0f);  // flat, as glTF wants it
    normalise(mesh.normals);
    if (mesh.tangents.empty() || !orthonormalise(mesh.tangents, mesh.normals)) compute_tangents(mesh);
}

void GltfMeshes::load() {
    parallel_for(0, jobs_.size(), 1, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) read(jobs_[i]);
    });
    jobs_.clear();
}

}  // namespace tyndall
