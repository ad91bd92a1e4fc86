#pragma once

#include "preprocess/scene/scene.hpp"

#include <array>

namespace edgeshade::test {

/// Draws scenes in code: one batch, flat normals, one material per group.
class SceneBuilder {
  public:
    SceneBuilder();

    /// Later triangles use this material. Groups must come in the order opaque, mask, blend.
    SceneBuilder& material(const Material& material);

    SceneBuilder& triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

    /// Two triangles; a, b, c, d counter-clockwise as seen from outside.
    SceneBuilder& quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                       const glm::vec3& d);

    /// A closed box, wound outwards.
    SceneBuilder& box(const glm::vec3& low, const glm::vec3& high);

    /// A square floor at height y, from -half to half, facing up.
    SceneBuilder& floor(float half, float y = 0.0f);

    /// Places the whole scene in the world.
    SceneBuilder& placedBy(const glm::dmat4& worldFromBatch);

    Scene scene() const { return scene_; }

  private:
    Batch& batch() { return scene_.batches.front(); }
    Geometry& geometry() { return batch().geometry.edit(); }

    Scene scene_;
};

/// Boxes, a sheet and a triangle over a floor of 10 x 10: a mixed scene.
SceneBuilder yard();

} // namespace edgeshade::test
