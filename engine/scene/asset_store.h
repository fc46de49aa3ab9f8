#pragma once
/// Meshes, textures, volumes, materials and glTF files by name, loaded once, shared, reloaded when they change on disk.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/particles.h"
#include "scene/render_scene.h"
#include "scene/volume_sequence.h"

namespace tyndall {

class ColorConfig;

/// What a texture is for decides its colour space and sampler defaults.
enum class TextureUse { colour, data, probe };

/// One node of an imported file: placement, and what hangs on it.
struct GltfNode {
    std::string name;
    int parent = -1;
    glm::mat4 local{1.0f};
    struct Primitive {
        std::shared_ptr<const MeshAsset> mesh;
        std::shared_ptr<const Material> material;
    };
    std::vector<Primitive> primitives;
    std::optional<Camera> camera;  ///< transform is the node's
    std::optional<Light> light;    ///< transform is the node's
};

/// A glTF 2.0 file as the engine keeps it. Nodes come parents first.
struct GltfAsset {
    uint64_t id = 0;
    std::string name;
    std::vector<GltfNode> nodes;
    std::vector<std::string> warnings;  ///< what the file has and the engine ignores
};

/// Loads and shares assets. Names are relative to the scene's folder, or to the project's assets/ with "assets:NAME".
/// A name that leaves those folders is refused. Every load error is an Error that names the file.
class AssetStore {
 public:
    /// `config` must outlive the store.
    AssetStore(const ColorConfig& config, std::filesystem::path base);
    ~AssetStore();
    void set_base(std::filesystem::path base);
    [[nodiscard]] std::filesystem::path resolve(std::string_view name) const;

    [[nodiscard]] std::shared_ptr<const MeshAsset> mesh(std::string_view name);
    [[nodiscard]] std::shared_ptr<const TextureAsset> texture(std::string_view name, TextureUse use);
    [[nodiscard]] std::shared_ptr<const GltfAsset> gltf(std::string_view name);
    /// `grid` of an OpenVDB file; empty for kDefaultGrid, and for files without grids (image/volume.h).
    [[nodiscard]] std::shared_ptr<const VolumeAsset> volume(std::string_view name, const GridChoice& grid);
    /// A phase function's table (scene/phase_table.h).
    [[nodiscard]] std::shared_ptr<const PhaseTable> phase_table(std::string_view name);

    /// Soft spheres from a file (scene/particles.h).
    [[nodiscard]] std::shared_ptr<const ParticleAsset> particles(std::string_view name);

    /// Where the inside of a closed mesh is: 1 inside, 0 outside (scene/mesh_mask.h), `resolution` voxels along the
    /// longest edge; made once. Throws Error, naming the mesh, when it is not closed.
    [[nodiscard]] std::shared_ptr<const VolumeAsset> mesh_mask(const MeshAsset& mesh, int resolution);
    /// The density of soft spheres, likewise.
    [[nodiscard]] std::shared_ptr<const VolumeAsset> particle_mask(std::span<const Particle> particles, int resolution);

    /// The frame with this index of a sequence (scene/volume_sequence.h), and loads the next ones in the background.
    /// While streaming, the last frame that was there instead of one that is still being read or is broken (which is
    /// logged), and null before any is there; otherwise waits for it, and throws Error when it cannot be loaded.
    [[nodiscard]] std::shared_ptr<const VolumeAsset> sequence_frame(const VolumeSequence& sequence, int index);
    /// Off at first: every picture shows the frame of its own time, whatever the wait. Games turn it on.
    void set_streaming(bool on);

    /// Reloads what changed on disk since it was loaded; a broken file keeps the last good one and logs. True when
    /// something changed.
    bool reload_changed();
    /// Frees what nobody but the store holds.
    void collect();
    /// The files that everything in the store was read from, each once, sorted.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall
