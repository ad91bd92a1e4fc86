#include "tests/support/brute_force.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::test {
namespace {

/// The square of a vector's length.
double squared(const glm::dvec3& v) {
    return glm::dot(v, v);
}

struct Ray {
    glm::dvec3 origin, direction;
    double squaredLength = squared(direction);
};

struct WorldTriangle {
    glm::dvec3 a, b, c;
    bool casts;
    bool visible;
    bool frontAlone; ///< visible only from its front
    bool mirrored;   ///< its placement reverses its winding
    glm::dvec3 centre = (a + b + c) / 3.0;
    double squaredRadius =
        std::max({squared(a - centre), squared(b - centre), squared(c - centre)});

    /// Whether a ray along the direction meets its back, which is invisible.
    bool isCulled(const glm::dvec3& direction) const {
        const double along = glm::dot(glm::cross(b - a, c - a), direction);
        return frontAlone && (mirrored ? along < 0.0 : along > 0.0);
    }

    /// Whether the ray's line surely passes by, as most do.
    bool isPassedBy(const Ray& ray) const {
        const glm::dvec3 to = centre - ray.origin;
        return squared(glm::cross(to, ray.direction)) >
               (1.001 * squaredRadius + 1e-12 * squared(to)) * ray.squaredLength;
    }
};

std::vector<WorldTriangle> worldTriangles(const Scene& scene, bool castMasked) {
    std::vector<WorldTriangle> triangles;
    for (const Batch& batch : scene.batches)
        for (const SurfaceGroup& group : batch.geometry->groups) {
            const Material& material = scene.materials[group.material];
            const bool opaque = material.alphaMode == AlphaMode::opaque;
            const bool solid = material.alphaMode == AlphaMode::mask &&
                               material.baseColorFactor.a >= material.alphaCutoff;
            for (std::uint32_t i = 0; i < group.indexCount; i += 3) {
                glm::dvec3 p[3];
                for (std::uint32_t c = 0; c < 3; ++c)
                    p[c] = glm::dvec3(
                        batch.worldFromBatch *
                        glm::dvec4(
                            batch.geometry
                                ->positions[batch.geometry->indices[group.firstIndex + i + c]],
                            1.0));
                triangles.push_back({p[0], p[1], p[2], !batch.ground && (opaque || castMasked),
                                     opaque || solid, scene.culls && !material.doubleSided,
                                     glm::determinant(glm::dmat3(batch.worldFromBatch)) < 0.0});
            }
        }
    return triangles;
}

/// Parameter t of the hit on origin + t * direction, or a negative number (Moeller, Trumbore).
double hit(const WorldTriangle& triangle, const Ray& ray) {
    if (triangle.isPassedBy(ray)) return -1.0;
    const auto& [origin, direction, squaredLength] = ray;
    const glm::dvec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    const glm::dvec3 p = glm::cross(direction, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant == 0.0) return -1.0;
    const glm::dvec3 s = origin - triangle.a;
    const double u = glm::dot(s, p) / determinant;
    const glm::dvec3 q = glm::cross(s, e1);
    const double v = glm::dot(direction, q) / determinant;
    if (u < 0.0 || v < 0.0 || u + v > 1.0) return -1.0;
    return glm::dot(e2, q) / determinant;
}

double planeSide(const WorldTriangle& triangle, const glm::dvec4& point) {
    const glm::dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
    return glm::dot(normal, glm::dvec3(point) - triangle.a * point.w);
}

bool isLit(const std::vector<WorldTriangle>& triangles, std::size_t own, const glm::dvec3& point,
           const glm::dvec3& eye, const glm::dvec4& light) {
    const WorldTriangle& surface = triangles[own];
    if (surface.casts &&
        planeSide(surface, glm::dvec4(eye, 1.0)) * planeSide(surface, light) <= 0.0)
        return false;
    const Ray towards{point, glm::dvec3(light) - point * light.w};
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i == own || !triangles[i].casts) continue;
        const double t = hit(triangles[i], towards);
        if (t > 1e-12 && (light.w == 0.0 || t < 1.0)) return false;
    }
    return true;
}

/// Whether the point is within a spot's cone, by the angle from its axis.
bool isInCone(const Light& light, const glm::dvec3& point) {
    if (!light.isSpot()) return true;
    const glm::dvec3 from = point - glm::dvec3(light.position), &axis = light.cone->axis;
    return std::atan2(glm::length(glm::cross(axis, from)), glm::dot(axis, from)) <
           light.cone->outer;
}

} // namespace

std::vector<Answer> castMask(const Scene& scene, const Frustum& frustum, const Light& light,
                             int width, int height, double near, bool castMasked) {
    const auto triangles = worldTriangles(scene, castMasked);
    const glm::dmat4 worldFromView = glm::inverse(frustum.viewFromWorld);
    const bool parallel = frustum.orthographic;
    std::vector<Answer> answers;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec2 window =
                frustum.windowAt({2.0 * (x + 0.5) / width - 1.0, 1.0 - 2.0 * (y + 0.5) / height});
            const glm::dvec3 origin(worldFromView *
                                    glm::dvec4(parallel ? window : glm::dvec2(0.0), 0.0, 1.0));
            const glm::dvec3 direction =
                glm::dmat3(worldFromView) * glm::dvec3(parallel ? glm::dvec2(0.0) : window, -1.0);
            const Ray ray{origin, direction};
            double nearest = INFINITY;
            std::size_t own = 0;
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                const double t = hit(triangles[i], ray);
                if (t >= near && t < nearest && triangles[i].visible &&
                    !triangles[i].isCulled(direction)) {
                    nearest = t;
                    own = i;
                }
            }
            if (!std::isfinite(nearest)) {
                answers.push_back(Answer::nothing);
                continue;
            }
            const glm::dvec3 point = origin + nearest * direction;
            const bool reached = isInCone(light, point) &&
                                 (!light.hasRange() ||
                                  glm::distance(point, glm::dvec3(light.position)) < light.range);
            const glm::dvec3 eye = parallel ? point - direction : origin;
            answers.push_back(reached && isLit(triangles, own, point, eye, light.position)
                                  ? Answer::lit
                                  : Answer::shadow);
        }
    return answers;
}

std::vector<Answer> castMask(const Scene& scene, const Camera& camera, const Light& light,
                             int width, int height, double near, bool castMasked) {
    return castMask(scene, frustumOf(camera, static_cast<double>(width) / height), light, width,
                    height, near, castMasked);
}

bool isFlat(const std::vector<Answer>& answers, int width, int height, int x, int y) {
    const auto at = [&](int px, int py) {
        return answers[static_cast<std::size_t>(py) * width + px];
    };
    for (int py = std::max(0, y - 1); py <= std::min(height - 1, y + 1); ++py)
        for (int px = std::max(0, x - 1); px <= std::min(width - 1, x + 1); ++px)
            if (at(px, py) != at(x, y)) return false;
    return true;
}

} // namespace edgeshade::test
