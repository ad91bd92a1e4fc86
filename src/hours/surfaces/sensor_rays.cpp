#include "src/hours/surfaces/sensor_rays.hpp"

namespace edgeshade::hours {
namespace {

/// Light passes through surfaces that don't cast, but their sensors face one side.
void darkenBehind(const Sensor& sensor, std::span<const glm::dvec3> directions, std::size_t s,
                  rays::LitBits& bits) {
    for (std::size_t d = 0; d < directions.size(); ++d)
        if (glm::dot(sensor.normal, directions[d]) <= 0.0) bits.setDark(s, d);
}

} // namespace

SensorRays::SensorRays(const Scene& scene, bool castMasked, bool cutoutsCast, rays::IsHole isHole)
    : origin_(worldBounds(scene).center()),
      rays_(scene, rays::surfaceTriangles(scene, origin_, castMasked, cutoutsCast),
            std::move(isHole)) {
    for (const Batch& batch : scene.batches)
        numbers_.emplace_back(batch.geometry->indices.size() / 3, rays::SurfacePoint::none);
    for (std::uint32_t t = 0; t < rays_.triangles().size(); ++t) {
        const rays::SurfaceTriangle& triangle = rays_.triangles()[t];
        numbers_[triangle.batch][triangle.firstIndex / 3] = t;
    }
}

rays::LitBits SensorRays::lit(std::span<const Sensor> sensors,
                              std::span<const glm::dvec3> directions) const {
    std::vector<rays::SurfacePoint> points;
    points.reserve(sensors.size());
    for (const Sensor& sensor : sensors)
        points.push_back(
            rays::SurfacePoint::at(sensor.point - origin_, sensor.normal, numberOf(sensor)));
    rays::LitBits bits = rays_.lit(points, directions);
    for (std::size_t s = 0; s < sensors.size(); ++s)
        if (points[s].triangle != rays::SurfacePoint::none &&
            !rays_.triangles()[points[s].triangle].casts)
            darkenBehind(sensors[s], directions, s, bits);
    return bits;
}

std::uint32_t SensorRays::numberOf(const Sensor& sensor) const {
    return sensor.batch == Sensor::none ? rays::SurfacePoint::none
                                        : numbers_[sensor.batch][sensor.firstIndex / 3];
}

} // namespace edgeshade::hours
