#include "src/gl/host_functions.hpp"

#include "src/gl/entry_points.hpp"

namespace edgeshade::gl {

HostFunctions HostFunctions::find(const std::string& version, const std::string& extensions,
                                  void* (*lookUp)(const char*)) {
    HostFunctions found;
    const auto divisor = entryPointSuffix(version, extensions, "instanced_arrays");
    found.es3 = entryPointSuffix(version, "", "").has_value();
    if (divisor) takeEntryPoint(found.divisor, lookUp, "glVertexAttribDivisor" + *divisor);
    if (found.es3) takeEntryPoint(found.bindSampler, lookUp, "glBindSampler");
    if (!found.es3 && !listsExtension(extensions, "GL_OES_vertex_array_object")) return found;
    const std::string suffix = found.es3 ? "" : "OES";
    const bool complete =
        takeEntryPoint(found.genVertexArrays, lookUp, "glGenVertexArrays" + suffix) &&
        takeEntryPoint(found.deleteVertexArrays, lookUp, "glDeleteVertexArrays" + suffix) &&
        takeEntryPoint(found.bindVertexArray, lookUp, "glBindVertexArray" + suffix);
    if (!complete) found.bindVertexArray = nullptr;
    return found;
}

} // namespace edgeshade::gl
