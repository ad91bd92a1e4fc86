#pragma once

#include "edgeshade/shadow_masks.hpp"

#include <glm/gtc/type_ptr.hpp>

namespace edgeshade {

inline glm::dmat4 matrixOf(const Matrix16& numbers) {
    return glm::make_mat4(numbers.data());
}

/// A mesh's place as a matrix. Throws InputError if it isn't finite, affine and invertible.
glm::dmat4 placeOf(const Matrix16& numbers);

} // namespace edgeshade
