#include "src/render/accumulation/direction_counts.hpp"

#include "src/render/accumulation/direction_masks.hpp"

#include <algorithm>

namespace edgeshade {

LitCounts countDirections(const LoadedScene& loaded, const FrameRequest& request,
                          std::span<const glm::dvec3> directions, Renderer& renderer,
                          GpuScene& scene, const gl::Capabilities& capabilities,
                          const std::function<void(double)>& progress) {
    const FrameView seen = makeFrameView(loaded.scene, request, worldBounds(loaded.scene));
    LitCounter counter(capabilities);
    counter.begin(request.width, request.height);
    if (directions.empty()) {
        // Draw one uncounted light, to find the pixels that show surfaces.
        const glm::dvec3 up(0.0, 1.0, 0.0);
        counter.add(renderer, scene, loaded, directionMasks(seen, loaded, {&up, 1}));
        gl::requireNoError("counting sun positions");
        LitCounts counts = counter.read();
        std::ranges::fill(counts.lit, std::uint16_t{0});
        counts.lights = 0;
        return counts;
    }
    constexpr std::size_t most = 32; // lights whose plans are held at once
    const std::size_t atOnce = std::min(LitCounter::lightsAtOnce(scene), most);
    for (std::size_t first = 0; first < directions.size();) {
        const std::size_t count = std::min(directions.size() - first, atOnce);
        counter.add(renderer, scene, loaded,
                    directionMasks(seen, loaded, directions.subspan(first, count)));
        first += count;
        progress(static_cast<double>(first) / static_cast<double>(directions.size()));
    }
    gl::requireNoError("counting sun positions");
    return counter.read();
}

} // namespace edgeshade
