#pragma once
/// The technique points: every point of the surface gathers, in every frame, from all the others.

#include <memory>
#include <vector>

#include "points/cloud_store.h"
#include "render/frame_graph.h"
#include "render/kept.h"
#include "render/light_programs.h"
#include "translucency_settings.h"
#include "translucent_surfaces.h"

namespace tyndall::translucency {

class PointsPass final : public Pass {
 public:
    PointsPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings);
    ~PointsPass() override;
    PointsPass(const PointsPass&) = delete;
    PointsPass& operator=(const PointsPass&) = delete;

    [[nodiscard]] std::string_view name() const override { return "translucency.points"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    struct Object {
        std::unique_ptr<GpuObject> gpu;
        const GpuCloud* cloud = nullptr;
        int levels = 0;
        bool balanced = false;
        bool directional = false;
    };

    [[nodiscard]] bool directional() const;
    void prepare(Object& object, const Surface& surface, const GpuCloud& cloud) const;
    /// How many points a surface is worth by its size on screen; infinite where that does not count.
    float points_for(PassContext& context, const Surface& surface);
    /// What part of them all surfaces get.
    float share_of_budget(PassContext& context, const std::vector<const Surface*>& seen);
    void render(PassContext& context, const Surface& surface, float share);
    void balance(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object);
    void light(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object);
    void sum(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object);
    void gather(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object);
    static void blend(PassContext& context, const GpuCloud& cloud, const GpuObject& object);
    void draw(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object);

    std::shared_ptr<TechniquePlan> plan_;
    const TranslucencySettings& settings_;
    CloudStore clouds_;
    KeptOfSurfaces<Object> objects_;
    LightPrograms light_programs_, directional_light_programs_;
    unsigned int vertex_array_ = 0;
};

}  // namespace tyndall::translucency
