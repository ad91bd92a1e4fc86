#include "src/gl/entry_points.hpp"

namespace edgeshade::gl {

std::optional<std::string> entryPointSuffix(const std::string& version,
                                            const std::string& extensions,
                                            const std::string& feature) {
    const std::string prefix = "OpenGL ES ";
    if (version.starts_with(prefix) && version.size() > prefix.size() &&
        version[prefix.size()] >= '3')
        return "";
    for (const std::string vendor : {"EXT", "ANGLE", "NV"})
        if ((" " + extensions + " ").find(" GL_" + vendor + "_" + feature + " ") !=
            std::string::npos)
            return vendor;
    return std::nullopt;
}

} // namespace edgeshade::gl
