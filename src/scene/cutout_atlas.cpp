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

/// Places pictures in rows, tallest first.
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

/// The alpha of one image.
struct AlphaImage {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> alpha;

    explicit AlphaImage(const Image& image) : size(image.width, image.height) {
        for (std::size_t i = 3; i < image.rgba.size(); i += 4)
            alpha.push_back(image.rgba[i]);
    }

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(x);
    }

    /// Halves the size, averaging four texels each.
    void halve() {
        const AlphaImage whole = *this;
        size = glm::max(size / 2, glm::ivec2(1));
        alpha.resize(index(0, size.y));
        const auto at = [&](int x, int y) {
            return int{whole.alpha[whole.index(std::min(x, whole.size.x - 1),
                                               std::min(y, whole.size.y - 1))]};
        };
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const int sum = at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) + at(2 * x, 2 * y + 1) +
                                at(2 * x + 1, 2 * y + 1);
                alpha[index(x, y)] = static_cast<std::uint8_t>((sum + 2) / 4);
            }
    }
};

void copyAlpha(const AlphaImage& image, const glm::ivec2& place, CutoutAtlas& atlas) {
    for (int y = 0; y < image.size.y; ++y)
        std::copy_n(
            image.alpha.begin() + static_cast<std::ptrdiff_t>(image.index(0, y)), image.size.x,
            atlas.alpha.begin() + static_cast<std::ptrdiff_t>(place.y + y) * atlas.width + place.x);
}

using AlphaImages = std::map<int, AlphaImage>; ///< by the file's image index

AlphaImages alphaImagesOf(const LoadedScene& loaded) {
    AlphaImages images;
    for (const Material& material : loaded.scene.materials)
        if (const int image = material.baseColor().image;
            material.alphaMode == AlphaMode::mask && image >= 0 && !images.contains(image))
            images.emplace(image, AlphaImage(*pixelsOf(loaded, image)));
    return images;
}

/// Positions in the atlas, and its size.
struct Layout {
    std::map<int, glm::ivec2> places;
    glm::ivec2 size{1};

    Layout(const AlphaImages& images, int largest) {
        std::vector<std::pair<int, glm::ivec2>> byHeight;
        for (const auto& [index, image] : images) {
            byHeight.emplace_back(index, image.size);
            size.x = std::max(size.x, image.size.x);
        }
        if (images.size() > 1) size.x = std::max(size.x, std::min(widest, largest));
        std::stable_sort(byHeight.begin(), byHeight.end(),
                         [](const auto& a, const auto& b) { return a.second.y > b.second.y; });
        Shelves shelves(size.x);
        for (const auto& [index, of] : byHeight)
            places[index] = shelves.place(of);
        size.y = std::max(1, shelves.height());
    }
};

} // namespace

CutoutAtlas cutoutAtlasOf(const LoadedScene& loaded, int largest) {
    AlphaImages images = alphaImagesOf(loaded);
    Layout layout(images, largest);
    while (std::max(layout.size.x, layout.size.y) > largest) {
        for (auto& [index, image] : images)
            image.halve();
        layout = Layout(images, largest);
    }
    CutoutAtlas atlas;
    atlas.width = layout.size.x;
    atlas.height = layout.size.y;
    atlas.alpha.assign(
        static_cast<std::size_t>(atlas.width) * static_cast<std::size_t>(atlas.height), 255);
    for (const auto& [index, image] : images)
        copyAlpha(image, layout.places.at(index), atlas);
    for (const Material& material : loaded.scene.materials) {
        CutoutTexture& texture = atlas.textures.emplace_back();
        texture.cutoff = material.alphaCutoff;
        const MaterialTexture& base = material.baseColor();
        const auto image = images.find(base.image);
        if (image == images.end()) continue;
        texture.place = layout.places.at(base.image);
        texture.size = image->second.size;
        texture.wrapS = wrapOf(base.sampler.wrapS);
        texture.wrapT = wrapOf(base.sampler.wrapT);
        texture.linear = base.sampler.magFilter != nearest;
    }
    return atlas;
}

} // namespace edgeshade
