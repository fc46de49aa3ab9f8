// One text, two languages: the driver's numbers against the compiler's.

#include <epoxy/gl.h>

#include "gpu/shader_library.h"
#include "gpu_fixture.h"
#include "physics_test.h"

#define FN inline
namespace tyndall::physics {
#include "physics_sweep.glsl"
}  // namespace tyndall::physics
#undef FN

namespace tyndall::physics {
namespace {

using PhysicsGpu = GpuTest;

TEST_F(PhysicsGpu, GivesTheNumbersOfCpp) {
    constexpr size_t kPoints = 4096;
    Random random(77);
    std::vector<vec4> inputs(kPoints);
    for (vec4& x : inputs) x = vec4(random.pair(), random.pair());
    std::vector<float> results(kPoints * kSweeps, -1e9f);
    {
        gpu::ShaderLibrary library;
        library.add_folder("tests", "tests/unit");
        const gpu::Program& program = library.program({.name = "physics sweep", .compute = "tests/physics_sweep.comp"});
        const gpu::Buffer in(std::span<const vec4>(inputs), "inputs"), out(std::span<const float>(results), "results");
        program.block("Inputs", in);
        program.block("Results", out);
        program.use();
        glDispatchCompute(kPoints / 64, 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        out.read(0, results.size() * sizeof(float), results.data());
    }
    for (int which = 0; which < kSweeps; ++which) {
        double worst = 0, scale = 0;
        for (const vec4& x : inputs) scale += std::abs(double(sweep(which, x))) / kPoints;
        int apart = 0;
        for (size_t i = 0; i < kPoints; ++i) {
            const double cpp = double(sweep(which, inputs[i]));
            const double gpu = double(results[i * kSweeps + size_t(which)]);
            ASSERT_TRUE(std::isfinite(gpu) && std::isfinite(cpp)) << which;
            const double error = std::abs(gpu - cpp) / (std::abs(cpp) + scale);
            if (error > 2e-4) ++apart;
            worst = std::max(worst, error);
        }
        // a ray that grazes a bound may fall to either side of it
        EXPECT_LE(apart, which == 11 || which == 12 ? 4 : 0) << "sweep " << which << ", worst " << worst;
        measured(("GPU against C++, sweep " + std::to_string(which) + ", worst relative").c_str(), worst);
    }
}

}  // namespace
}  // namespace tyndall::physics
