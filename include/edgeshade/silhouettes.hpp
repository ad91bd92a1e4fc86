#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace edgeshade {

/// An edge, and how often it bounds the casters' shadow volume.
struct SilhouetteEdge {
    std::uint32_t a = 0; ///< index of a vertex; of vertices at the same position, the first
    std::uint32_t b = 0;
    int multiplicity = 0; ///< not 0; ±2 for an edge between a lit triangle and an unlit one
};

/// Casting triangles, in any soup, and the edges and caps that bound their shadow volume for a
/// light. No GL is needed.
///
/// Every triangle adds a prism that extends from it to infinity, away from the light. At any point
/// the volumes that cover it sum to 0 where it is lit. After the prisms cancel, this is left to
/// draw. For m = multiplicity above 0 draw the quad (b, a, a at infinity, b at infinity) m times,
/// below 0 the quad (a, b, b at infinity, a at infinity) -m times, counter-clockwise from outside.
/// Draw each triangle whose side is 1 as it is wound, and reversed at infinity; where its side is
/// -1, the other way round. The result is closed whatever rounding does (docs/method.md, The closed
/// chain).
class ShadowCasters {
  public:
    /// `positions`: x, y, z per vertex, finite; `indices`: three per triangle. The spans are not
    /// kept. Throws std::runtime_error with a full sentence. Takes time n log n in the triangles.
    ShadowCasters(std::span<const float> positions, std::span<const std::uint32_t> indices);
    ~ShadowCasters();
    ShadowCasters(ShadowCasters&&) noexcept;
    ShadowCasters& operator=(ShadowCasters&&) noexcept;

    /// The edges whose multiplicity isn't 0, sorted by position. `light`: homogeneous; x, y, z, 1
    /// for a point light, x, y, z, 0 for a light that shines from that direction.
    std::vector<SilhouetteEdge> silhouettes(const std::array<double, 4>& light) const;
    /// For every triangle, in the order of the indices: 1 if it is counter-clockwise as seen from
    /// the light; -1 if clockwise; 0 if the light is in its plane or the triangle has no area.
    std::vector<std::int8_t> sides(const std::array<double, 4>& light) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace edgeshade
