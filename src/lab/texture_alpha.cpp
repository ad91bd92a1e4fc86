#include "src/lab/texture_alpha.hpp"

#include <cmath>
#include <memory>

namespace edgeshade::lab {
namespace {

/// The texel that a coordinate falls on, repeated beyond 0..1.
int texelOf(double coordinate, int size) {
    const double wrapped = coordinate - std::floor(coordinate);
    if (!std::isfinite(wrapped)) return 0;
    return std::min(size - 1, static_cast<int>(wrapped * size));
}

} // namespace

AlphaAt textureAlpha(const LoadedScene& loaded) {
    const auto images = std::make_shared<SceneImages>();
    for (const Material& material : loaded.scene.materials)
        if (material.alphaMode == AlphaMode::mask && material.image >= 0 &&
            !images->contains(material.image))
            images->emplace(material.image, pixelsOf(loaded, material.image));
    const Scene* scene = &loaded.scene;
    return [images, scene](const EyeTriangle& triangle, double u, double v) {
        const Material& material = scene->materials[triangle.material];
        const Batch& batch = scene->batches[triangle.batch];
        const auto blend = [&](const auto& values) {
            const auto at = [&](std::uint32_t c) {
                return values[batch.indices[triangle.firstIndex + c]];
            };
            return at(0) * static_cast<float>(1.0 - u - v) + at(1) * static_cast<float>(u) +
                   at(2) * static_cast<float>(v);
        };
        const float factor = material.baseColorFactor.a * blend(batch.colors).a;
        const auto image = images->find(material.image);
        if (image == images->end()) return factor;
        const glm::vec2 uv = blend(batch.texcoords);
        const Image& texels = *image->second;
        const std::size_t x = texelOf(uv.x, texels.width);
        const std::size_t y = texelOf(uv.y, texels.height);
        return factor * texels.rgba[4 * (y * texels.width + x) + 3] / 255.0f;
    };
}

} // namespace edgeshade::lab
