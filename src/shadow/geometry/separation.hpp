#pragma once

#include "preprocess/scene/scene.hpp"

#include <array>
#include <glm/glm.hpp>

namespace edgeshade {

/// The hull of a rectangle and a light: a volume, or for a directional light (w = 0) a prism that
/// extends towards it to infinity.
struct NearClipVolume {
    std::array<glm::dvec3, 4> corners; ///< of the rectangle, or any parallelogram, in cyclic order
    glm::dvec4 light;                  ///< docs/method.md, Terms
};

/// Whether volume and box are certainly apart: some axis separates them by more than rounding.
bool areApart(const NearClipVolume& volume, const Box& box);

/// Whether volume and triangle are certainly apart.
bool areApart(const NearClipVolume& volume, const std::array<glm::dvec3, 3>& triangle);

/// A volume's faces, for a quick test that settles most cases before areApart().
class ClipVolumeFaces {
  public:
    /// `volume` must outlive them.
    explicit ClipVolumeFaces(const NearClipVolume& volume);

    const NearClipVolume& volume() const { return volume_; }

    /// Whether a face, or the triangle's own plane, separates the triangle from the volume by more
    /// than rounding.
    bool separate(const std::array<glm::dvec3, 3>& triangle) const;

    /// Whether the box is wholly outside a face.
    bool separate(const Box& box) const;

    /// Whether the triangle is wholly on the light's side of the rectangle's plane.
    bool areBeforeRectangle(const std::array<glm::dvec3, 3>& triangle) const;

  private:
    struct Face {
        glm::dvec4 plane; ///< dot(plane, (p, 1)) is >= 0 in the volume
        double size;      ///< of the volume's coordinates along the normal
    };
    void add(const glm::dvec3& normal, const glm::dvec3& point, const glm::dvec4& inside);
    /// Bound of the error at these points if a directional light's direction is slightly off.
    double turnAt(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const;

    const NearClipVolume& volume_;
    std::array<Face, 5> faces_; ///< the rectangle comes first
    std::size_t count_ = 0;
    bool hasRectangle_ = false;
};

} // namespace edgeshade
