#pragma once

#include "src/shadow/layers/caster_chain.hpp"
#include "src/shadow/layers/chain_paths.hpp"
#include "src/shadow/layers/rays_of_batch.hpp"

#include <vector>

namespace edgeshade {

/// An edge of the casters' chain in a face's frame (docs/method.md, C48), upwards: from.y <= to.y.
struct FaceSegment {
    glm::vec2 from, to;
    int starts; ///< number of ChainPaths that start at its lower end, for one segment there
    std::int16_t weight; ///< a point just to its right counts this many triangles more than one
                         ///< to its left; -2 to 2
    bool level;          ///< its exact place may fall from `from` to `to`
};

/// The same on a point light's face itself.
struct DrawnSegment {
    glm::dvec2 from, to;
    int starts;
    std::int16_t weight;
    bool level; ///< it rises by less than twice as much as its exact place may fall
};

/// The casters' chain on one face of a light. It is complete for directions within the face, with a
/// margin of a thousandth. All coordinates are in the face's frame.
struct FaceChain {
    FaceFrame frame;
    std::vector<FaceSegment> segments;
    std::vector<DrawnSegment> drawn; ///< a point light's segments until settle()
    /// Triangles whose facing isn't certain, which aren't in the chain.
    std::vector<FacePolygon> uncertain;
    int everywhere = 0; ///< number of further ones, too near to the light to be placed
    Outline reached;    ///< outline of segments and polygons
    double error = 0.0; ///< the largest distance from a segment to its exact place; not finite if
                        ///< unknown

    /// Keeps its memory.
    void clear() {
        frame = {};
        segments.clear();
        drawn.clear();
        uncertain.clear();
        everywhere = 0;
        reached = {};
        error = 0.0;
    }
};

/// Draws onto the faces of `view` what a light sees of a batch. A directional light's face has its
/// frame already, which the rays have entered. Call settle() after the last batch. `paths`: its
/// memory is reused.
void drawChain(const LightView& view, const RaysOfBatch& rays, const CasterChain& chain,
               const SeenCasters& seen, ChainPaths& paths, std::vector<FaceChain>& faces);

/// Gives a point light's face the frame of all that is drawn on it.
void settle(FaceChain& face);

/// The number of triangles among `caps` with certain facings on a ray from a point light. Those
/// that may be on either side of the ray count too. `facings`: of all of the batch's caps.
int trianglesAlong(const glm::dvec3& direction, const RaysOfBatch& rays, const CasterChain& chain,
                   const std::vector<std::int8_t>& facings, const std::vector<std::uint32_t>& caps);

} // namespace edgeshade
