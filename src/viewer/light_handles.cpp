#include "src/viewer/light_handles.hpp"

#include <cmath>

namespace edgeshade::viewer {
namespace {

constexpr double sphereShare = 0.35; // of the scene's diagonal: inside most views of the whole
                                     // scene

} // namespace

LightHandles::LightHandles(const Box& bounds)
    : middle_(bounds.center()),
      radius_(bounds.diagonal() > 0.0 ? sphereShare * bounds.diagonal() : 1.0) {}

glm::dvec3 LightHandles::placeOf(const Light& light) const {
    const glm::dvec3 position(light.position);
    return light.position.w == 0.0 ? middle_ + radius_ * glm::normalize(position) : position;
}

std::optional<glm::dvec2> LightHandles::pixelOf(const Light& light, const PictureView& view) const {
    const glm::dvec3 place = placeOf(light);
    if (view.depthOf(place) <= 0.0) return std::nullopt;
    return view.pixelOf(place);
}

std::optional<std::size_t> LightHandles::lightAt(const std::vector<Light>& lights,
                                                 const glm::dvec2& pixel, const PictureView& view,
                                                 double reach) const {
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const auto handle = pixelOf(lights[i], view);
        if (!handle || glm::distance(*handle, pixel) > reach) continue;
        reach = glm::distance(*handle, pixel);
        nearest = i;
    }
    return nearest;
}

Light LightHandles::turnedOver(const Light& light) const {
    const glm::dvec3 place = placeOf(light);
    if (light.position.w == 0.0) return {glm::dvec4(place, 1.0)};
    return place == middle_ ? defaultLight()
                            : Light{glm::dvec4(glm::normalize(place - middle_), 0.0)};
}

LightDrag::LightDrag(const LightHandles& handles, const Light& light, const PictureView& view,
                     const glm::dvec2& pixel)
    : handles_(handles), hold_(handles.pixelOf(light, view).value_or(pixel) - pixel) {
    const glm::dvec3 place = handles.placeOf(light);
    farSide_ = glm::dot(place - handles.middle(), place - view.camera.from) > 0.0;
}

Light LightDrag::movedTo(const glm::dvec2& pixel, const Light& light, const PictureView& view) {
    const glm::dvec2 handle = pixel + hold_;
    if (light.position.w != 0.0)
        return light.at(
            glm::dvec4(view.pointAt(handle, view.depthOf(glm::dvec3(light.position))), 1.0));

    const Ray ray = view.rayThrough(handle);
    const glm::dvec3 toMiddle = handles_.middle() - ray.from;
    const double along = glm::dot(toMiddle, ray.direction);
    const double radius = handles_.sphereRadius();
    const double halfChordSquared =
        radius * radius - (glm::dot(toMiddle, toMiddle) - along * along);
    const bool isOutside = halfChordSquared < 0.0;
    if (outside_ && !isOutside) farSide_ = !farSide_;
    outside_ = isOutside;
    // Seen from inside the sphere, only its far side exists.
    const double halfChord = std::sqrt(std::max(0.0, halfChordSquared));
    const double at = along - halfChord > 0.0 && !farSide_ ? along - halfChord : along + halfChord;
    const glm::dvec3 direction = ray.from + at * ray.direction - handles_.middle();
    if (glm::length(direction) == 0.0) return light;
    return light.at(glm::dvec4(glm::normalize(direction), 0.0));
}

} // namespace edgeshade::viewer
