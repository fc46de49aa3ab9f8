#include "reference/media.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>

#include "core/parallel.h"
#include "reference/channels.h"

namespace tyndall::reference {

using glm::vec3;

MediumVolume::MediumVolume(vec3 scattering, vec3 absorption, vec3 glow, const PhaseFunction& function,
                           const DensityField& field, const glm::mat4& local_to_world, const Bounds& local,
                           double time_s, const AirOptions& options)
    : sigma_s(scattering * options.scatter_factor),
      sigma_a(absorption),
      sigma_t(scattering + absorption),
      emission(glow),
      phase(function),
      density_(field, local_to_world, time_s),
      to_local_(glm::inverse(local_to_world)),
      local_(local),
      emits_(largest(glow) > 0.0f || options.temperature),
      ellipsoid_(options.ellipsoid) {
    if (options.temperature) {
        temperature_.emplace(options.temperature->grid);
        base_k_ = options.temperature->base_k;
    }
    if (density_.constant()) return;
    cells_.resize(static_cast<size_t>(kCells) * kCells * kCells);
    const vec3 step = local.size() / static_cast<float>(kCells);
    parallel_for(0, kCells, 1, [&](size_t first, size_t last) {
        for (size_t z = first; z < last; ++z)
            for (int y = 0; y < kCells; ++y)
                for (int x = 0; x < kCells; ++x) {
                    const vec3 low = local.low + step * vec3(x, y, static_cast<float>(z));
                    Cell& cell = cells_[(z * kCells + static_cast<size_t>(y)) * kCells + static_cast<size_t>(x)];
                    // a little wider than the cell: rays enter and leave it with rounding
                    cell.most = density_.upper_bound({low - 1e-3f * step, low + 1.001f * step});
                    float sum = density_.at(low + 0.5f * step);
                    for (int corner = 0; corner < 8; ++corner)
                        sum +=
                            density_.at(low + step * (0.25f + 0.5f * vec3(corner & 1, (corner >> 1) & 1, corner >> 2)));
                    cell.mean = std::min(std::max(sum / 9.0f, 0.02f * cell.most), cell.most);
                }
    });
}

vec3 MediumVolume::emission_at(const vec3& world, float density) const {
    if (!temperature_) return emission * density;
    const float kelvin = base_k_ + temperature_->at(vec3(to_local_ * glm::vec4(world, 1.0f)));
    return density * (emission + sigma_a * physics::black_body_radiance(kelvin));
}

bool MediumVolume::clip(const Ray& ray, float& t0, float& t1) const {
    const vec3 origin(to_local_ * glm::vec4(ray.origin, 1.0f));
    const vec3 direction = glm::mat3(to_local_) * ray.direction;
    if (!physics::clip_to_box(origin, direction, local_.low, local_.high, t0, t1)) return false;
    return !ellipsoid_ || physics::clip_to_unit_ball(origin, direction, t0, t1);
}

vec3 MediumPoint::scattering(float u) const {
    vec3 sum(0.0f);
    for (size_t i = 0; i < count; ++i)
        sum += parts[i].medium->sigma_s * (parts[i].density * parts[i].medium->phase.evaluate(u));
    return sum;
}

float MediumPoint::pdf(float u) const {
    float sum = 0.0f, weights = 0.0f;
    for (size_t i = 0; i < count; ++i) {
        const float weight = mean_of(parts[i].medium->sigma_s) * parts[i].density;
        sum += weight * parts[i].medium->phase.pdf(u);
        weights += weight;
    }
    return weights > 0.0f ? sum / weights : 0.0f;
}

float MediumPoint::sample(Sampler& sampler, vec3& scattering_over_pdf) const {
    float weights = 0.0f;
    for (size_t i = 0; i < count; ++i) weights += mean_of(parts[i].medium->sigma_s) * parts[i].density;
    float choice = count > 1 ? sampler.next() * weights : 0.0f;
    size_t chosen = 0;
    for (; chosen + 1 < count; ++chosen) {
        choice -= mean_of(parts[chosen].medium->sigma_s) * parts[chosen].density;
        if (choice < 0.0f) break;
    }
    const MediumVolume& medium = *parts[chosen].medium;
    const float share = mean_of(medium.sigma_s) * parts[chosen].density / weights;
    const float u = medium.phase.sample(sampler.next2());
    scattering_over_pdf = medium.sigma_s * (parts[chosen].density / share);
    const float pdf = medium.phase.pdf(u);
    if (pdf > 0.0f) scattering_over_pdf *= medium.phase.evaluate(u) / pdf;
    return u;
}

void MediaRay::add(const MediumVolume& medium, float end) {
    Span span{&medium, 0.0f, end};
    if (count_ == MediumPoint::kMost || !medium.clip(ray_, span.t0, span.t1) || !(span.t0 < span.t1)) return;
    if (!medium.homogeneous()) {
        const vec3 scale = vec3(MediumVolume::kCells) / medium.local_.size();
        span.origin = (vec3(medium.to_local_ * glm::vec4(ray_.origin, 1.0f)) - medium.local_.low) * scale;
        span.direction = glm::mat3(medium.to_local_) * ray_.direction * scale;
    }
    spans_[count_++] = span;
}

bool MediaRay::emits() const {
    return std::any_of(spans_, spans_ + count_, [](const Span& span) { return span.medium->emits(); });
}

void MediaRay::extent(float& t0, float& t1) const {
    t0 = std::numeric_limits<float>::infinity(), t1 = 0.0f;
    for (size_t i = 0; i < count_; ++i) {
        t0 = std::min(t0, spans_[i].t0);
        t1 = std::max(t1, spans_[i].t1);
    }
}

void MediaRay::enter(const Span& span, float t, Steps& steps) {
    const vec3 start = span.origin + span.direction * t;
    constexpr int kStride[3] = {1, MediumVolume::kCells, MediumVolume::kCells * MediumVolume::kCells};
    steps.at = 0;
    for (int a = 0; a < 3; ++a) {
        const int index = std::clamp(static_cast<int>(start[a]), 0, MediumVolume::kCells - 1);
        const float d = span.direction[a];
        steps.at += index * kStride[a];
        steps.stride[a] = d > 0.0f ? kStride[a] : -kStride[a];
        steps.left[a] = d > 0.0f ? MediumVolume::kCells - 1 - index : index;
        steps.delta[a] = d != 0.0f ? 1.0f / std::abs(d) : std::numeric_limits<float>::infinity();
        const float face = static_cast<float>(d > 0.0f ? index + 1 : index);
        steps.next[a] = d != 0.0f ? std::max((face - span.origin[a]) / d, t) : std::numeric_limits<float>::infinity();
    }
    steps.cell = span.medium->cells_[static_cast<size_t>(steps.at)];
    steps.until = std::min(std::min(steps.next[0], steps.next[1]), std::min(steps.next[2], span.t1));
}

void MediaRay::advance(const Span& span, float t, Steps& steps) {
    if (t < span.t0 || t >= span.t1) {
        steps.cell = {};
        steps.until = t < span.t0 ? span.t0 : std::numeric_limits<float>::infinity();
        return;
    }
    if (span.medium->homogeneous()) {
        steps.cell = {1.0f, 1.0f};
        steps.until = span.t1;
        return;
    }
    if (steps.at < 0) return enter(span, t, steps);
    const int axis = steps.next[0] <= steps.next[1] ? (steps.next[0] <= steps.next[2] ? 0 : 2)
                                                    : (steps.next[1] <= steps.next[2] ? 1 : 2);
    steps.next[axis] += steps.delta[axis];
    if (steps.left[axis]-- > 0) steps.at += steps.stride[axis];  // at the grid's end rounding may ask for one more
    steps.cell = span.medium->cells_[static_cast<size_t>(steps.at)];
    steps.until = std::min(std::min(steps.next[0], steps.next[1]), std::min(steps.next[2], span.t1));
}

template <class F>
void MediaRay::walk(float end, F visit) const {
    std::array<Steps, MediumPoint::kMost> steps;
    float low = 0.0f, high = 0.0f;
    extent(low, high);
    end = std::min(end, high);
    for (size_t i = 0; i < count_; ++i) {
        steps[i].at = -1;
        steps[i].until = low;
    }
    for (float t = low; t < end;) {
        float next = end, most = 0.0f;
        for (size_t i = 0; i < count_; ++i) {
            if (steps[i].until <= t) advance(spans_[i], t, steps[i]);
            next = std::min(next, steps[i].until);
            most += steps[i].cell.most;
        }
        if (next > t && most > 0.0f && !visit(t, next, steps)) return;
        t = next;
    }
}

vec3 MediaRay::transmittance(float end, Sampler& sampler) const {
    vec3 depth(0.0f), ratio(1.0f);
    walk(end, [&](float from, float to, const auto& steps) {
        vec3 control(0.0f);
        float rate = 0.0f;  // of residual tracking: above every |sigma - control|
        for (size_t i = 0; i < count_; ++i) {
            const MediumVolume& medium = *spans_[i].medium;
            control += medium.sigma_t * steps[i].cell.mean;
            if (!medium.homogeneous())
                rate += largest(medium.sigma_t) * std::max(steps[i].cell.most - steps[i].cell.mean, steps[i].cell.mean);
        }
        depth += control * (to - from);
        // Novak et al., "Residual Ratio Tracking for Estimating Attenuation in Participating Media", 2014
        for (float t = from; rate > 0.0f;) {
            t -= std::log(1.0f - sampler.next_independent()) / rate;
            if (t >= to) break;
            vec3 sigma(0.0f);
            for (size_t i = 0; i < count_; ++i)
                if (steps[i].cell.most > 0.0f)
                    sigma += spans_[i].medium->sigma_t * spans_[i].medium->density(ray_.origin + ray_.direction * t);
            ratio *= vec3(1.0f) - (sigma - control) / rate;
        }
        return true;
    });
    return glm::exp(-depth) * ratio;
}

float MediaRay::Stretch::mass() const {
    return transmittance * -std::expm1(-sigma * length());
}

float MediaRay::Stretch::place_of(float lost) const {
    return std::min(from - std::log1p(-std::min(lost / transmittance, 0.9999999f)) / sigma, to);
}

void MediaRay::stretches(float begin, float end, std::vector<Stretch>& out) const {
    out.clear();
    float depth = 0.0f;
    walk(end, [&](float from, float to, const auto& steps) {
        float sigma = 0.0f, scattering = 0.0f;
        for (size_t i = 0; i < count_; ++i) {
            sigma += mean_of(spans_[i].medium->sigma_t) * steps[i].cell.mean;
            scattering += mean_of(spans_[i].medium->sigma_s) * steps[i].cell.mean;
        }
        const float low = std::max(from, begin);
        if (low < to && scattering > 0.0f) out.push_back({low, to, sigma, std::exp(-depth - sigma * (low - from))});
        depth += sigma * (to - from);
        return true;
    });
}

MediumPoint MediaRay::at(float t) const {
    MediumPoint point;
    const vec3 place = ray_.origin + ray_.direction * t;
    for (size_t i = 0; i < count_; ++i) {
        const Span& span = spans_[i];
        if (t < span.t0 || t > span.t1) continue;
        const float density = span.medium->density(place);
        if (density <= 0.0f) continue;
        point.parts[point.count++] = {span.medium, density};
        point.sigma_s += span.medium->sigma_s * density;
        point.sigma_t += span.medium->sigma_t * density;
        if (span.medium->emits()) point.emission += span.medium->emission_at(place, density);
    }
    return point;
}

bool MediaRay::fly(float end, int hero, Sampler& sampler, vec3& f, vec3& ratio, float& t, MediumPoint& point,
                   vec3& glow) const {
    bool collided = false;
    walk(end, [&](float from, float to, const auto& steps) {
        vec3 most(0.0f);
        for (size_t i = 0; i < count_; ++i) {
            most += spans_[i].medium->sigma_t * steps[i].cell.most;
            // what glows without dimming still needs places to glow at
            if (spans_[i].medium->emits() && steps[i].cell.most > 0.0f) most += 1.0f / (spans_[i].t1 - spans_[i].t0);
        }
        for (t = from;;) {
            const float free = most[hero] > 0.0f ? -std::log(1.0f - sampler.next()) / most[hero] : to - from;
            if (t + free >= to) {
                const vec3 passed = glm::exp(-(most - vec3(most[hero])) * (to - t));
                f *= passed;
                ratio *= passed;
                return true;
            }
            t += free;
            point = at(t);
            const vec3 passed = glm::exp(-(most - vec3(most[hero])) * free);  // over the hero's
            f *= passed / most[hero];
            ratio *= passed / most[hero];
            glow += f * point.emission / mean_of(ratio * most);
            const float real = point.sigma_t[hero] / most[hero];
            if (sampler.next() < real) {
                f /= real;
                ratio *= point.sigma_t / real;
                collided = true;
                return false;
            }
            const vec3 null = glm::max(most - point.sigma_t, vec3(0.0f)) / (1.0f - real);
            f *= null;
            ratio *= null;
        }
    });
    return collided;
}

}  // namespace tyndall::reference
