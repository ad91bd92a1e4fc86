#include "preprocess/scene/node_transform.hpp"

namespace edgeshade {

glm::dmat4 NodeTransform::matrix() const {
    glm::dmat4 parentFromNode = glm::mat4_cast(rotation);
    for (glm::length_t c = 0; c < 3; ++c)
        parentFromNode[c] *= scale[c];
    parentFromNode[3] = glm::dvec4(translation, 1.0);
    return parentFromNode;
}

} // namespace edgeshade
