#pragma once

#include <optional>
#include <string>

namespace edgeshade::gl {

/// Whether the name is among the space-separated extensions.
bool listsExtension(const std::string& extensions, const std::string& name);

/// Looks up a GL function by name; returns false if `lookUp` has none.
template <class Function>
bool takeEntryPoint(Function& function, void* (*lookUp)(const char*), const std::string& name) {
    function = reinterpret_cast<Function>(lookUp(name.c_str()));
    return function != nullptr;
}

/// The suffix of the entry points of a feature that ES 3.0 made core: "" from ES 3.0 on, "EXT",
/// "ANGLE" or "NV" if GL_<suffix>_<feature> is among the space-separated extensions, null without
/// the feature. `version` is GL_VERSION.
std::optional<std::string> entryPointSuffix(const std::string& version,
                                            const std::string& extensions,
                                            const std::string& feature);

} // namespace edgeshade::gl
