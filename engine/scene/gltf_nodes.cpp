#include "scene/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <optional>
#include <unordered_set>

#include "scene/gltf_values.h"

namespace tyndall {
namespace {

constexpr double kInfinity = GltfValues::kInfinity;

std::string pointer_of(int node) {
    return "/nodes/" + std::to_string(node);
}

/// Every node's parent, -1 for roots. Throws unless the nodes are trees.
std::vector<int> find_parents(const GltfFile& file) {
    const std::vector<tinygltf::Node>& nodes = file.model.nodes;
    std::vector<int> parents(nodes.size(), -1);
    for (size_t i = 0; i < nodes.size(); ++i)
        for (const int child : nodes[i].children) {
            (void)file.at(nodes, child, "node", pointer_of(static_cast<int>(i)) + "/children");
            int& parent = parents[static_cast<size_t>(child)];
            if (parent >= 0)
                file.fail(pointer_of(child),
                          "the node is a child of two nodes, " + std::to_string(parent) + " and " + std::to_string(i));
            parent = static_cast<int>(i);
        }
    return parents;
}

std::vector<int> roots_of(const GltfFile& file, const std::vector<int>& parents) {
    const tinygltf::Model& model = file.model;
    std::vector<int> roots;
    if (model.scenes.empty()) {
        for (size_t i = 0; i < parents.size(); ++i)
            if (parents[i] < 0) roots.push_back(static_cast<int>(i));
        return roots;
    }
    const int scene = std::max(model.defaultScene, 0);
    const std::string pointer = "/scenes/" + std::to_string(scene) + "/nodes";
    std::unordered_set<int> seen;
    for (const int root : file.at(model.scenes, scene, "scene", "/scene").nodes) {
        (void)file.at(model.nodes, root, "node", pointer);
        if (parents[static_cast<size_t>(root)] >= 0)
            file.fail(pointer, "node " + std::to_string(root) + " is a child of another one", "root nodes");
        if (seen.insert(root).second) roots.push_back(root);
    }
    return roots;
}

/// The trees below `roots`, parents first, in the file's order. With one parent for each node nothing comes twice.
std::vector<GltfPlace> walk(const GltfFile& file, const std::vector<int>& roots) {
    std::vector<GltfPlace> order;
    for (const int root : roots) order.push_back({root, -1});
    for (size_t i = 0; i < order.size(); ++i)
        for (const int child : file.model.nodes[static_cast<size_t>(order[i].node)].children)
            order.push_back({child, static_cast<int>(i)});
    return order;
}

/// Where walking from all roots does not reach, nodes go round in circles.
void refuse_cycles(const GltfFile& file, const std::vector<int>& parents) {
    std::vector<int> roots;
    for (size_t i = 0; i < parents.size(); ++i)
        if (parents[i] < 0) roots.push_back(static_cast<int>(i));
    std::vector<bool> reached(parents.size(), false);
    for (const GltfPlace& place : walk(file, roots)) reached[static_cast<size_t>(place.node)] = true;
    const auto lost = std::ranges::find(reached, false);
    if (lost != reached.end())
        file.fail(pointer_of(static_cast<int>(lost - reached.begin())), "the node is its own ancestor");
}

/// `count` finite numbers, or none when the file has none.
std::vector<float> numbers_of(const GltfFile& file, const std::vector<double>& values, size_t count,
                              const std::string& pointer) {
    std::vector<float> out;
    for (const double value : values) out.push_back(static_cast<float>(value));
    const bool finite = std::ranges::all_of(out, [](float value) { return std::isfinite(value); });
    if (!values.empty() && (values.size() != count || !finite))
        file.fail(pointer, "not a proper placement", std::to_string(count) + " finite numbers");
    return out;
}

glm::mat4 local_matrix(const GltfFile& file, const tinygltf::Node& node, const std::string& pointer) {
    const auto matrix = numbers_of(file, node.matrix, 16, pointer + "/matrix");
    const auto t = numbers_of(file, node.translation, 3, pointer + "/translation");
    const auto r = numbers_of(file, node.rotation, 4, pointer + "/rotation");
    const auto s = numbers_of(file, node.scale, 3, pointer + "/scale");
    glm::mat4 local(1.0f);
    if (!matrix.empty()) {
        for (size_t i = 0; i < 16; ++i) local[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = matrix[i];
        return local;
    }
    if (!t.empty()) local = glm::translate(local, {t[0], t[1], t[2]});
    if (!r.empty()) {
        const glm::quat turn(r[3], r[0], r[1], r[2]);
        const float length = glm::length(turn);
        if (!(length > 1e-6f) || !std::isfinite(length))
            file.fail(pointer + "/rotation", "not a rotation", "a unit quaternion");
        local *= glm::mat4_cast(turn / length);
    }
    if (!s.empty()) local = glm::scale(local, {s[0], s[1], s[2]});
    return local;
}

std::optional<Camera> read_camera(GltfFile& file, int index, const std::string& pointer) {
    const tinygltf::Camera& from = file.at(file.model.cameras, index, "camera", pointer);
    if (from.type != "perspective") {
        file.warn("orthographic cameras are ignored");
        return {};
    }
    const std::string here = "/cameras/" + std::to_string(index) + "/perspective";
    const auto yfov = static_cast<float>(from.perspective.yfov);
    const auto near = static_cast<float>(from.perspective.znear);
    if (!(yfov > 0.0f && yfov < std::numbers::pi_v<float>))
        file.fail(here + "/yfov", "not an angle of view", "0 to pi");
    if (!(near > 0.0f && std::isfinite(near))) file.fail(here + "/znear", "not a distance", "more than 0");
    Camera camera;
    camera.vertical_fov = yfov;
    camera.near_m = near;
    return camera;
}

LightKind kind_of(const GltfFile& file, const tinygltf::Light& light, const std::string& pointer) {
    if (light.type == "point") return LightKind::point;
    if (light.type == "spot") return LightKind::spot;
    if (light.type == "directional") return LightKind::directional;
    file.fail(pointer + "/type", "unknown kind of light '" + light.type + "'", "'point', 'spot' or 'directional'");
}

/// KHR_lights_punctual: candela and lux are our units too.
Light read_light(GltfFile& file, int index, const std::string& pointer, const glm::mat3& to_working) {
    const tinygltf::Light& from = file.at(file.model.lights, index, "light", pointer);
    const std::string here = "/extensions/KHR_lights_punctual/lights/" + std::to_string(index);
    GltfValues values(file, here);
    Light light;
    light.kind = kind_of(file, from, here);
    light.intensity = to_working * values.vector("color", from.color, glm::vec3(1.0f), 0, kInfinity) *
                      values.in_range("intensity", from.intensity, 0, kInfinity);
    light.range_m = values.in_range("range", from.range, 0, kInfinity);
    if (light.kind == LightKind::spot) {
        light.inner_angle = static_cast<float>(from.spot.innerConeAngle);
        light.outer_angle = static_cast<float>(from.spot.outerConeAngle);
        constexpr float kRight = std::numbers::pi_v<float> / 2.0f + 1e-6f;
        if (!(light.inner_angle >= 0.0f && light.inner_angle < light.outer_angle && light.outer_angle <= kRight))
            file.fail(here + "/spot", "the cone's angles are out of range", "0 <= inner < outer <= pi/2");
    }
    return light;
}

}  // namespace

std::vector<GltfPlace> order_nodes(const GltfFile& file) {
    const std::vector<int> parents = find_parents(file);
    refuse_cycles(file, parents);
    return walk(file, roots_of(file, parents));
}

GltfNode read_node(GltfFile& file, const GltfPlace& place, const glm::mat3& to_working) {
    const tinygltf::Node& from = file.model.nodes[static_cast<size_t>(place.node)];
    const std::string pointer = pointer_of(place.node);
    GltfNode node;
    node.name = from.name;
    node.parent = place.parent;
    node.local = local_matrix(file, from, pointer);
    if (from.camera >= 0) node.camera = read_camera(file, from.camera, pointer + "/camera");
    if (const auto* light = extension(from.extensions, "KHR_lights_punctual")) {
        const double index = number_or(member(*light, "light"), -1.0);
        node.light = read_light(file, index >= 0.0 && index < 1e9 ? static_cast<int>(index) : -1,
                                pointer + "/extensions/KHR_lights_punctual/light", to_working);
    }
    if (from.skin >= 0) file.warn("skins are ignored");
    return node;
}

}  // namespace tyndall
