#pragma once

#include "src/shadow/lights/light.hpp"
#include "src/viewer/orbit.hpp"

#include <optional>

namespace edgeshade::viewer {

/// Handles of lights in the picture. A point light's handle is at its position; a sun's lies on a
/// sphere around the scene's middle, in the sun's direction.
class LightHandles {
  public:
    /// `bounds`: the scene's bounds in the world.
    explicit LightHandles(const Box& bounds);

    glm::dvec3 middle() const { return middle_; }
    double sphereRadius() const { return radius_; }
    glm::dvec3 placeOf(const Light& light) const;

    /// The handle's pixel; empty behind the eye.
    std::optional<glm::dvec2> pixelOf(const Light& light, const PictureView& view) const;

    /// The light whose handle is nearest to the pixel and within `reach` pixels of it.
    std::optional<std::size_t> lightAt(const std::vector<Light>& lights, const glm::dvec2& pixel,
                                       const PictureView& view, double reach) const;

    /// Turns a point light into a sun from the handle's place, and the other way round.
    Light turnedOver(const Light& light) const;

  private:
    glm::dvec3 middle_;
    double radius_;
};

/// Moves one light with the pointer that holds its handle.
class LightDrag {
  public:
    /// `pixel`: the place where the pointer grabbed it.
    LightDrag(const LightHandles& handles, const Light& light, const PictureView& view,
              const glm::dvec2& pixel);

    /// The light with its handle under the pointer. A point light stays in the plane through it
    /// that is parallel to the picture. A sun's handle stays on its sphere, on the same side of it
    /// until the pointer leaves the sphere's outline and comes back, which takes it to the other
    /// side.
    Light movedTo(const glm::dvec2& pixel, const Light& light, const PictureView& view);

  private:
    LightHandles handles_;
    glm::dvec2 hold_;      ///< from the pointer to the handle, pixels
    bool farSide_ = false; ///< on the far side of the sphere
    bool outside_ = false; ///< outside the sphere's outline
};

} // namespace edgeshade::viewer
