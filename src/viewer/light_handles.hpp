#pragma once

#include "src/shadow/lights/light.hpp"
#include "src/viewer/orbit.hpp"

#include <optional>

namespace edgeshade::viewer {

/// Where lights are held in the picture. A point light's handle is where it is; a sun's lies on a
/// sphere around the scene's middle, in its direction.
class LightHandles {
  public:
    /// `bounds`: the scene's in the world.
    explicit LightHandles(const Box& bounds);

    glm::dvec3 middle() const { return middle_; }
    double sphereRadius() const { return radius_; }
    glm::dvec3 placeOf(const Light& light) const;

    /// Where the handle is seen; nothing behind the eye.
    std::optional<glm::dvec2> pixelOf(const Light& light, const PictureView& view) const;

    /// The light whose handle is nearest to the pixel and within `reach` pixels of it.
    std::optional<std::size_t> lightAt(const std::vector<Light>& lights, const glm::dvec2& pixel,
                                       const PictureView& view, double reach) const;

    /// A point light at the handle's place becomes a sun from there, and the other way round.
    Light turnedOver(const Light& light) const;

  private:
    glm::dvec3 middle_;
    double radius_;
};

/// Moves one light with a pointer that holds its handle.
class LightDrag {
  public:
    /// `pixel`: where the pointer took hold of it.
    LightDrag(const LightHandles& handles, const Light& light, const PictureView& view,
              const glm::dvec2& pixel);

    /// The light with its handle under the pointer. A point light stays in the plane through it
    /// parallel to the picture. A sun's handle stays on its sphere: on the side on which it is,
    /// until the pointer leaves the sphere's outline and comes back, which takes it to the other.
    Light movedTo(const glm::dvec2& pixel, const Light& light, const PictureView& view);

  private:
    LightHandles handles_;
    glm::dvec2 hold_;      ///< from the pointer to the handle, pixels
    bool farSide_ = false; ///< of the sphere
    bool outside_ = false; ///< of its outline
};

} // namespace edgeshade::viewer
