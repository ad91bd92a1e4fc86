#include "src/cli/scene_hash.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/sha256.hpp"
#include "preprocess/gltf/gltf_document.hpp"

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

nlohmann::ordered_json filesJson(const GltfDocument& document, std::uint64_t mostBytes) {
    nlohmann::ordered_json files = {{{"name", document.path.filename().string()},
                                     {"sha256", sha256(readFile(document.path, mostBytes))}}};
    for (const char* items : {"buffers", "images"}) {
        const auto found = document.json.find(items);
        if (found == document.json.end()) continue;
        for (const auto& item : *found) {
            if (!item.is_object() || !item.contains("uri") || !item["uri"].is_string()) continue;
            const auto uri = item["uri"].get<std::string>();
            if (uri.starts_with("data:")) continue;
            try {
                files.push_back(
                    {{"name", uri}, {"sha256", sha256(resolveUri(document, items, uri))}});
            } catch (const InputError&) {
                continue; // reading has said so
            }
        }
    }
    return files;
}

} // namespace edgeshade::cli
