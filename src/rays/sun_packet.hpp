#pragma once

#include "src/rays/holes.hpp"
#include "src/rays/surface_set.hpp"

#include <span>

namespace edgeshade::rays {

/// A direction towards the sun, in the world and in the batches' spaces.
struct SunDirection {
    glm::dvec3 exact;  ///< as given
    glm::dvec3 scaled; ///< times a power of two: its largest component is from 1/2 to 1
    std::span<const glm::dvec3> inBatch; ///< by slot of a batch, see SunPacket
};

/// Up to sixteen points, and the search for what blocks their light from one direction after
/// another. Allocates nothing, except where integers decide.
class SunPacket {
  public:
    /// `points`: 1 to packetSize. `slots`: by batch, where SunDirection::inBatch has it.
    SunPacket(const SurfaceSet& surfaces, const Holes& holes, std::span<const SurfacePoint> points,
              std::span<const std::uint32_t> slots);

    /// The points that the sun lights from that direction.
    Lanes lit(const SunDirection& sun);

  private:
    /// A triangle that some of the points are on.
    struct Surface {
        std::uint32_t triangle;
        Lanes points;             ///< that are on it
        glm::dvec3 normal;        ///< unnormalised, in the world
        double normalError;       ///< bound of its error, times a direction's sum of magnitudes
        glm::dvec3 normalInBatch; ///< of length 1; 0: the triangle has no area there
        std::uint32_t slot;       ///< of its batch
        bool casts;
        /// The points that are looked at from the side of `normal`, and from the other side.
        Lanes fromFront, fromBack;
    };

    /// Points in the plane of a triangle, which never blocks their light.
    struct Coplanar {
        std::uint32_t triangle;
        Lanes points;
    };

    void addSurface(std::size_t point, std::span<const std::uint32_t> slots);
    void place(std::size_t point, glm::dvec3& place, double& error) const;
    Lanes facing(const SunDirection& sun) const;
    /// Tests whether a triangle blocks the light of points that are still lit; returns those that
    /// it blocks.
    Lanes test(std::uint32_t triangle);
    /// Points that a triangle blocks, by integers. Those in its plane aren't tested with it again.
    Lanes settled(std::uint32_t triangle, Lanes doubtful);
    void addCoplanar(std::uint32_t triangle, Lanes point);
    Lanes withoutHoles(std::uint32_t triangle, Lanes blocked) const;

    const SurfaceSet& set_;
    const Holes& holes_;
    std::span<const SurfacePoint> points_;
    std::array<glm::dvec3, packetSize> places_; ///< rounded
    std::array<Surface, packetSize> surfaces_{};
    std::size_t surfaceCount_ = 0;
    std::array<Coplanar, 2 * packetSize> coplanar_{}; ///< each point's own triangle, and others
    std::size_t coplanarCount_ = 0;
    RayTree::Origins origins_;

    // Places relative to the first one, which the double test works with.
    alignas(64) std::array<double, packetSize> x_{}, y_{}, z_{};
    double reach_ = 0.0; ///< largest magnitude of these
    double error_ = 0.0; ///< bound of their errors, by component

    // The direction under test.
    const SunDirection* sun_ = nullptr;
    double sunSum_ = 0.0;                        ///< of the magnitudes of SunDirection::scaled
    Lanes lit_ = 0;                              ///< points that nothing found so far blocks
    std::uint32_t blocker_ = SurfacePoint::none; ///< the last triangle that blocked
    std::uint32_t tried_ = SurfacePoint::none;   ///< tested for this direction before the tree
};

} // namespace edgeshade::rays
