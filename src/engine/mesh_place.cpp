#include "src/engine/mesh_place.hpp"

#include "preprocess/base/error.hpp"

#include <cmath>

namespace edgeshade {

glm::dmat4 placeOf(const Matrix16& numbers) {
    const glm::dmat4 place = matrixOf(numbers);
    for (const double value : numbers)
        if (!std::isfinite(value))
            throw InputError("A mesh's matrix has a number that is not finite.");
    if (numbers[3] != 0.0 || numbers[7] != 0.0 || numbers[11] != 0.0 || numbers[15] != 1.0)
        throw InputError("A mesh's matrix is not affine: its last row is not 0, 0, 0, 1.");
    if (glm::determinant(glm::dmat3(place)) == 0.0)
        throw InputError("A mesh's matrix is singular: it flattens the mesh.");
    return place;
}

} // namespace edgeshade
