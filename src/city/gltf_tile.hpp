#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "src/city/city_tile.hpp"

namespace edgeshade::city {

/// glTF's axes, +Y up and -Z north, to metres east, north and up.
inline constexpr glm::dmat4 eastNorthUpFromGltf{
    {1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}};

/// The triangles of a glTF scene at rest. Every node with triangles is an object, by its name.
/// `frameFromGltf`: to the plan's frame. Throws InputError.
CityTile tileFromGltf(const GltfDocument& document, const glm::dmat4& frameFromGltf);

/// The GLB inside of a b3dm. `relativeTo`: set to its RTC_CENTER, if it has one. Throws InputError.
std::span<const std::uint8_t> glbOfB3dm(std::span<const std::uint8_t> bytes,
                                        const std::filesystem::path& path, glm::dvec3& relativeTo);

} // namespace edgeshade::city
