#pragma once

#include "edgeshade/matrix.hpp"

#include <algorithm>
#include <EGL/egl.h>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace edgeshade {

/// For ShadowMasks.
inline void* eglAddressOf(const char* name) {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
}

inline Matrix16 numbersOf(const glm::dmat4& matrix) {
    Matrix16 numbers{};
    std::copy_n(glm::value_ptr(matrix), 16, numbers.begin());
    return numbers;
}

} // namespace edgeshade
