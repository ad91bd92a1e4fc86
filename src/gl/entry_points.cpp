#include "src/gl/entry_points.hpp"

namespace edgeshade::gl {

bool listsExtension(const std::string& extensions, const std::string& name) {
    return (" " + extensions + " ").find(" " + name + " ") != std::string::npos;
}

std::optional<std::string> entryPointSuffix(const std::string& version,
                                            const std::string& extensions,
                                            const std::string& feature) {
    const std::string prefix = "OpenGL ES ";
    if (version.starts_with(prefix) && version.size() > prefix.size() &&
        version[prefix.size()] >= '3')
        return "";
    for (const std::string vendor : {"EXT", "ANGLE", "NV"})
        if (listsExtension(extensions, "GL_" + vendor + "_" + feature)) return vendor;
    return std::nullopt;
}

} // namespace edgeshade::gl
