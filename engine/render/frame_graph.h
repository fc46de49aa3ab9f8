#pragma once
/// Passes say what they read and write; the graph orders them, owns their targets, and times them.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/gpu.h"

namespace tyndall {

/// The spine of a frame. It orders passes that update the same target; data orders all the rest.
enum class Stage {
    shadow,
    light_space,
    geometry,
    lighting,
    diffusion,
    compose,
    sky,
    media,
    transparent,
    post,
    display
};
[[nodiscard]] std::string_view name_of(Stage stage);

/// A render target that a pass creates.
struct TargetDesc {
    gpu::Format format = gpu::Format::rgba16f;
    gpu::Shape shape = gpu::Shape::flat;
    float scale = 1.0f;  ///< of the frame's size, rounded up; ignored when `size` is set
    glm::ivec2 size{0};  ///< absolute; 0 = by scale
    int layers = 1;
    int mips = 1;
    bool history = false;  ///< last frame's content can be read as "NAME@previous"; dropped on camera cut and resize
    std::optional<glm::vec4> clear;  ///< cleared to this before the writer runs (depth: x)
    /// The pass's own texture, which lives on between frames (caches): the graph orders the passes that use it, but
    /// neither makes nor clears nor shares it, and looks at nothing above. May return null before the pass first ran.
    std::function<const gpu::Texture*()> own;
};

/// Collects what a pass does, in Pass::declare.
class PassDeclaration {
 public:
    PassDeclaration& stage(Stage stage);
    /// Reads a target another pass writes; `optional` = fine when nobody does. "NAME@previous" reads history.
    PassDeclaration& reads(std::string target, std::string doc, bool optional = false);
    /// Creates a target. Exactly one pass creates a target.
    PassDeclaration& writes(std::string target, const TargetDesc& desc, std::string doc);
    /// Changes a target in place (blends, adds), after its creator and before its readers. Updaters of one target are
    /// ordered by stage; two in one stage need `after`.
    PassDeclaration& updates(std::string target, std::string doc);
    PassDeclaration& after(std::string pass);
    /// Runs even when nothing reads what it writes.
    PassDeclaration& keep();

    struct Access {
        enum class Kind { read, write, update } kind;
        std::string target;
        std::string doc;
        bool optional = false;
        bool previous = false;
        TargetDesc desc;
    };
    Stage stage_ = Stage::post;
    std::vector<Access> accesses_;
    std::vector<std::string> after_;
    bool keep_ = false;
};

class PassContext;

/// A node of the frame graph. Makes its GL objects when it first runs and gives them back in its destructor.
class Pass {
 public:
    virtual ~Pass() = default;
    /// Unique; a module's passes start with the module's name: "participating_media.march".
    [[nodiscard]] virtual std::string_view name() const = 0;
    /// Called when the graph is built: at the start, on resize, and when `FrameGraph::invalidate` was called.
    virtual void declare(PassDeclaration& declaration) = 0;
    /// Begins without blending, tests, culling and scissor; depth writes on, compare GREATER, clip depth 0..1.
    virtual void execute(PassContext& context) = 0;
};

/// What a pass sees while it runs.
class PassContext {
 public:
    virtual ~PassContext() = default;
    /// A declared target ("scene_depth", "radiance@previous").
    [[nodiscard]] virtual const gpu::Texture& texture(std::string_view target) const = 0;
    /// Null when an optional read has no writer, or history is missing.
    [[nodiscard]] virtual const gpu::Texture* find_texture(std::string_view target) const = 0;
    /// Binds a framebuffer of all flat targets this pass writes or updates, colours in declaration order, depth where
    /// there is one.
    virtual void bind_targets() = 0;
    /// Binds chosen targets of this pass: one layer of one mip of each (-1 = the flat image or all layers). A depth
    /// target that the pass only reads may be among them, for depth tests without writing.
    virtual void bind_targets(std::span<const std::string_view> targets, int layer, int mip = 0) = 0;
    /// The frame's size in pixels.
    [[nodiscard]] virtual glm::ivec2 size() const = 0;
    /// What the renderer made ready for this frame (render/frame.h).
    [[nodiscard]] virtual struct Frame& frame() = 0;
};

struct PassTime {
    std::string name;
    double milliseconds = 0.0;
};

/// Orders, allocates, aliases and runs passes. Does not own them.
class FrameGraph {
 public:
    FrameGraph();
    ~FrameGraph();

    /// Replaces the set of passes; rebuilt on the next execute.
    void set_passes(std::vector<Pass*> passes);
    /// Declarations have changed.
    void invalidate();

    /// Orders and allocates for this size. Throws Error naming the passes: a read that nobody writes, a cycle, two
    /// creators, two updaters without order, a second pass of the same name.
    void build(glm::ivec2 size);
    /// Runs all passes; builds first when needed. `camera_cut` drops history. Throws what build throws, once: the next
    /// call runs the last good plan, unless one of its passes is no longer in the set.
    void execute(Frame& frame, glm::ivec2 size, bool camera_cut);

    /// Passes that were left out since nothing reads what they write keep no place here.
    [[nodiscard]] std::vector<std::string> order() const;
    /// All targets of the frame, for `--view NAME`.
    [[nodiscard]] std::vector<std::string> targets() const;
    /// A target after execute; it must have been asked for with `retain`, or live to the end of the frame. Null when
    /// there is none.
    [[nodiscard]] const gpu::Texture* target(std::string_view name) const;
    /// Keeps a target from being aliased, so that it can be shown or saved after the frame. Empty = none; names that
    /// no pass writes are ignored (see `targets`).
    void retain(std::vector<std::string> targets);
    /// Times of the last frame, in order, when timing is on.
    void set_timing(bool on);
    [[nodiscard]] std::vector<PassTime> times();
    /// Bytes of all transient and history targets.
    [[nodiscard]] size_t memory() const;
    /// Graphviz text: passes, targets, sizes, aliases.
    [[nodiscard]] std::string dot() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall
