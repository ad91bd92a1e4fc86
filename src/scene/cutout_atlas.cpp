#include "src/scene/cutout_atlas.hpp"

#include <algorithm>
#include <map>

namespace edgeshade {
namespace {

constexpr int widest = 4096;

constexpr int clampToEdge = 33071, mirroredRepeat = 33648, nearest = 9728;

CutoutWrap wrapOf(int mode) {
    return mode == clampToEdge      ? CutoutWrap::clamp
           : mode == mirroredRepeat ? CutoutWrap::mirror
                                    : CutoutWrap::repeat;
}

/// Puts pictures in rows, the highest first.
class Shelves {
  public:
    explicit Shelves(int width) : width_(width) {}

    glm::ivec2 place(const glm::ivec2& size) {
        if (at_.x + size.x > width_) {
            at_ = {0, at_.y + height_};
            height_ = 0;
        }
        const glm::ivec2 placed = at_;
        at_.x += size.x;
        height_ = std::max(height_, size.y);
        return placed;
    }
    int height() const { return at_.y + height_; }

  private:
    int width_;
    glm::ivec2 at_{0};
    int height_ = 0; ///< of the row
};

glm::ivec2 sizeOf(const Image& image) {
    return {image.width, image.height};
}

void copyAlpha(const Image& image, const glm::ivec2& place, CutoutAtlas& atlas) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto from = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(x);
            const auto to =
                static_cast<std::size_t>(place.y + y) * static_cast<std::size_t>(atlas.width) +
                static_cast<std::size_t>(place.x + x);
            atlas.alpha[to] = image.rgba[4 * from + 3];
        }
}

} // namespace

std::optional<CutoutAtlas> cutoutAtlasOf(const LoadedScene& loaded, int largest) {
    std::map<int, std::shared_ptr<const Image>> images;
    for (const Material& material : loaded.scene.materials)
        if (const int image = material.baseColor().image;
            material.alphaMode == AlphaMode::mask && image >= 0 && !images.contains(image))
            images.emplace(image, pixelsOf(loaded, image));
    std::vector<std::pair<int, const Image*>> byHeight;
    CutoutAtlas atlas;
    for (const auto& [index, image] : images) {
        byHeight.emplace_back(index, image.get());
        atlas.width = std::max(atlas.width, image->width);
    }
    if (images.size() > 1) atlas.width = std::max(atlas.width, std::min(widest, largest));
    std::stable_sort(byHeight.begin(), byHeight.end(), [](const auto& a, const auto& b) {
        return a.second->height > b.second->height;
    });
    std::map<int, glm::ivec2> places;
    Shelves shelves(atlas.width);
    for (const auto& [index, image] : byHeight)
        places[index] = shelves.place(sizeOf(*image));
    atlas.height = std::max(1, shelves.height());
    if (std::max(atlas.width, atlas.height) > largest) return std::nullopt;
    atlas.alpha.assign(
        static_cast<std::size_t>(atlas.width) * static_cast<std::size_t>(atlas.height), 255);
    for (const auto& [index, image] : byHeight)
        copyAlpha(*image, places.at(index), atlas);
    for (const Material& material : loaded.scene.materials) {
        CutoutTexture& texture = atlas.textures.emplace_back();
        texture.cutoff = material.alphaCutoff;
        const MaterialTexture& base = material.baseColor();
        const auto image = images.find(base.image);
        if (image == images.end()) continue;
        texture.place = places.at(base.image);
        texture.size = sizeOf(*image->second);
        texture.wrapS = wrapOf(base.sampler.wrapS);
        texture.wrapT = wrapOf(base.sampler.wrapT);
        texture.linear = base.sampler.magFilter != nearest;
    }
    return atlas;
}

} // namespace edgeshade
