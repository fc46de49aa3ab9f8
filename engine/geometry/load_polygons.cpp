#include <algorithm>
#include <cctype>

#include "core/error.h"
#include "core/paths.h"
#include "geometry/readers.h"

namespace tyndall {

PolygonMesh load_polygons(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::string kinds[] = {".obj", ".ply", ".off", ".stl"};
    if (std::ranges::find(kinds, extension) == std::end(kinds))
        throw Error(Diagnostic{
            {name}, "not a model of a known kind", ".obj, .ply, .off or .stl", nearest_name(extension, kinds)});
    const std::string content = paths::read_file(file);
    if (content.empty()) throw Error(Diagnostic{{name}, "the file is empty", {}, {}});
    PolygonMesh mesh = extension == ".obj"   ? read_obj(content, name)
                       : extension == ".off" ? read_off(content, name)
                       : extension == ".ply" ? read_ply(content, name)
                                             : read_stl(content, name);
    validate(mesh, name);
    return mesh;
}

}  // namespace tyndall
