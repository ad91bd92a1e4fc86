#include "src/environment/reading.hpp"

#include "preprocess/base/error.hpp"
#include "src/environment/panorama.hpp"
#include "src/environment/radiance_pyramid.hpp"
#include "src/environment/resampling.hpp"
#include "src/environment/specular_lobe.hpp"

#include <numbers>

namespace edgeshade {
namespace {

/// The largest file: for all texels an RGBE pixel with a code in front of it, and a header.
constexpr std::uint64_t mostFileBytes =
    std::uint64_t{8} * RadianceFile::largest * RadianceFile::largest + (1 << 20);

DiffuseSum diffuseOf(const Panorama& panorama) {
    DiffuseSum sum;
    for (int y = 0; y < panorama.height(); ++y)
        for (int x = 0; x < panorama.width(); ++x)
            sum.add(panorama.direction(x, y), panorama.at(x, y), panorama.solidAngle(y));
    return sum;
}

Atlas filteredByRoughness(const RadiancePyramid& pyramid) {
    const auto lookUp = [&](const glm::vec3& direction, float solidAngle) {
        return pyramid.lookUp(direction, solidAngle);
    };
    OctahedralMap mirror(Atlas::mapSize(0));
    const auto size = static_cast<float>(mirror.size());
    const float texel = 4.0f * std::numbers::pi_v<float> / (size * size);
    mirror.fill([&](const glm::vec3& direction) { return lookUp(direction, texel); });
    Atlas atlas(mirror.largest());
    atlas.setLevel(0, mirror);
    for (int level = 1; level < Atlas::levels(); ++level) {
        const SpecularLobe lobe(Atlas::roughness(level), level < 3 ? 64 : 256);
        OctahedralMap map(Atlas::mapSize(level));
        map.fill([&](const glm::vec3& direction) { return lobe.filter(direction, lookUp); });
        atlas.setLevel(level, map);
    }
    return atlas;
}

} // namespace

Environment readEnvironment(const std::filesystem::path& path, EnvironmentScale scale) {
    return readEnvironment(readFile(path, mostFileBytes), "'" + path.string() + "'", scale);
}

Environment readEnvironment(std::span<const std::uint8_t> bytes, const std::string& name,
                            EnvironmentScale scale) {
    constexpr glm::dvec3 luminance(0.2126, 0.7152, 0.0722); // IEC 61966-2-1
    constexpr double largest = 1 << 24;                     // floats can still hold sums of it
    RadianceFile file(bytes, name);
    Panorama panorama(file);
    const double mean = glm::dot(diffuseOf(panorama).mean(), luminance);
    if (mean == 0.0) throw InputError(name + " is black all over.");
    panorama.scale(scale == EnvironmentScale::meanOne ? 1.0 / mean : 1.0, largest);
    constexpr int size = 512; // its texels are about as large as those of the largest panorama
    const RadiancePyramid pyramid(octahedralFromPanorama(panorama, size));
    return {diffuseOf(panorama).coefficients(), filteredByRoughness(pyramid)};
}

} // namespace edgeshade
