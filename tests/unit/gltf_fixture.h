#pragma once
#include <fstream>

#include "color/color.h"
#include "core/error.h"
#include "core/log.h"
#include "core/paths.h"
#include "gltf_writer.h"
#include "image/image_io.h"
#include "scene/asset_store.h"
#include "temporary_folder.h"

namespace tyndall {

/// Writes glTF files into a folder of the test's own and loads them.
class GltfTest : public TemporaryFolder {
 protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        store_.set_base(folder_);
        log::set_level(log::Level::error);
    }
    void TearDown() override {
        log::set_level(log::Level::info);
        TemporaryFolder::TearDown();
    }

    void write(const std::string& name, std::string_view content) {
        std::ofstream(folder_ / name, std::ios::binary) << content;
    }
    std::shared_ptr<const GltfAsset> load(GltfWriter& writer) {
        const std::string name = "file" + std::to_string(files_++) + ".glb";
        write(name, writer.glb());
        return store_.gltf(name);
    }
    std::string error_of_file(const std::string& name) {
        try {
            (void)store_.gltf(name);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }
    std::string error_of(GltfWriter& writer) {
        const std::string name = "file" + std::to_string(files_++) + ".glb";
        write(name, writer.glb());
        return error_of_file(name);
    }
    /// A PNG of one colour.
    std::string png(uint8_t r, uint8_t g, uint8_t b) {
        Image image(2, 2, 3, Image::Type::u8);
        for (size_t i = 0; i < image.value_count(); ++i) image.bytes()[i] = i % 3 == 0 ? r : i % 3 == 1 ? g : b;
        save_png(folder_ / "made.png", image);
        std::ifstream in(folder_ / "made.png", std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    static const MeshAsset& first_mesh(const GltfAsset& asset) { return *asset.nodes.at(0).primitives.at(0).mesh; }
    static const Material& first_material(const GltfAsset& asset) {
        return *asset.nodes.at(0).primitives.at(0).material;
    }

    ColorConfig config_{paths::root() / "config" / "color" / "tyndall.ocio"};  ///< works in linear Rec.709
    AssetStore store_{config_, std::filesystem::current_path()};
    int files_ = 0;
};

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

}  // namespace tyndall
