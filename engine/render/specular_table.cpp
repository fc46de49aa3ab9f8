#include "render/specular_table.h"

#include "physics/tables.h"

namespace tyndall {

void SpecularTableTexture::bind(const gpu::Program& program) {
    if (texture_.name() == 0) {
        constexpr int kSize = physics::SpecularTable::kSize;
        texture_ = gpu::Texture({.format = gpu::Format::rg32f, .width = kSize, .height = kSize}, "specular_table");
        texture_.upload(0, 0, physics::make_specular_table().texels.data());
    }
    program.texture("specular_table", texture_, {.filter = gpu::Filter::linear});
}

}  // namespace tyndall
