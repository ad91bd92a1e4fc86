#pragma once

#include "src/scene/gpu_scene.hpp"
#include "src/shadow/geometry/light.hpp"

#include <optional>

namespace edgeshade::viewer {

/// Each light's casters in groups that a stencil can count (LayerBound), kept until the light
/// moves: bounding them takes 8 ms for 150,000 triangles where few lie behind each other, up to
/// 0.1 s where many do.
class CasterGroups {
  public:
    /// The groups as Renderer::draw() wants them. Those of lights that have not moved since the
    /// last call are there already.
    const std::vector<GroupedShadow>& of(const std::vector<Light>& lights,
                                         const LoadedScene& loaded, VolumeRecords records);

  private:
    std::vector<glm::dvec4> lights_;
    std::vector<GroupedShadow> groups_; ///< one a light; empty: it needs none
};

} // namespace edgeshade::viewer
