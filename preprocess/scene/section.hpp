#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace edgeshade {

/// Whether the part that a section cuts away casts shadows.
enum class SectionShadows {
    cut,   ///< it casts nothing: the model is opened
    whole, ///< it casts as built: a house without its roof keeps the light of its rooms
};

/// Planes that cut a scene open (docs/method.md, C49 and C50).
struct Section {
    /// Largest number of planes typed one by one; a box adds six.
    static constexpr std::size_t mostPlanes = 6;

    /// Keeps the points with dot(plane, (x, y, z, 1)) >= 0 for every plane; world space. The first
    /// three components are finite and not all 0, and of any length.
    std::vector<glm::dvec4> planes;
    SectionShadows shadows = SectionShadows::cut;
    /// Linear colour of cut faces of solids; null: they stay open.
    std::optional<glm::vec3> fill;

    bool operator==(const Section&) const = default;
};

} // namespace edgeshade
