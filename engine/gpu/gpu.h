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
#include <vector>

namespace tyndall::gpu {

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
    Buffer& operator=(Buffer&&) noexcept = default;
    [[nodiscard]] size_t size() const { return size_; }
    void update(size_t offset, size_t bytes, const void* data);

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

class Texture : public Handle {
 public:
    Texture() = default;
    Texture(const TextureDesc& desc, std::string_view label);
    ~Texture();
    Texture(Texture&&) noexcept = default;
    Texture& operator=(Texture&&) noexcept = default;
    [[nodiscard]] const TextureDesc& desc() const { return desc_; }
    /// One whole layer (face, slice) of one mip, tightly packed texels of `format()`; 8/16/32 bits a channel as the
    /// format has.
    void upload(int mip, int layer, const void* texels);
    void generate_mips();
    /// Reads one layer of one mip back as 4 floats a texel (missing channels 0, alpha 1; depth in x), bottom row first.
    [[nodiscard]] std::vector<glm::vec4> read(int mip = 0, int layer = 0) const;

 private:
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
/// The shared sampler object of that description; lives as long as the context's library.
[[nodiscard]] unsigned int sampler(const SamplerDesc& desc);
/// Deletes the shared samplers; called by the platform before the context goes.
void release_samplers();

/// A linked program. Setting a uniform that the program does not have is silently allowed: optimisers remove them.
class Program : public Handle {
 public:
    Program() = default;
    explicit Program(unsigned int linked);
    ~Program();
    Program(Program&&) noexcept = default;
    Program& operator=(Program&&) noexcept = default;

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
    [[nodiscard]] const Slot* find(std::string_view name) const;
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
    Framebuffer(std::span<const Attachment> colours, const Attachment& depth, std::string_view label);
    ~Framebuffer();
    Framebuffer(Framebuffer&&) noexcept = default;
    Framebuffer& operator=(Framebuffer&&) noexcept = default;
    /// Binds it and sets the viewport to the attachments' size.
    void bind() const;
    [[nodiscard]] glm::ivec2 size() const { return size_; }

 private:
    glm::ivec2 size_{0};
};

/// Time between begin and end, in milliseconds: timer queries on a GPU (a few frames late, without a stall), glFinish
/// and the CPU clock on llvmpipe, whose timer queries lie (docs/performance.md).
class Timer {
 public:
    Timer() = default;
    ~Timer();
    Timer(Timer&&) noexcept = default;
    Timer& operator=(Timer&&) noexcept = default;
    void begin();
    void end();
    /// The newest finished measurement, or a negative number.
    [[nodiscard]] double milliseconds();
    /// "GL timer queries" or "glFinish and CPU clock".
    [[nodiscard]] static std::string_view method();

 private:
    std::vector<unsigned int> queries_;
    size_t next_ = 0;
    double start_ = 0.0;
    double last_ = -1.0;
};

/// A triangle that covers the target, without vertex buffers: vertex shader "gpu/fullscreen.vert" gives `vec2 uv`.
void draw_fullscreen();

}  // namespace tyndall::gpu
