#include "src/cli/scene_hash.hpp"

#include <cstdio>
#include <glm/gtc/type_ptr.hpp>
#include <span>

namespace edgeshade::cli {

std::string hashOf(const Scene& scene) {
    std::uint64_t hash = 0xCBF29CE484222325;
    const auto add = [&hash](const auto& values) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
        for (std::size_t i = 0; i < values.size() * sizeof(values[0]); ++i)
            hash = (hash ^ bytes[i]) * 0x100000001B3;
    };
    for (const Batch& batch : scene.batches) {
        const double* matrix = glm::value_ptr(batch.worldFromBatch);
        add(std::span(matrix, 16));
        add(batch.geometry->positions);
        add(batch.geometry->indices);
    }
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

} // namespace edgeshade::cli
