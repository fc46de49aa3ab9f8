#pragma once
// A renderer with its own settings, and pictures out of it.

#include "color/color.h"
#include "gpu_fixture.h"
#include "image/image.h"
#include "render/image_settings.h"
#include "render/renderer.h"
#include "renderer_scenes.h"

namespace tyndall {

class RendererTest : public GpuTest {
 protected:
    void SetUp() override {
        GpuTest::SetUp();
        settings_ = std::make_unique<Settings>();
        renderer_ = std::make_unique<Renderer>(color_, *settings_);
    }
    void TearDown() override {
        EXPECT_EQ(renderer_->problems(), "");
        renderer_.reset();
        settings_.reset();
        GpuTest::TearDown();
    }

    /// A target after one frame, top row first.
    Image render(const RenderScene& scene, glm::ivec2 size = {320, 180}, std::string_view target = "radiance") {
        renderer_->retain({std::string(target)});
        renderer_->render(scene, size);
        const gpu::Texture* texture = renderer_->target(target);
        EXPECT_NE(texture, nullptr) << target;
        return texture != nullptr ? picture(*texture) : Image(size.x, size.y, 3, Image::Type::f32);
    }
    static Image picture(const gpu::Texture& texture) {
        const std::vector<glm::vec4> texels = texture.read();
        const int width = texture.desc().width;
        const int height = texture.desc().height;
        Image image(width, height, 3, Image::Type::f32);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < 3; ++c) image.at(x, y, c) = texels[size_t((height - 1 - y) * width + x)][c];
        return image;
    }
    static glm::vec3 centre(const Image& image) {
        const int x = image.width / 2;
        const int y = image.height / 2;
        return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
    }

    ColorConfig color_;
    std::unique_ptr<Settings> settings_;
    std::unique_ptr<Renderer> renderer_;
};

}  // namespace tyndall
