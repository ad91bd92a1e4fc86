#include "web/masks/web_functions.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#define GL_GLEXT_PROTOTYPES // declares the entry points
#include <GLES3/gl3.h>

namespace edgeshade::web {
namespace {

struct Entry {
    std::string_view name;
    void* function;
};

const Entry entries[] = {
    {"glBindSampler", reinterpret_cast<void*>(glBindSampler)},
    {"glVertexAttribDivisor", reinterpret_cast<void*>(glVertexAttribDivisor)},
    {"glDrawArraysInstanced", reinterpret_cast<void*>(glDrawArraysInstanced)},
    {"glDrawElementsInstanced", reinterpret_cast<void*>(glDrawElementsInstanced)},
};

} // namespace

void* webFunction(const char* name) {
    std::string_view wanted = name;
    constexpr std::string_view extension = "ANGLE"; // suffix in WebGL 1, for the same functions
    if (wanted.ends_with(extension)) wanted.remove_suffix(extension.size());
    const auto* found = std::find_if(std::begin(entries), std::end(entries),
                                     [&](const Entry& entry) { return entry.name == wanted; });
    return found != std::end(entries) ? found->function : nullptr;
}

} // namespace edgeshade::web
