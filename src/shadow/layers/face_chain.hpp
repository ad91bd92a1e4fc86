#pragma once

#include "src/shadow/layers/caster_chain.hpp"
#include "src/shadow/lights/light_view.hpp"

#include <vector>

namespace edgeshade {

/// An edge of the casters' chain on a light's face (docs/method.md, C48), upwards: from.y <= to.y.
struct FaceSegment {
    glm::dvec2 from, to;
    int weight; ///< a point just to its right counts this many triangles more than one to its left
};

/// The casters' chain on one face of a light. It is complete for directions within the face, with a
/// margin of a thousandth.
struct FaceChain {
    std::vector<FaceSegment> segments;
    /// Triangles whose facing isn't certain, which aren't in the chain.
    std::vector<FacePolygon> uncertain;
    int everywhere = 0; ///< number of further ones, too near to the light to be placed
    Outline reached;    ///< outline of segments and polygons
    double error = 0.0; ///< the largest distance from a segment to its exact place, in units of the
                        ///< face; not finite if unknown

    /// Keeps its memory.
    void clear() {
        segments.clear();
        uncertain.clear();
        everywhere = 0;
        reached = {};
        error = 0.0;
    }
};

/// The affine map from a batch's space to LightView's rays.
struct RaysOfBatch {
    RaysOfBatch(const LightView& view, const glm::dmat4& worldFromBatch, double size);

    /// Always the same doubles for the same point: the edges of a vertex meet there.
    glm::dvec3 to(const glm::vec3& point) const { return linear * glm::dvec3(point) + offset; }

    glm::dmat3 linear;
    glm::dvec3 offset;
    double rounding; ///< of each component, for points with coordinates up to `size`
    bool mirrors;    ///< the batch's transform reverses winding
};

/// Draws onto the faces of `view` what a light sees of a batch.
void drawChain(const LightView& view, const RaysOfBatch& rays, const CasterChain& chain,
               const SeenCasters& seen, std::vector<FaceChain>& faces);

/// The number of triangles among `caps` with certain facings on a ray from a point light. Those
/// that may be on either side of the ray count too. `facings`: of all of the batch's caps.
int trianglesAlong(const glm::dvec3& direction, const RaysOfBatch& rays, const CasterChain& chain,
                   const std::vector<std::int8_t>& facings, const std::vector<std::uint32_t>& caps);

} // namespace edgeshade
