#pragma once
/// What a trace has gathered: exact sums that can be added, kept in a file, and gone on with.
///
/// Sums are fixed-point integers, so their order does not matter: shards, threads and interruptions leave the same
/// bits. A sample is quantised to 2^-40, its square to 2^-60, of the film's unit.

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <set>
#include <string>
#include <vector>

#include "core/function_ref.h"
#include "image/image.h"

namespace tyndall::reference {

/// Parts of the radiance: seen emission, light that a surface scattered once, that a medium scattered once, the rest.
enum class Component { emission, surface, medium, multiple };

/// A 128-bit sum.
__extension__ using WideSum = __int128;

/// See the file's head. A "batch" is a pixel's mean over `batch` samples that share a low-discrepancy sequence; batches
/// are independent of each other, so the variance of the mean follows from their squares.
class Film {
 public:
    Film() = default;
    /// `recipe` is what made it, as JSON: films of different recipes do not add. `unit` is radiance (cd/m2).
    Film(glm::ivec2 size, int batch, float unit, std::string recipe, bool components);

    [[nodiscard]] glm::ivec2 size() const { return size_; }
    [[nodiscard]] const std::string& recipe() const { return recipe_; }
    /// Samples of a batch.
    [[nodiscard]] int batch() const { return batch_; }
    /// Batches that every pixel has.
    [[nodiscard]] int64_t batches() const { return static_cast<int64_t>(done_.size()); }
    [[nodiscard]] int64_t samples() const { return batches() * batch_; }
    [[nodiscard]] bool has(int64_t batch) const { return done_.contains(batch); }
    [[nodiscard]] bool has_components() const { return !components_.empty(); }

    /// One pixel's means over a batch.
    struct PixelBatch {
        glm::vec3 radiance{0.0f};
        glm::vec3 albedo{0.0f};                                 ///< of what is first seen, 0..1
        glm::vec3 normal{0.0f};                                 ///< in the world
        glm::vec3 emission{0.0f}, surface{0.0f}, medium{0.0f};  ///< components; the rest of the radiance is multiple
    };
    /// For each pixel, then once `finish_batch`.
    void add(glm::ivec2 pixel, const PixelBatch& means);
    void finish_batch(int64_t batch);
    /// Adds another film's batches. Throws Error when recipes or sizes differ or a batch is in both.
    void merge(const Film& other);

    /// Scene-linear means over all samples, three channels, f32.
    [[nodiscard]] Image radiance() const;
    /// Variance of those means per pixel and channel; infinite with less than two batches.
    [[nodiscard]] Image variance() const;
    [[nodiscard]] Image albedo() const;
    [[nodiscard]] Image normal() const;
    /// Only when has_components().
    [[nodiscard]] Image component(Component which) const;
    /// Root of the mean variance over the mean, of luminance.
    [[nodiscard]] double noise() const;

    /// Writes an EXR: R G B, variance.RGB, samples, albedo.RGB, normal.XYZ, components, and the sums as integer
    /// channels `sum.*`, from which the film is read back exactly. Throws Error (disk full, no such folder); a file
    /// that was there stays whole then.
    void save(const std::filesystem::path& file) const;
    /// Throws Error for a file that is not such a film, is damaged, or has no sums.
    [[nodiscard]] static Film load(const std::filesystem::path& file);

 private:
    struct Pixel {
        WideSum radiance[3] = {}, squares[3] = {};
        int64_t albedo[3] = {}, normal[3] = {};
    };
    struct Components {
        WideSum emission[3] = {}, surface[3] = {}, medium[3] = {};
    };
    [[nodiscard]] Image mean_of(FunctionRef<double(size_t pixel, int channel)> sum) const;
    [[nodiscard]] double variance_at(size_t pixel, int channel) const;

    [[nodiscard]] uint64_t sum_checksum() const;
    glm::ivec2 size_{0};
    int batch_ = 1;
    float unit_ = 1.0f;
    std::string recipe_;
    std::set<int64_t> done_;
    std::vector<Pixel> pixels_;
    std::vector<Components> components_;
};

}  // namespace tyndall::reference
