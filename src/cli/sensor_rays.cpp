#include "src/cli/sensor_rays.hpp"

#include "preprocess/base/error.hpp"

#ifdef EDGESHADE_HAS_LAB
#include "src/lab/texture_alpha.hpp"
#include "src/rays/lit_rays.hpp"

#include <memory>
#endif

namespace edgeshade::cli {

#ifdef EDGESHADE_HAS_LAB

namespace {

rays::IsHole holesOf(const LoadedScene& loaded) {
    if (!loaded.cutoutsCast) return {};
    return [&materials = loaded.scene.materials, alpha = lab::textureAlpha(loaded)](
               const rays::SurfaceTriangle& triangle, double u, double v) {
        return alpha.cutsOut(materials, triangle, u, v);
    };
}

/// The rays of a scene, and the triangles that sensors are on.
class SensorRays {
  public:
    explicit SensorRays(const LoadedScene& loaded)
        : origin_(worldBounds(loaded.scene).center()),
          rays_(loaded.scene,
                rays::surfaceTriangles(loaded.scene, origin_, loaded.settings.castMasked,
                                       loaded.cutoutsCast),
                holesOf(loaded)) {
        for (const Batch& batch : loaded.scene.batches)
            numbers_.emplace_back(batch.geometry->indices.size() / 3, rays::SurfacePoint::none);
        for (std::uint32_t t = 0; t < rays_.triangles().size(); ++t) {
            const rays::SurfaceTriangle& triangle = rays_.triangles()[t];
            numbers_[triangle.batch][triangle.firstIndex / 3] = t;
        }
    }

    rays::LitBits lit(std::span<const hours::Sensor> sensors,
                      std::span<const glm::dvec3> directions) const {
        std::vector<rays::SurfacePoint> points;
        points.reserve(sensors.size());
        for (const hours::Sensor& sensor : sensors)
            points.push_back(
                rays::SurfacePoint::at(sensor.point - origin_, sensor.normal, numberOf(sensor)));
        rays::LitBits bits = rays_.lit(points, directions);
        for (std::size_t s = 0; s < sensors.size(); ++s)
            if (points[s].triangle != rays::SurfacePoint::none &&
                !rays_.triangles()[points[s].triangle].casts)
                darkenBehind(sensors[s], directions, s, bits);
        return bits;
    }

  private:
    std::uint32_t numberOf(const hours::Sensor& sensor) const {
        return sensor.batch == hours::Sensor::none ? rays::SurfacePoint::none
                                                   : numbers_[sensor.batch][sensor.firstIndex / 3];
    }

    /// Light passes through surfaces that don't cast, but their sensors face one side.
    static void darkenBehind(const hours::Sensor& sensor, std::span<const glm::dvec3> directions,
                             std::size_t s, rays::LitBits& bits) {
        for (std::size_t d = 0; d < directions.size(); ++d)
            if (glm::dot(sensor.normal, directions[d]) <= 0.0) bits.setDark(s, d);
    }

    glm::dvec3 origin_;
    rays::LitRays rays_;
    std::vector<std::vector<std::uint32_t>> numbers_; ///< in rays_, by batch and triangle
};

} // namespace

hours::SensorLight sensorLight(const LoadedScene& loaded) {
    return [rays = std::make_shared<SensorRays>(loaded)](std::span<const hours::Sensor> sensors,
                                                         std::span<const glm::dvec3> directions) {
        return rays->lit(sensors, directions);
    };
}

#else

hours::SensorLight sensorLight(const LoadedScene&) {
    throw Error(ExitStatus::unavailable,
                "sunhours --surfaces traces rays, but this program was built without Embree.");
}

#endif

} // namespace edgeshade::cli
