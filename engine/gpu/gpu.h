#pragma once
/// OpenGL 4.5 behind RAII and direct state access. Every object is made and destroyed with the context current.
///
/// GL's binding points are never managed by hand: a Program's samplers, images and buffer blocks are bound by name.

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tyndall::gpu {

/// What of GL is alive: for `tyndall info` and for tests that nothing leaks.
struct Alive {
    size_t texture_bytes = 0;  ///< texels of all mips and layers; drivers add padding
    size_t buffer_bytes = 0;
    int textures = 0;
    int buffers = 0;
    int framebuffers = 0;
    int programs = 0;
    bool operator==(const Alive&) const = default;
};
[[nodiscard]] Alive alive();

/// Texel formats. Channels in name order; `f` float, `ui` unsigned integer, otherwise unsigned normalised.
enum class Format {
    r8,
    rg8,
    rgba8,
    srgb8_alpha8,
    r16,
    rg16,
    rgba16,
    r16f,
    rg16f,
    rgba16f,
    r32f,
    rg32f,
    rgba32f,
    r11g11b10f,
    r32ui,
    rgb10_a2,
    depth32f
};
[[nodiscard]] size_t bytes_per_texel(Format format);
[[nodiscard]] std::string_view name_of(Format format);
[[nodiscard]] bool is_depth(Format format);

/// A name for a GL object that owns it; movable.
class Handle {
 public:
    Handle() = default;
    explicit Handle(unsigned int name) : name_(name) {}
    Handle(Handle&& other) noexcept : name_(other.name_) { other.name_ = 0; }
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    [[nodiscard]] unsigned int name() const { return name_; }

 protected:
    unsigned int name_ = 0;
};

/// A block of GPU memory: vertices, indices, uniform or storage block.
class Buffer : public Handle {
 public:
    Buffer() = default;
    /// Immutable size; `data` may be null. `label` shows in GL debuggers and messages.
    Buffer(size_t bytes, const void* data, std::string_view label);
    template <class T>
    Buffer(std::span<const T> data, std::string_view label) : Buffer(data.size_bytes(), data.data(), label) {}
    ~Buffer();
    Buffer(Buffer&&) noexcept = default;
    Buffer& operator=(Buffer&& other) noexcept {
        std::swap(name_, other.name_);
        std::swap(size_, other.size_);
        return *this;
    }
    /// In bytes.
    [[nodiscard]] size_t size() const { return size_; }
    /// Replaces a part; it must lie inside.
    void update(size_t offset, size_t bytes, const void* data);
    /// Copies a part back, waiting for the GPU.
    void read(size_t offset, size_t bytes, void* data) const;

 private:
    size_t size_ = 0;
};

enum class Shape { flat, array, volume, cube, cube_array };

struct TextureDesc {
    Shape shape = Shape::flat;
    Format format = Format::rgba8;
    int width = 1;
    int height = 1;
    int layers = 1;  ///< array layers, volume depth, or cubes (not faces)
    int mips = 1;    ///< 0 = the full chain
    bool operator==(const TextureDesc&) const = default;
};

/// Texels on the GPU, of immutable size and format; contents are undefined until written.
class Texture : public Handle {
 public:
    Texture() = default;
    /// Throws Error when the size is not positive or beyond what the driver offers.
    Texture(const TextureDesc& desc, std::string_view label);
    ~Texture();
    Texture(Texture&&) noexcept = default;
    Texture& operator=(Texture&& other) noexcept {
        std::swap(name_, other.name_);
        std::swap(desc_, other.desc_);
        return *this;
    }
    /// As asked for, with `mips` resolved.
    [[nodiscard]] const TextureDesc& desc() const { return desc_; }
    /// One whole layer (face, slice) of one mip, tightly packed texels of `format()`; 8/16/32 bits a channel as the
    /// format has.
    void upload(int mip, int layer, const void* texels);
    /// The same into a format with four channels from texels of three; alpha becomes 1.
    void upload_rgb(int mip, int layer, const void* texels);
    void generate_mips();
    /// Every texel of one mip; depth and integer formats take `value.x`.
    void clear(int mip, glm::vec4 value);
    /// Reads one layer of one mip back as 4 floats a texel (missing channels 0, alpha 1; depth and integers in x; sRGB
    /// as stored, not decoded), bottom row first. Waits for the GPU.
    [[nodiscard]] std::vector<glm::vec4> read(int mip = 0, int layer = 0) const;

 private:
    void upload_as(int mip, int layer, unsigned int channels, const void* texels);
    TextureDesc desc_;
};

enum class Filter { nearest, linear, trilinear };
enum class Wrap { repeat, mirror, clamp, border_zero };
struct SamplerDesc {
    Filter filter = Filter::linear;
    Wrap wrap_u = Wrap::clamp;
    Wrap wrap_v = Wrap::clamp;
    bool compare = false;  ///< shadow lookups: passes where the reference is >= the stored (reversed-Z) depth
    float anisotropy = 1.0f;
    bool operator==(const SamplerDesc&) const = default;
};
/// The shared sampler object of that description; lives until release_samplers().
[[nodiscard]] unsigned int sampler(const SamplerDesc& desc);
/// Deletes the shared samplers and draw_fullscreen's vertex array; they come back when needed. A ShaderLibrary does it
/// when it goes; without one, call it before the context goes.
void release_samplers();

/// A linked program. Setting a uniform that the program does not have is silently allowed: optimisers remove them.
///
/// Uniforms keep their values between draws until the program is rebuilt (reload), so set all of them each frame;
/// textures, images and blocks are bound at once, for the next draw or dispatch, before or after use(). Units and
/// bindings are assigned here, in the linker's order: a `layout(binding = N)` in the shader is ignored. Elements of
/// arrays are named as in GLSL ("maps[2]"; "maps" is the first).
class Program : public Handle {
 public:
    Program() = default;
    /// Takes over a linked GL program. Throws Error when it uses more units than the driver has.
    explicit Program(unsigned int linked);
    ~Program();
    Program(Program&&) noexcept = default;
    Program& operator=(Program&& other) noexcept {
        std::swap(name_, other.name_);
        std::swap(slots_, other.slots_);
        return *this;
    }

    void use() const;
    void set(std::string_view uniform, int value) const;
    void set(std::string_view uniform, unsigned int value) const;
    void set(std::string_view uniform, float value) const;
    void set(std::string_view uniform, glm::ivec2 value) const;
    void set(std::string_view uniform, glm::ivec3 value) const;
    void set(std::string_view uniform, glm::vec2 value) const;
    void set(std::string_view uniform, glm::vec3 value) const;
    void set(std::string_view uniform, glm::vec4 value) const;
    void set(std::string_view uniform, const glm::mat3& value) const;
    void set(std::string_view uniform, const glm::mat4& value) const;
    /// Binds to the unit that the program's sampler of this name was given at link time.
    void texture(std::string_view name, const Texture& texture, const SamplerDesc& sampler = {}) const;
    /// The same for a sampler object of GL's own names (OpenColorIO's LUTs).
    void texture(std::string_view name, unsigned int texture, unsigned int sampler) const;
    /// An image unit for load/store of one mip, all layers.
    void image(std::string_view name, const Texture& texture, int mip, bool write) const;
    /// A uniform or storage block.
    void block(std::string_view name, const Buffer& buffer) const;
    void block(std::string_view name, const Buffer& buffer, size_t offset, size_t bytes) const;
    [[nodiscard]] bool has(std::string_view uniform) const;

 private:
    struct Slot {
        std::string name;
        int location = -1;
        int unit = -1;  ///< texture unit, image unit or block binding
        enum class Kind { value, sampler, image, uniform_block, storage_block } kind = Kind::value;
    };
    void reflect_uniforms();
    void reflect_blocks(unsigned int interface, Slot::Kind kind);
    [[nodiscard]] const Slot* find(std::string_view name, Slot::Kind kind) const;
    [[nodiscard]] int location(std::string_view name) const;
    std::vector<Slot> slots_;  // sorted by name
};

/// Colour and depth targets of a draw. Attachments must outlive it.
class Framebuffer : public Handle {
 public:
    struct Attachment {
        const Texture* texture = nullptr;
        int mip = 0;
        int layer = -1;  ///< -1 = all layers (layered rendering) or the flat image
    };
    Framebuffer() = default;
    /// At least one attachment; all of one size. Throws Error when the driver refuses the combination.
    Framebuffer(std::span<const Attachment> colours, const Attachment& depth, std::string_view label);
    ~Framebuffer();
    Framebuffer(Framebuffer&&) noexcept = default;
    Framebuffer& operator=(Framebuffer&& other) noexcept {
        std::swap(name_, other.name_);
        std::swap(size_, other.size_);
        return *this;
    }
    /// Binds it and sets the viewport to the attachments' size.
    void bind() const;
    /// Colour attachment `index`; write masks and scissor apply.
    void clear_colour(int index, glm::vec4 value) const;
    /// Reversed-Z: 0 is far away. The depth write mask applies.
    void clear_depth(float value = 0.0f) const;
    [[nodiscard]] glm::ivec2 size() const { return size_; }

 private:
    glm::ivec2 size_{0};
};

/// Whether shaders run on the processor (llvmpipe and its like): what is fast there is not what is fast on a GPU.
[[nodiscard]] bool shades_on_processor();

/// Time between begin and end, in milliseconds: timer queries on a GPU (a few frames late, without a stall), glFinish
/// and the CPU clock on software renderers, whose timer queries lie (docs/performance.md). Timers may nest.
class Timer {
 public:
    Timer() = default;
    ~Timer();
    Timer(Timer&& other) noexcept { *this = std::move(other); }
    Timer& operator=(Timer&& other) noexcept;
    void begin();
    void end();
    /// The newest finished measurement, or a negative number. Never waits.
    [[nodiscard]] double milliseconds();
    /// "GL timer queries" or "glFinish and CPU clock".
    [[nodiscard]] static std::string_view method();

 private:
    void collect();
    std::vector<unsigned int> queries_;  // a ring of begin and end time stamps
    size_t begun_ = 0;                   // measurements since the start ...
    size_t read_ = 0;                    // ... and how many of them were read back
    bool running_ = false;               // false when the ring was full at begin()
    double start_ = 0.0;
    double last_ = -1.0;
};

/// A triangle that covers the target, without vertex buffers: vertex shader "gpu/shaders/fullscreen.vert" gives `vec2
/// uv`.
void draw_fullscreen();

/// Waits until the GPU has done all that it was asked for. For benchmarks.
void finish();

}  // namespace tyndall::gpu
