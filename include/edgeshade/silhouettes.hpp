#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace edgeshade {

/// An edge, and how often it bounds the casters' shadow volume.
struct SilhouetteEdge {
    std::uint32_t a = 0; ///< a vertex; of those at one place the first
    std::uint32_t b = 0;
    int multiplicity =
        0; ///< not 0; ±2 of an edge between a triangle that is lit and one that isn't
};

/// Triangles that cast, any soup of them, and what of them bounds their shadow volume in a light.
/// No GL is needed.
///
/// Every triangle adds a prism from itself to infinity, away from the light; volumes that cover a
/// point sum up to 0 where it is lit. Of all prisms this is what is left to draw: for m =
/// multiplicity above 0 the quad (b, a, a at infinity, b at infinity) m times, below 0 the quad
/// (a, b, b at infinity, a at infinity) -m times, counter-clockwise from outside; and each triangle
/// whose side is 1 as it is wound, and reversed at infinity, where it is -1 the other way round.
/// What is emitted is closed, whatever rounding does (docs/method.md, The closed chain).
class ShadowCasters {
  public:
    /// `positions`: x, y, z a vertex, finite; `indices`: three a triangle. Nothing is kept of the
    /// spans. Throws std::runtime_error with a full sentence. Takes time n log n in the triangles.
    ShadowCasters(std::span<const float> positions, std::span<const std::uint32_t> indices);
    ~ShadowCasters();
    ShadowCasters(ShadowCasters&&) noexcept;
    ShadowCasters& operator=(ShadowCasters&&) noexcept;

    /// The edges whose multiplicity isn't 0, sorted by place. `light`: homogeneous; x, y, z, 1 of a
    /// point, x, y, z, 0 of what shines from that direction.
    std::vector<SilhouetteEdge> silhouettes(const std::array<double, 4>& light) const;
    /// Of every triangle, in the order of the indices: 1, it is seen counter-clockwise from the
    /// light; -1, clockwise; 0, the light is in its plane, or it has no area.
    std::vector<std::int8_t> sides(const std::array<double, 4>& light) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace edgeshade
