#pragma once

#include "preprocess/gltf/json_field.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// An array of three numbers. Throws InputError.
inline glm::dvec3 vectorFrom(const JsonField& field) {
    const std::vector<double> numbers = field.numbers(3);
    return {numbers[0], numbers[1], numbers[2]};
}

/// An array of 16 numbers, column by column. Throws InputError.
inline glm::dmat4 matrixFrom(const JsonField& field) {
    const std::vector<double> numbers = field.numbers(16);
    glm::dmat4 matrix(1.0);
    for (glm::length_t i = 0; i < 16; ++i)
        matrix[i / 4][i % 4] = numbers[static_cast<std::size_t>(i)];
    return matrix;
}

} // namespace edgeshade
