#include "src/render/shadow_map/shadow_map_view.hpp"

#include "src/shadow/geometry/vectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeshade {
namespace {

std::array<glm::dvec3, 8> cornersOf(const Box& box) {
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                      i & 4 ? box.high.z : box.low.z};
    return corners;
}

/// A cube map's face: its axis and the directions of its s and t (ES 2.0.25, table 3.21).
struct CubeFace {
    glm::dvec3 axis, s, t;
};
constexpr CubeFace cubeFaces[] = {
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};

/// Whether some corner is on the inside of each plane through the light around the face.
bool sees(const CubeFace& face, const std::array<glm::dvec3, 8>& offsets) {
    for (const glm::dvec3& plane :
         {face.axis + face.s, face.axis - face.s, face.axis + face.t, face.axis - face.t})
        if (std::none_of(offsets.begin(), offsets.end(),
                         [&](const glm::dvec3& offset) { return glm::dot(plane, offset) >= 0.0; }))
            return false;
    return true;
}

/// What of the bounds the light may reach: empty where nothing.
Box reached(const Box& bounds, const glm::dvec3& light, double range) {
    return {glm::max(bounds.low, light - range), glm::min(bounds.high, light + range)};
}

ShadowMapView pointView(const glm::dvec3& light, const Box& sceneBounds, double lightRange,
                        const ShadowMapSettings& settings, int depthBits) {
    Box bounds = reached(sceneBounds, light, lightRange);
    const bool apart = glm::any(glm::greaterThan(bounds.low, bounds.high));
    if (apart) bounds = sceneBounds;
    std::array<glm::dvec3, 8> offsets = cornersOf(bounds);
    double farthest = 0.0;
    for (glm::dvec3& offset : offsets) {
        offset -= light;
        farthest = std::max(farthest, glm::length(offset));
    }
    const double range = farthest > 0.0 ? 1.01 * farthest : 1.0;

    // As far out as the bounds allow. With the light inside them, where it clips away as much as
    // the depth buffer then can't tell apart at the far end: near = far / 2^(bits / 2).
    double near = std::exp2(-0.5 * depthBits);
    const glm::dvec3 outside = glm::max(bounds.low - light, light - bounds.high);
    near = std::max(near, 0.99 * std::max({outside.x, outside.y, outside.z}) / range);

    ShadowMapView view;
    view.kind = ShadowMapKind::point;
    view.mapFromWorld =
        fromRows({1.0 / range, 0, 0, -light.x / range}, {0, 1.0 / range, 0, -light.y / range},
                 {0, 0, 1.0 / range, -light.z / range});
    for (const CubeFace& face : cubeFaces)
        view.faces.push_back(
            {fromRows({face.s, 0.0}, {face.t, 0.0}, {face.axis, -2.0 * near}, {face.axis, 0.0}),
             !apart && sees(face, offsets)});
    view.step = 2.0 / settings.size;
    view.texel = view.step * range;
    view.near = near;
    return view;
}

ShadowMapView sunView(const glm::dvec3& towards, const Box& bounds,
                      const ShadowMapSettings& settings) {
    const glm::dvec3 back = unitOf(towards);
    const bool vertical = std::hypot(back.x, back.z) < 1e-9;
    const glm::dvec3 right =
        vertical ? glm::dvec3(1, 0, 0) : glm::normalize(glm::cross({0, 1, 0}, back));
    const glm::dmat3 worldFromLight(right, glm::cross(back, right), back);

    const glm::dvec3 center = bounds.center();
    glm::dvec3 half(0.0);
    for (const glm::dvec3& corner : cornersOf(bounds))
        half = glm::max(half, glm::abs(glm::transpose(worldFromLight) * (corner - center)));
    const double smallest = bounds.diagonal() > 0.0 ? 1e-6 * bounds.diagonal() : 1.0;
    half = glm::max(half, glm::dvec3(smallest));

    // A frame of empty texels, as wide as a kernel reaches; a little room in depth.
    const double frame = 2.0 + settings.pcf / 2;
    const double inner = settings.size - 2.0 * frame;
    const double share = inner / settings.size;
    const glm::dvec3 scale(0.5 * share / half.x, 0.5 * share / half.y, -0.49 / half.z);

    ShadowMapView view;
    view.kind = ShadowMapKind::directional;
    std::array<glm::dvec4, 3> rows;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const glm::dvec3 direction = scale[axis] * worldFromLight[axis];
        rows[static_cast<std::size_t>(axis)] = {direction, 0.5 - glm::dot(direction, center)};
    }
    view.mapFromWorld = fromRows(rows[0], rows[1], rows[2]);
    view.faces.push_back({fromRows({2, 0, 0, -1}, {0, 2, 0, -1}, {0, 0, 2, -1}), true});
    view.step = 1.0 / settings.size;
    view.texel = 2.0 * std::max(half.x, half.y) / inner;
    return view;
}

} // namespace

ShadowMapView shadowMapView(const Light& light, const Box& bounds,
                            const ShadowMapSettings& settings, int depthBits) {
    const glm::dvec3 position(light.position);
    return light.position.w == 0.0
               ? sunView(position, bounds, settings)
               : pointView(position / light.position.w, bounds, light.range, settings, depthBits);
}

} // namespace edgeshade
