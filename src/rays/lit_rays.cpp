#include "src/rays/lit_rays.hpp"

#include "preprocess/base/vectors.hpp"
#include "src/rays/sun_packet.hpp"
#include "src/shadow/lights/light.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

namespace edgeshade::rays {
namespace {

/// Directions whose places in the batches' spaces are kept at once.
constexpr std::size_t directionsAtOnce = 256;
/// Packets that a thread takes at once.
constexpr std::size_t packetsAtOnce = 16;

/// The batches that points lie in.
struct UsedBatches {
    std::vector<std::uint32_t> slots; ///< by batch; without meaning for the others
    std::vector<glm::dmat4> inverses; ///< by slot, of their transforms

    UsedBatches(const Scene& scene, const std::vector<SurfaceTriangle>& triangles,
                std::span<const SurfacePoint> points)
        : slots(scene.batches.size(), 0) {
        std::vector<bool> used(slots.size(), false);
        for (const SurfacePoint& point : points)
            if (point.triangle != SurfacePoint::none) used[triangles[point.triangle].batch] = true;
        for (std::size_t b = 0; b < used.size(); ++b) {
            if (!used[b]) continue;
            slots[b] = static_cast<std::uint32_t>(inverses.size());
            inverses.push_back(glm::inverse(scene.batches[b].worldFromBatch));
        }
    }
};

/// A block of directions, in all spaces.
class SunDirections {
  public:
    SunDirections(std::span<const glm::dvec3> directions, const std::vector<glm::dmat4>& inverses) {
        inBatches_.reserve(directions.size() * inverses.size());
        for (const glm::dvec3& direction : directions)
            for (const glm::dmat4& inverse : inverses)
                inBatches_.push_back(
                    glm::dvec3(placeByInverse({glm::dvec4(direction, 0.0)}, inverse)));
        for (std::size_t i = 0; i < directions.size(); ++i)
            suns.push_back(
                {directions[i],
                 std::ldexp(1.0, -std::ilogb(largestComponent(directions[i])) - 1) * directions[i],
                 std::span(inBatches_).subspan(i * inverses.size(), inverses.size())});
    }
    SunDirections(const SunDirections&) = delete;
    SunDirections& operator=(const SunDirections&) = delete;

    std::vector<SunDirection> suns;

  private:
    std::vector<glm::dvec3> inBatches_;
};

} // namespace

LitRays::LitRays(const Scene& scene, std::vector<SurfaceTriangle> triangles, IsHole isHole)
    : LitRays(scene, std::make_shared<const SurfaceSet>(std::move(triangles)), std::move(isHole)) {}

LitRays::LitRays(const Scene& scene, std::shared_ptr<const SurfaceSet> surfaces, IsHole isHole)
    : scene_(&scene), surfaces_(std::move(surfaces)),
      holes_(scene, surfaces_->triangles, std::move(isHole)) {}

LitBits LitRays::lit(std::span<const SurfacePoint> points, std::span<const glm::dvec3> directions,
                     Threads threads, const std::function<void(double)>& progress) const {
    LitBits bits(points.size(), directions.size());
    const UsedBatches batches(*scene_, surfaces_->triangles, points);
    const std::size_t perPart = packetsAtOnce * packetSize;
    const std::size_t parts = (points.size() + perPart - 1) / perPart;
    const std::thread::id caller = std::this_thread::get_id();
    for (std::size_t first = 0; first < directions.size(); first += directionsAtOnce) {
        const SunDirections block(
            directions.subspan(first, std::min(directionsAtOnce, directions.size() - first)),
            batches.inverses);
        std::atomic<std::size_t> done = 0;
        inParallel(parts, threads, [&](std::size_t part) {
            const std::size_t end = std::min(points.size(), (part + 1) * perPart);
            for (std::size_t at = part * perPart; at < end; at += packetSize) {
                const std::size_t count = std::min(packetSize, end - at);
                SunPacket packet(*surfaces_, holes_, points.subspan(at, count), batches.slots);
                for (std::size_t d = 0; d < block.suns.size(); ++d) {
                    const Lanes lit = packet.lit(block.suns[d]);
                    for (std::size_t i = 0; i < count; ++i)
                        if ((lit >> i & 1) != 0) bits.setLit(at + i, first + d);
                }
            }
            const double share = static_cast<double>(++done) / static_cast<double>(parts);
            if (progress && std::this_thread::get_id() == caller)
                progress(
                    (static_cast<double>(first) + share * static_cast<double>(block.suns.size())) /
                    static_cast<double>(directions.size()));
        });
    }
    return bits;
}

} // namespace edgeshade::rays
