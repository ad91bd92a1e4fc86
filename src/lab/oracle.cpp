#include "src/lab/oracle.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/vectors.hpp"
#include "src/lab/all_pixels.hpp"
#include "src/shadow/lights/light_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgeshade::lab {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A few units of rounding, for sums of a few products.
constexpr double rounding = 1e-14;

double magnitude(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// The intersection of the line origin + t * direction with a triangle, in double precision
/// (Moeller and Trumbore), with error bounds.
struct Meeting {
    double t, u, v;
    double tError, uError, vError;

    bool inside() const { return u >= 0.0 && v >= 0.0 && u + v <= 1.0; }
    /// Whether the result of inside() is certain.
    bool certain() const {
        const bool out = u < -uError || v < -vError || u + v > 1.0 + uError + vError;
        const bool in = u > uError && v > vError && u + v < 1.0 - uError - vError;
        return out || in;
    }
};

/// `originError`: error bound of the origin, and so of the direction.
Meeting intersect(const SurfaceTriangle& triangle, const glm::dvec3& origin, double originError,
                  const glm::dvec3& direction) {
    const glm::dvec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
    const glm::dvec3 p = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, p);
    const glm::dvec3 s = origin - triangle.a;
    const double lengthAb = magnitude(ab), lengthAc = magnitude(ac), lengthS = magnitude(s),
                 reach = magnitude(direction);
    const double detError = (rounding * reach + originError) * lengthAb * lengthAc;
    if (std::abs(determinant) <= detError) {
        // Seen edge-on: nothing is certain, unless the plane is far from the line.
        const double away = std::abs(glm::dot(s, glm::cross(ab, ac)));
        const bool clear =
            away > (rounding * lengthS + originError) * lengthAb * lengthAc && determinant == 0.0;
        return {infinity, -1.0, -1.0, 0.0, clear ? 0.0 : infinity, clear ? 0.0 : infinity};
    }
    const glm::dvec3 q = glm::cross(s, ab);
    const double t = glm::dot(ac, q) / determinant, u = glm::dot(s, p) / determinant,
                 v = glm::dot(direction, q) / determinant;
    const double usable = std::abs(determinant) - detError;
    const double cross = rounding * lengthS * reach + originError * (lengthS + reach);
    const double relative = detError / usable;
    return {t,
            u,
            v,
            (rounding * lengthS + originError) * lengthAb * lengthAc / usable +
                std::abs(t) * relative,
            cross * lengthAc / usable + std::abs(u) * relative,
            cross * lengthAb / usable + std::abs(v) * relative};
}

/// Whether `other` lies exactly in the plane of `surface`.
bool isCoplanar(const SurfaceTriangle& surface, const SurfaceTriangle& other) {
    const glm::dvec3 normal = normalOf(surface);
    return glm::dot(normal, other.a - surface.a) == 0.0 &&
           glm::dot(normal, other.b - surface.a) == 0.0 &&
           glm::dot(normal, other.c - surface.a) == 0.0;
}

/// Whether rounding could change the answer to whether `other` lies in the plane of `surface`.
bool isNearlyCoplanar(const SurfaceTriangle& surface, const SurfaceTriangle& other) {
    const glm::dvec3 normal = normalOf(surface);
    const double area = magnitude(surface.b - surface.a) * magnitude(surface.c - surface.a);
    for (const glm::dvec3& corner : {other.a, other.b, other.c}) {
        const glm::dvec3 offset = corner - surface.a;
        if (std::abs(glm::dot(normal, offset)) > rounding * area * magnitude(offset)) return false;
    }
    return true;
}

/// How far a point is within a cone, negative outside; `fromLight`: its position relative to the
/// light.
double depthInCone(const Cone& cone, const glm::dvec3& fromLight) {
    const double along = glm::dot(cone.axis, fromLight);
    const double aside = glm::length(glm::cross(cone.axis, fromLight));
    return std::sin(cone.outer) * along - std::cos(cone.outer) * aside;
}

} // namespace

PixelRay pixelRay(const Question& question, double x, double y) {
    const Frustum& frustum = question.frustum;
    const glm::dmat3 worldFromView = glm::transpose(glm::dmat3(frustum.viewFromWorld));
    const glm::dvec2 place(2.0 * x / question.width - 1.0, 1.0 - 2.0 * y / question.height);
    const glm::dvec2 window = frustum.windowAt(place);
    if (frustum.orthographic)
        return {worldFromView * glm::dvec3(window, 0.0), worldFromView * glm::dvec3(0, 0, -1)};
    return {glm::dvec3(0.0), worldFromView * glm::dvec3(window, -1.0)};
}

Oracle::Oracle(const Question& question, const AlphaLookup& alpha)
    : question_(question), position_(question.frustum.position()),
      eye_(fromPosition(question.frustum.eye())), alpha_(alpha),
      surfaces_(std::make_shared<const rays::SurfaceSet>(rays::surfaceTriangles(
          *question.scene, question.frustum, question.castMasked, question.cutoutsCast))) {
    findTouched();
}

void Oracle::findTouched() {
    const std::vector<Batch>& batches = question_.scene->batches;
    std::vector<Box> bounds(batches.size());
    for (std::size_t b = 0; b < batches.size(); ++b)
        bounds[b] = boundsOf(*batches[b].geometry);
    for (const Light& light : question_.lights) {
        std::vector<glm::dvec4>& places = lightInBatch_.emplace_back();
        std::vector<bool> reached;
        for (const Batch& batch : batches) {
            places.push_back(placeInObject(light, batch.worldFromBatch));
            const Geometry& geometry = *batch.geometry;
            reached.push_back(mayTouch(bounds[places.size() - 1], places.back()) &&
                              contactReachOf(geometry.positions, geometry.indices, places.back()) >
                                  0.0);
        }
        std::vector<std::uint32_t>& touched = touched_.emplace_back();
        for (std::uint32_t i = 0; i < triangles().size(); ++i) {
            const std::uint32_t batch = triangles()[i].batch;
            if (reached[batch] && touches(cornersInBatch(triangles()[i]), places[batch]))
                touched.push_back(i);
        }
    }
}

glm::dvec4 Oracle::fromPosition(const glm::dvec4& point) const {
    return {glm::dvec3(point) - position_ * point.w, point.w};
}

glm::dvec4 Oracle::lightFromEye(std::size_t light) const {
    return fromPosition(question_.lights[light].position);
}

double Oracle::eyeSide(const SurfaceTriangle& triangle) const {
    return glm::dot(normalOf(triangle), glm::dvec3(eye_) - triangle.a * eye_.w);
}

bool Oracle::blocks(std::uint32_t triangle, std::size_t light) const {
    return triangles()[triangle].casts && !std::ranges::binary_search(touched_[light], triangle);
}

bool Oracle::isGrazed(std::uint32_t triangle, std::size_t light) const {
    const SurfaceTriangle& surface = triangles()[triangle];
    return contactOf(cornersInBatch(surface), lightInBatch_[light][surface.batch]).grazes;
}

double Oracle::rangeOf(std::size_t light) const {
    return question_.lights[light].hasRange() ? question_.lights[light].range : infinity;
}

const Cone* Oracle::coneOf(std::size_t light) const {
    return question_.lights[light].isSpot() ? &*question_.lights[light].cone : nullptr;
}

bool Oracle::isCutOut(const SurfaceTriangle& triangle, double u, double v) const {
    return alpha_.cutsOut(question_.scene->materials, triangle, u, v);
}

bool Oracle::isHole(const SurfaceTriangle& triangle, double u, double v) const {
    return question_.cutoutsCast && isCutOut(triangle, u, v);
}

bool Oracle::isHoleAt(std::uint32_t triangle, const glm::dvec3& origin,
                      const glm::dvec3& direction) const {
    if (!question_.cutoutsCast) return false;
    const Meeting meeting = intersect(triangles()[triangle], origin, 0.0, direction);
    return isHole(triangles()[triangle], meeting.u, meeting.v);
}

bool Oracle::isCutOutByFilter(const SurfaceTriangle& triangle, double x, double y,
                              double depth) const {
    const Material& material = question_.scene->materials[triangle.material];
    if (material.alphaMode != AlphaMode::mask || !triangle.visible || !alpha_.range) return false;
    std::array<glm::dvec2, 3> places;
    const std::array<glm::dvec2, 3> points = {{{x, y}, {x + 1.0, y}, {x, y + 1.0}}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PixelRay ray = pixelRay(question_, points[i].x, points[i].y);
        const Meeting meeting = intersect(triangle, ray.origin, 0.0, ray.direction);
        if (i == 0 && (!meeting.inside() || meeting.t > depth)) return false;
        places[i] = {meeting.u, meeting.v};
    }
    const glm::vec2 range = alpha_.range(triangle, places);
    return range.x < material.alphaCutoff && range.y >= material.alphaCutoff;
}

std::optional<Oracle::Sighting> Oracle::sightingOf(std::uint32_t i, const PixelRay& ray) const {
    const SurfaceTriangle& triangle = triangles()[i];
    if (!triangle.visible) return std::nullopt;
    const Meeting meeting = intersect(triangle, ray.origin, 0.0, ray.direction);
    const bool hit = meeting.inside() && meeting.t >= question_.near &&
                     !isCutOut(triangle, meeting.u, meeting.v);
    // Texture filtering decides the edge of a cutout, and has no error bound.
    const bool certainPlace =
        meeting.certain() && std::abs(meeting.t - question_.near) > meeting.tError;
    const bool certain = certainPlace && question_.scene->materials[triangle.material].alphaMode ==
                                             AlphaMode::opaque;
    if (!hit && certain) return std::nullopt;
    return Sighting{{i, hit ? meeting.t : infinity, meeting.tError}, certain, certainPlace};
}

Oracle::First Oracle::firstAt(double x, double y) const {
    const PixelRay ray = pixelRay(question_, x, y);
    Hit nearest{0, infinity, 0.0};
    double second = infinity; // least possible depth of another surface
    bool certain = true, certainPlaces = true;
    surfaces_->tree.visitInOrder(ray.origin, ray.direction, [&](std::uint32_t i) {
        if (const std::optional<Sighting> seen = sightingOf(i, ray)) {
            const Hit& hit = seen->hit;
            certain = certain && seen->certain;
            certainPlaces = certainPlaces && seen->certainPlace;
            const bool closer =
                hit.depth < nearest.depth || (hit.depth == nearest.depth && i < nearest.triangle);
            const Hit& farther = closer ? nearest : hit;
            second = std::min(second, farther.depth - farther.error);
            if (closer) nearest = hit;
        }
        return nearest.depth + nearest.error;
    });
    if (!std::isfinite(nearest.depth)) return {std::nullopt, certain, certainPlaces};
    const bool isFirst = nearest.depth + nearest.error < second;
    return {nearest, certain && isFirst, certainPlaces && isFirst};
}

std::vector<std::uint32_t> Oracle::firstCandidates(double x, double y) const {
    struct Candidate {
        std::uint32_t triangle;
        double least; // depth
    };
    const PixelRay ray = pixelRay(question_, x, y);
    std::vector<Candidate> candidates;
    double most = infinity; // depth of the first surface
    surfaces_->tree.visitInOrder(ray.origin, ray.direction, [&](std::uint32_t i) {
        const SurfaceTriangle& triangle = triangles()[i];
        if (!triangle.visible) return most;
        const Meeting meeting = intersect(triangle, ray.origin, 0.0, ray.direction);
        const bool isPlaced = std::isfinite(meeting.t); // not seen edge-on
        const bool isMissed = meeting.certain() && !meeting.inside();
        const bool isTooNear = isPlaced && meeting.t + meeting.tError < question_.near;
        if (isMissed || isTooNear) return most;
        candidates.push_back({i, isPlaced ? meeting.t - meeting.tError : -infinity});
        if (meeting.certain() && meeting.t - meeting.tError > question_.near &&
            question_.scene->materials[triangle.material].alphaMode == AlphaMode::opaque)
            most = std::min(most, meeting.t + meeting.tError);
        return most;
    });
    std::vector<std::uint32_t> triangles;
    for (const Candidate& candidate : candidates)
        if (candidate.least <= most) triangles.push_back(candidate.triangle);
    std::ranges::sort(triangles);
    return triangles;
}

Oracle::Checked Oracle::checkedAt(double x, double y) const {
    const First first = firstAt(x, y);
    if (!first.hit) return {{}, first.certain};
    Checked checked = checkedOn(*first.hit, x, y);
    checked.certain = checked.certain && first.certain;
    return checked;
}

std::vector<Oracle::Hit> Oracle::surfacesAt(double x, double y) const {
    const PixelRay ray = pixelRay(question_, x, y);
    std::vector<Hit> hits;
    surfaces_->tree.visit(ray.origin, ray.direction, infinity, [&](std::uint32_t i) {
        const std::optional<Sighting> seen = sightingOf(i, ray);
        if (seen && std::isfinite(seen->hit.depth)) hits.push_back(seen->hit);
        return false;
    });
    return hits;
}

Oracle::Checked Oracle::checkedOn(const Hit& hit, double x, double y) const {
    const SurfaceTriangle& surface = triangles()[hit.triangle];
    const PixelRay ray = pixelRay(question_, x, y);
    const glm::dvec3 point = ray.at(hit.depth);
    const double pointError = (hit.error + rounding * hit.depth) * magnitude(ray.direction) +
                              rounding * magnitude(ray.origin);
    const glm::dvec3 normal = normalOf(surface);
    const double area = magnitude(surface.b - surface.a) * magnitude(surface.c - surface.a);
    const double eyeSide = this->eyeSide(surface);
    const double eyeReach = question_.frustum.orthographic ? 1.0 : magnitude(surface.a);
    Checked checked{{true, 0}, true};
    checked.certain = std::abs(eyeSide) > rounding * area * eyeReach;
    for (std::size_t i = 0; i < question_.lights.size(); ++i) {
        const glm::dvec4 light = lightFromEye(i);
        const glm::dvec3 towards = glm::dvec3(light) - surface.a * light.w;
        const double lightSide = glm::dot(normal, towards);
        const double reach = magnitude(glm::dvec3(light)) + magnitude(surface.a) * light.w;
        if (std::abs(lightSide) <= rounding * area * reach) checked.certain = false;
        const double distance = glm::length(glm::dvec3(light) - point * light.w);
        const double range = rangeOf(i);
        if (std::abs(distance - range) <= pointError + rounding * magnitude(glm::dvec3(light)))
            checked.certain = false;
        if (distance >= range) continue;
        if (const Cone* cone = coneOf(i)) {
            const double within = depthInCone(*cone, point - glm::dvec3(light));
            const double error = pointError + rounding * magnitude(glm::dvec3(light));
            if (std::abs(within) <= error + rounding * distance) checked.certain = false;
            if (within <= 0.0) continue;
        }
        const bool turnedAway = surface.casts && eyeSide * lightSide < 0.0;
        if (!turnedAway && !isGrazed(hit.triangle, i) &&
            !isBlocked(hit.triangle, point, pointError, i, checked.certain))
            checked.answer.lit.add(i);
    }
    return checked;
}

bool Oracle::isBlocked(std::uint32_t own, const glm::dvec3& point, double pointError,
                       std::size_t lightIndex, bool& certain) const {
    const glm::dvec4 light = lightFromEye(lightIndex);
    const glm::dvec3 towards = glm::dvec3(light) - point * light.w;
    const bool isDirectional = light.w == 0.0;
    const double directionError = isDirectional ? 0.0 : rounding * magnitude(glm::dvec3(light));
    bool blocked = false, surelyBlocked = false, sure = true;
    surfaces_->tree.visit(point, towards, isDirectional ? infinity : 1.0, [&](std::uint32_t i) {
        const SurfaceTriangle& other = triangles()[i];
        if (i == own || !blocks(i, lightIndex)) return false;
        const Meeting meeting = intersect(other, point, pointError + directionError, towards);
        const bool between = meeting.t > 0.0 && (isDirectional || meeting.t < 1.0);
        const bool surelyPlaced = std::abs(meeting.t) > meeting.tError &&
                                  (isDirectional || std::abs(meeting.t - 1.0) > meeting.tError);
        if (!meeting.certain() || (meeting.inside() && !surelyPlaced)) sure = false;
        if (!meeting.inside() || !between) return false;
        if (isHole(other, meeting.u, meeting.v)) {
            sure = false; // texture filtering decides a cutout's edge
            return false;
        }
        if (isNearlyCoplanar(triangles()[own], other)) {
            sure = false;
            blocked = blocked || !isCoplanar(triangles()[own], other);
            return false;
        }
        blocked = true;
        surelyBlocked = meeting.certain() && surelyPlaced;
        return surelyBlocked;
    });
    certain = certain && (surelyBlocked || sure);
    return blocked;
}

std::vector<std::uint32_t> Oracle::candidates(const glm::dvec3& origin, const glm::dvec3& direction,
                                              bool segment) const {
    std::vector<std::uint32_t> found;
    surfaces_->tree.visit(origin, direction, segment ? 1.0 : infinity, [&](std::uint32_t i) {
        found.push_back(i);
        return false;
    });
    return found;
}

bool Oracle::isOpen(const glm::dvec3& point, std::span<const std::uint32_t> own,
                    const glm::dvec3& direction) const {
    bool blocked = false;
    surfaces_->tree.visit(point, direction, infinity, [&](std::uint32_t i) {
        const SurfaceTriangle& other = triangles()[i];
        const auto isBeneath = [&](std::uint32_t surface) {
            return surface == i || isNearlyCoplanar(triangles()[surface], other);
        };
        if (!other.casts || std::ranges::any_of(own, isBeneath)) return false;
        const Meeting meeting = intersect(other, point, 0.0, direction);
        blocked = meeting.inside() && meeting.t > 0.0 && !isHole(other, meeting.u, meeting.v);
        return blocked;
    });
    return !blocked;
}

std::vector<Answer> traceAll(const Oracle& oracle) {
    return atAllPixels(oracle.question().width, oracle.question().height,
                       [&](double x, double y) { return oracle.at(x, y); });
}

} // namespace edgeshade::lab
