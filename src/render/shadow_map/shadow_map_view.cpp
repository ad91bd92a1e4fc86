#include "src/render/shadow_map/shadow_map_view.hpp"

#include "src/render/shadow_map/cascades.hpp"
#include "src/scene/build_parts.hpp"
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

/// Whether some corner is on the inside of each plane through the light around the face's texture.
bool sees(const CubeFace& face, double share, const std::array<glm::dvec3, 8>& offsets) {
    const glm::dvec3 s = share * face.s, t = share * face.t;
    for (const glm::dvec3& plane : {face.axis + s, face.axis - s, face.axis + t, face.axis - t})
        if (std::none_of(offsets.begin(), offsets.end(),
                         [&](const glm::dvec3& offset) { return glm::dot(plane, offset) >= 0.0; }))
            return false;
    return true;
}

/// What of the bounds the light may reach: empty where nothing.
Box reached(const Box& bounds, const glm::dvec3& light, double range) {
    return {glm::max(bounds.low, light - range), glm::min(bounds.high, light + range)};
}

/// How much of a face's width is left by texels that a filter, and the GL's own way of averaging,
/// reach.
double shareOfFace(ShadowMapKind kind, const ShadowMapSettings& settings) {
    if (kind == ShadowMapKind::point ||
        !(settings.isFiltered() || kind == ShadowMapKind::paraboloid))
        return 1.0;
    const double margin = std::min(2.0 + settings.pcf / 2, 0.25 * settings.size);
    return 1.0 - 2.0 * margin / settings.size;
}

ShadowMapView pointView(const glm::dvec3& light, const Box& sceneBounds, double lightRange,
                        const ShadowMapSettings& settings, ShadowMapKind kind, int depthBits) {
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
    view.kind = kind;
    view.share = shareOfFace(kind, settings);
    view.mapFromWorld =
        fromRows({1.0 / range, 0, 0, -light.x / range}, {0, 1.0 / range, 0, -light.y / range},
                 {0, 0, 1.0 / range, -light.z / range});
    if (kind == ShadowMapKind::paraboloid) {
        view.faces.assign(2, {glm::dmat4(1.0), !apart}); // a half's margin shows the other, too
    } else {
        for (const CubeFace& face : cubeFaces)
            view.faces.push_back({fromRows({view.share * face.s, 0.0}, {view.share * face.t, 0.0},
                                           {face.axis, -2.0 * near}, {face.axis, 0.0}),
                                  !apart && sees(face, view.share, offsets)});
    }
    view.step = 2.0 / (settings.size * view.share);
    view.texel = view.step * range;
    view.near = near;
    return view;
}

/// Right, up and back of a directional light.
glm::dmat3 lightAxes(const glm::dvec3& towards) {
    const glm::dvec3 back = unitOf(towards);
    const bool vertical = std::hypot(back.x, back.z) < 1e-9;
    const glm::dvec3 right =
        vertical ? glm::dvec3(1, 0, 0) : glm::normalize(glm::cross({0, 1, 0}, back));
    return {right, glm::cross(back, right), back};
}

/// A box around all casters in the light's axes, which is tighter than one around their box in the
/// world; from the middle of the scene, so that doubles keep their digits far from the origin.
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

/// A sun's map whose xy are 0..1 across what casts, warped for what is visible.
void warp(ShadowMapView& view, WarpGrid grid, std::span<const glm::dvec3> visible, double margin) {
    if constexpr (allMapKinds) {
        std::vector<glm::dvec2> places;
        places.reserve(visible.size());
        for (const glm::dvec3& place : visible)
            places.emplace_back(view.mapFromWorld * glm::dvec4(place, 1.0));
        view.warp = mapWarp(grid, places, margin);
        view.faces.push_back({glm::dmat4(1.0), true}); // casters are drawn where their cuts are
    }
}

/// Texels around what a parallel map shows, of each side: a kernel reaches them, and so may bias.
double frameTexels(const ShadowMapSettings& settings) {
    const double frame = 2.0 + settings.pcf / 2;
    if (settings.kind != MapKind::cascades) return frame;
    const double moved = 0.5 * (settings.pcf + 1) * static_cast<double>(settings.biasTexels);
    return std::min(frame + moved, 0.25 * settings.size);
}

ShadowMapView sunView(const glm::dvec3& towards, const MapSubject& subject, const FrameView& frame,
                      const ShadowMapSettings& settings, ShadowMapKind kind,
                      std::span<const glm::dvec3> visible) {
    const glm::dmat3 worldFromLight = lightAxes(towards);
    const Box casters = castersInLight(subject, worldFromLight);
    const glm::dvec3 middle = casters.center();
    const glm::dvec3 center = subject.bounds.center() + worldFromLight * middle;
    const double diagonal = subject.bounds.diagonal();
    const double smallest = diagonal > 0.0 ? 1e-6 * diagonal : 1.0;
    glm::dvec3 half = glm::max(0.5 * (casters.high - casters.low), glm::dvec3(smallest));
    const glm::dvec2 castersHalf(half);
    const bool cascaded = kind == ShadowMapKind::cascades;
    if (cascaded) half.x = half.y = std::max(half.x, half.y); // texels are square everywhere

    // A frame of empty texels; a little room in depth.
    const double margin = frameTexels(settings);
    const double inner = settings.size - 2.0 * margin;
    const double share = inner / settings.size;
    const bool warped = kind == ShadowMapKind::warped; // its warp puts the frame around it
    const double across = warped ? 1.0 : share;
    const glm::dvec3 scale(0.5 * across / half.x, 0.5 * across / half.y, -0.49 / half.z);

    ShadowMapView view;
    view.kind = kind;
    std::array<glm::dvec4, 3> rows;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const glm::dvec3 direction = scale[axis] * worldFromLight[axis];
        rows[static_cast<std::size_t>(axis)] = {direction, 0.5 - glm::dot(direction, center)};
    }
    view.mapFromWorld = fromRows(rows[0], rows[1], rows[2]);
    view.step = 1.0 / settings.size;
    view.texel = 2.0 * std::max(half.x, half.y) / inner;
    if (warped) {
        view.share = share;
        warp(view, settings.warp, visible, margin / settings.size);
        return view;
    }
    if (!cascaded) {
        view.faces.push_back({fromRows({2, 0, 0, -1}, {0, 2, 0, -1}, {0, 0, 2, -1}), true});
        return view;
    }
    view.cascadeMargin = margin / settings.size;
    if constexpr (allMapKinds) {
        const CascadeSquare all{glm::dvec2(center * worldFromLight), castersHalf};
        for (const CascadeSquare& part :
             cascadeSquares(frame, worldFromLight, all, settings.cascades, inner)) {
            const glm::dvec2 times = half.x / part.half;
            const glm::dvec2 aside = part.middle - all.middle;
            const glm::dvec2 plus = 0.5 - times * (0.5 + glm::dvec2(scale) * aside);
            view.cascades.emplace_back(times, plus);
            view.faces.push_back(
                {fromRows({2.0 * times.x, 0, 0, 2.0 * plus.x - 1.0},
                          {0, 2.0 * times.y, 0, 2.0 * plus.y - 1.0}, {0, 0, 2, -1}),
                 true});
        }
    }
    return view;
}

} // namespace

glm::dvec3 ShadowMapView::scale() const {
    const glm::dmat3 rows = glm::transpose(glm::dmat3(mapFromWorld));
    return {glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])};
}

ShadowMapKind mapKindOf(const Light& light, const ShadowMapSettings& settings) {
    if (light.position.w == 0.0)
        return settings.kind == MapKind::cascades ? ShadowMapKind::cascades
               : settings.kind == MapKind::warped ? ShadowMapKind::warped
                                                  : ShadowMapKind::directional;
    if (settings.kind == MapKind::paraboloid) return ShadowMapKind::paraboloid;
    // Filtered texels are averaged in the shader, which needs to know its four.
    return settings.facesApart || settings.isFiltered() ? ShadowMapKind::pointApart
                                                        : ShadowMapKind::point;
}

ShadowMapView shadowMapView(const Light& light, const MapSubject& subject, const FrameView& frame,
                            const ShadowMapSettings& settings, int depthBits,
                            std::span<const glm::dvec3> visible) {
    const glm::dvec3 position(light.position);
    const ShadowMapKind kind = mapKindOf(light, settings);
    return light.position.w == 0.0 ? sunView(position, subject, frame, settings, kind, visible)
                                   : pointView(position / light.position.w, subject.bounds,
                                               light.range, settings, kind, depthBits);
}

} // namespace edgeshade
