#pragma once

#include "src/scene/gpu_scene.hpp"
#include "src/shadow/geometry/separation.hpp"
#include "src/shadow/view/frame_view.hpp"
#include "src/shadow/view/view_planes.hpp"

namespace edgeshade {

/// A camera's view of a batch, in the forms that shaders need; doubles are rounded once.
struct BatchView {
    ViewPlanes planes;   ///< in the batch's space
    glm::dvec3 eye{0.0}; ///< the camera's position in the world
    glm::mat4 clipFromObject{1.0f};
    glm::mat4 eyeOffsetFromObject{1.0f}; ///< world axes, origin at the eye
    glm::mat3 normalFromObject{1.0f};
    glm::mat4 mapFromObject{1.0f};  ///< see ShadowMapView, LightTiles; used if there is a map
    glm::vec3 mapOrigin{0.0f};      ///< primitive maps only: the position that mapFromObject maps
                                    ///< to 0
    glm::vec3 mapOriginRest{0.0f};  ///< the part of mapOrigin that rounding removed
    glm::mat4 coneFromObject{1.0f}; ///< see coneFromWorld(); used if the light is a spot
    /// In the batch's space, for a light that is added to the picture: chunks out of its range are
    /// skipped.
    glm::dvec3 light{0.0};
    double range = std::numeric_limits<double>::infinity();
    /// The batch's chunks with their triangles' sides for a primitive map's light; null without a
    /// map.
    const std::vector<SidedChunk>* sided = nullptr;
    const AlphaLookup* alpha = nullptr; ///< the batch's own; null: its materials' alpha applies
    bool mirrored = false;
    bool culls = false; ///< see Scene
};

/// The camera's view of a batch, with the slice's depth range.
BatchView batchViewOf(const GpuBatch& batch, const FrameView& view, const DepthSlice& slice);

} // namespace edgeshade
