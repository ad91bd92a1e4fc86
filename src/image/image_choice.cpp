#include "src/image/image_choice.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/json_field.hpp"

#include <set>

namespace edgeshade {
namespace {

/// Materials that the scene's surfaces use.
std::set<std::size_t> usedMaterials(const Scene& scene) {
    std::set<std::size_t> used;
    for (const Batch& batch : scene.batches)
        for (const SurfaceGroup& group : batch.geometry->groups)
            used.insert(group.material);
    return used;
}

} // namespace

ImageChoice::ImageChoice(const GltfDocument& document, Scene& scene) : scene_(scene) {
    const std::size_t count = JsonField(document.path, document.json).countOf("textures");
    for (const std::size_t m : usedMaterials(scene)) {
        for (const MaterialTexture& used : scene.materials[m].textures) {
            const int texture = used.texture;
            if (texture < 0 || sources_.contains(texture)) continue;
            const auto index = static_cast<std::size_t>(texture);
            if (index < count)
                sources_[texture] = sourcesOf(document, index, scene.warnings);
            else
                scene.warnings.add(document.where("materials[") + std::to_string(m) +
                                   "] has the texture " + std::to_string(texture) +
                                   ", but there are " + std::to_string(count) +
                                   " textures; it is left out.");
        }
    }
}

std::vector<int> ImageChoice::wanted() const {
    std::set<int> wanted;
    for (const auto& [texture, sources] : sources_)
        if (!sources.empty() && !taken_.contains(sources.front())) wanted.insert(sources.front());
    return {wanted.begin(), wanted.end()};
}

void ImageChoice::decide(int image, const std::function<std::shared_ptr<const Image>()>& decode) {
    try {
        taken_[image] = decode();
    } catch (const LimitError&) {
        throw;
    } catch (const InputError& error) {
        scene_.warnings.add(clauseOf(error.what()) + "; it is left out.");
        for (auto& [texture, sources] : sources_)
            std::erase(sources, image);
    }
}

SceneImages ImageChoice::finish() {
    for (Material& material : scene_.materials)
        for (MaterialTexture& texture : material.textures) {
            const auto found = sources_.find(texture.texture);
            if (found != sources_.end() && !found->second.empty())
                texture.image = found->second.front();
        }
    std::erase_if(taken_, [](const auto& image) { return !image.second; });
    return std::move(taken_);
}

SceneImages decodeImages(const GltfDocument& document, Scene& scene) {
    MemoryBudget memory = document.memory;
    ImageChoice choice(document, scene);
    for (auto wanted = choice.wanted(); !wanted.empty(); wanted = choice.wanted())
        for (const int image : wanted)
            choice.decide(image, [&] {
                return std::make_shared<const Image>(decodeImage(document, image, memory));
            });
    return choice.finish();
}

} // namespace edgeshade
