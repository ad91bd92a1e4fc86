#include "src/render/shadow_map/shadow_map_view.hpp"

#include "src/render/shadow_map/cascades.hpp"
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

/// Whether, for each plane through the light around the face's texture, some corner is on its
/// inside.
bool sees(const CubeFace& face, double share, const std::array<glm::dvec3, 8>& offsets) {
    const glm::dvec3 s = share * face.s, t = share * face.t;
    for (const glm::dvec3& plane : {face.axis + s, face.axis - s, face.axis + t, face.axis - t})
        if (std::none_of(offsets.begin(), offsets.end(),
                         [&](const glm::dvec3& offset) { return glm::dot(plane, offset) >= 0.0; }))
            return false;
    return true;
}

/// The part of the bounds that the light may reach; empty if none.
Box reached(const Box& bounds, const glm::dvec3& light, double range) {
    return {glm::max(bounds.low, light - range), glm::min(bounds.high, light + range)};
}

/// Right, up and back of a directional light.
glm::dmat3 lightAxes(const glm::dvec3& towards) {
    const glm::dvec3 back = unitOf(towards);
    const bool vertical = std::hypot(back.x, back.z) < 1e-9;
    const glm::dvec3 right =
        vertical ? glm::dvec3(1, 0, 0) : glm::normalize(glm::cross({0, 1, 0}, back));
    return {right, glm::cross(back, right), back};
}

/// A box around all casters in the light's axes, tighter than one around their box in the world.
/// Its origin is the scene's middle, so that doubles keep their digits far from the world's origin.
Box castersInLight(const MapSubject& subject, const glm::dmat3& worldFromLight) {
    const glm::dmat3 lightFromWorld = glm::transpose(worldFromLight);
    const glm::dvec3 center = subject.bounds.center();
    Box box;
    for (std::size_t i = 0; i < subject.casters.size(); ++i)
        if (!subject.casters[i].empty())
            for (const glm::dvec3& corner : cornersOf(subject.casters[i]))
                box.add(
                    lightFromWorld *
                    (glm::dvec3(subject.worldFromCasters[i] * glm::dvec4(corner, 1.0)) - center));
    if (box.empty())
        for (const glm::dvec3& corner : cornersOf(subject.bounds))
            box.add(lightFromWorld * (corner - center));
    return box;
}

} // namespace

glm::dvec3 ShadowMapView::scale() const {
    const glm::dmat3 rows = glm::transpose(glm::dmat3(mapFromWorld));
    return {glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])};
}

ShadowMapView pointMapView(const glm::dvec3& light, const Box& sceneBounds, double lightRange,
                           int size, double share, int depthBits) {
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

    // Put the near plane as far out as the bounds allow. If the light is inside them, clip as much
    // near it as the depth buffer can't resolve at the far end: near = far / 2^(bits / 2).
    double near = std::exp2(-0.5 * depthBits);
    const glm::dvec3 outside = glm::max(bounds.low - light, light - bounds.high);
    near = std::max(near, 0.99 * std::max({outside.x, outside.y, outside.z}) / range);

    ShadowMapView view;
    view.share = share;
    view.mapFromWorld =
        fromRows({1.0 / range, 0, 0, -light.x / range}, {0, 1.0 / range, 0, -light.y / range},
                 {0, 0, 1.0 / range, -light.z / range});
    for (const CubeFace& face : cubeFaces)
        view.faces.push_back({fromRows({share * face.s, 0.0}, {share * face.t, 0.0},
                                       {face.axis, -2.0 * near}, {face.axis, 0.0}),
                              !apart && sees(face, share, offsets)});
    view.step = 2.0 / (size * share);
    view.texel = view.step * range;
    view.near = near;
    return view;
}

double frameTexels(const ShadowMapSettings& settings) {
    const double frame = 2.0 + settings.pcf / 2;
    if (settings.kind != MapKind::cascades) return frame;
    const double moved = 0.5 * (settings.pcf + 1) * static_cast<double>(settings.biasTexels);
    return std::min(frame + moved, 0.25 * settings.size);
}

ShadowMapView sunMapView(const glm::dvec3& towards, const MapSubject& subject,
                         const FrameView& frame, const ShadowMapSettings& settings, bool framed) {
    const glm::dmat3 worldFromLight = lightAxes(towards);
    const Box casters = castersInLight(subject, worldFromLight);
    const glm::dvec3 middle = casters.center();
    const glm::dvec3 center = subject.bounds.center() + worldFromLight * middle;
    const double diagonal = subject.bounds.diagonal();
    const double smallest = diagonal > 0.0 ? 1e-6 * diagonal : 1.0;
    glm::dvec3 half = glm::max(0.5 * (casters.high - casters.low), glm::dvec3(smallest));
    const glm::dvec2 castersHalf(half);
    const bool cascaded = settings.kind == MapKind::cascades;
    if (cascaded) half.x = half.y = std::max(half.x, half.y); // texels are square everywhere

    // Leave a frame of empty texels, and a little room in depth.
    const double margin = frameTexels(settings);
    const double inner = settings.size - 2.0 * margin;
    const double share = inner / settings.size;
    const double across = framed ? share : 1.0;
    const glm::dvec3 scale(0.5 * across / half.x, 0.5 * across / half.y, -0.49 / half.z);

    ShadowMapView view;
    std::array<glm::dvec4, 3> rows;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const glm::dvec3 direction = scale[axis] * worldFromLight[axis];
        rows[static_cast<std::size_t>(axis)] = {direction, 0.5 - glm::dot(direction, center)};
    }
    view.mapFromWorld = fromRows(rows[0], rows[1], rows[2]);
    view.step = 1.0 / settings.size;
    view.texel = 2.0 * std::max(half.x, half.y) / inner;
    if (!cascaded) {
        view.faces.push_back({fromRows({2, 0, 0, -1}, {0, 2, 0, -1}, {0, 0, 2, -1}), true});
        return view;
    }
    view.cascadeMargin = margin / settings.size;
    const CascadeSquare all{glm::dvec2(center * worldFromLight), castersHalf};
    for (const CascadeSquare& part :
         cascadeSquares(frame, worldFromLight, all, settings.cascades, inner)) {
        const glm::dvec2 times = half.x / part.half;
        const glm::dvec2 aside = part.middle - all.middle;
        const glm::dvec2 plus = 0.5 - times * (0.5 + glm::dvec2(scale) * aside);
        view.cascades.emplace_back(times, plus);
        view.faces.push_back({fromRows({2.0 * times.x, 0, 0, 2.0 * plus.x - 1.0},
                                       {0, 2.0 * times.y, 0, 2.0 * plus.y - 1.0}, {0, 0, 2, -1}),
                              true});
    }
    return view;
}

} // namespace edgeshade
