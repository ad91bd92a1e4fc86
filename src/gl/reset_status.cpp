#include "src/gl/reset_status.hpp"

#include "src/gl/entry_points.hpp"

namespace edgeshade::gl {

std::optional<ResetStatus> ResetStatus::find(const std::string& version,
                                             const std::string& extensions,
                                             void* (*lookUp)(const char*)) {
    const auto has = [&](const char* name) { return listsExtension(extensions, name); };
    const char* name = has("GL_KHR_robustness")               ? "glGetGraphicsResetStatusKHR"
                       : has("GL_EXT_robustness")             ? "glGetGraphicsResetStatusEXT"
                       : version.starts_with("OpenGL ES 3.2") ? "glGetGraphicsResetStatus"
                                                              : nullptr;
    if (!name) return std::nullopt;
    ResetStatus status;
    status.get_ = reinterpret_cast<Get>(lookUp(name));
    return status.get_ ? std::optional(status) : std::nullopt;
}

} // namespace edgeshade::gl
