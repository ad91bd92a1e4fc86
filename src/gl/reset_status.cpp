#include "src/gl/reset_status.hpp"

namespace edgeshade::gl {

std::optional<ResetStatus> ResetStatus::find(const std::string& version,
                                             const std::string& extensions,
                                             void* (*lookUp)(const char*)) {
    const auto has = [&](const std::string& name) {
        return (" " + extensions + " ").find(" " + name + " ") != std::string::npos;
    };
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
