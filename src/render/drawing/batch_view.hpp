#pragma once

#include "src/scene/gpu_scene.hpp"
#include "src/shadow/geometry/separation.hpp"
#include "src/shadow/view/frame_view.hpp"
#include "src/shadow/view/view_planes.hpp"

namespace edgeshade {

/// Where a camera sees a batch from, in the forms that shaders need; doubles rounded once.
struct BatchView {
    ViewPlanes planes; ///< in the batch's space
    glm::mat4 clipFromObject{1.0f};
    glm::mat4 eyeOffsetFromObject{1.0f}; ///< world axes, origin at the eye
    glm::mat3 normalFromObject{1.0f};
    glm::mat4 mapFromObject{1.0f};  ///< see ShadowMapView, LightTiles; used where there is a map
    glm::vec3 mapOrigin{0.0f};      ///< what the latter maps to 0, where a primitive map is
    glm::vec3 mapOriginRest{0.0f};  ///< what rounding took of that
    glm::mat4 coneFromObject{1.0f}; ///< see coneFromWorld(); used where the light is a spot
    /// In its space, of a light that is added to what is there: chunks out of its range get
    /// nothing.
    glm::dvec3 light{0.0};
    double range = std::numeric_limits<double>::infinity();
    /// Its chunks' triangles for a primitive map's light; null where there is none.
    const std::vector<SidedChunk>* sided = nullptr;
    const AlphaLookup* alpha = nullptr; ///< the batch's own; null: its materials' are taken
    bool mirrored = false;
    bool culls = false; ///< see Scene
};

/// Where the view's camera sees a batch from, drawn with the slice's depth range.
BatchView batchViewOf(const GpuBatch& batch, const FrameView& view, const DepthSlice& slice);

} // namespace edgeshade
