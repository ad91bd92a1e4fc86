#pragma once

#include "preprocess/reading/texture_sources.hpp"
#include "preprocess/scene/scene.hpp"
#include "src/image/decode.hpp"
#include "src/image/scene_images.hpp"

#include <functional>

namespace edgeshade {

/// Chooses the images that a scene is drawn with: for each texture that its surfaces sample, the
/// best image that can be decoded. Other images of the file are never decoded.
///
///     ImageChoice choice(document, scene);
///     for (auto wanted = choice.wanted(); !wanted.empty(); wanted = choice.wanted())
///         for (int image : wanted)
///             choice.decide(image, decode);
///     images = choice.finish();
class ImageChoice {
  public:
    /// The scene gets the warnings, and must outlive this. Safe on untrusted input.
    ImageChoice(const GltfDocument& document, Scene& scene);

    /// Images to decode next, each once; empty when all are decided.
    std::vector<int> wanted() const;

    /// Decodes a wanted image by `decode`, which returns null if the image can be decoded but its
    /// pixels aren't needed here. If it throws InputError, the image is left out with a warning.
    /// Throws LimitError.
    void decide(int image, const std::function<std::shared_ptr<const Image>()>& decode);

    /// Sets the materials' images. Returns those with pixels.
    SceneImages finish();

  private:
    Scene& scene_;
    std::map<int, std::vector<int>> sources_; ///< by texture: images not refused, best first
    SceneImages taken_;
};

/// Reads and decodes all images. Throws LimitError beyond the document's remaining limits.
SceneImages decodeImages(const GltfDocument& document, Scene& scene);

} // namespace edgeshade
