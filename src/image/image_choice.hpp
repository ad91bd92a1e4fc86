#pragma once

#include "preprocess/reading/texture_sources.hpp"
#include "preprocess/scene/scene.hpp"
#include "src/image/decode.hpp"
#include "src/image/scene_images.hpp"

#include <functional>

namespace edgeshade {

/// Decides which images a scene is drawn with: of each texture that its surfaces sample the best
/// one that can be decoded. Others of the file are never asked for.
///
///     ImageChoice choice(document, scene);
///     for (auto wanted = choice.wanted(); !wanted.empty(); wanted = choice.wanted())
///         for (int image : wanted)
///             choice.decide(image, decode);
///     images = choice.finish();
class ImageChoice {
  public:
    /// The scene, which gets the warnings, must outlive this. Safe on untrusted input.
    ImageChoice(const GltfDocument& document, Scene& scene);

    /// Images to decode next, each once; none: all is decided.
    std::vector<int> wanted() const;

    /// Takes a wanted one as `decode` gives it; null: it can be decoded, but nobody here needs its
    /// pixels. Where that throws an InputError, it is left out with a warning. Throws LimitError.
    void decide(int image, const std::function<std::shared_ptr<const Image>()>& decode);

    /// Sets the materials' images. Returns those whose pixels were taken.
    SceneImages finish();

  private:
    Scene& scene_;
    std::map<int, std::vector<int>> sources_; ///< by texture, those not refused, best first
    SceneImages taken_;
};

/// Reads and decodes them all. Throws LimitError where they pass what the document may still take.
SceneImages decodeImages(const GltfDocument& document, Scene& scene);

} // namespace edgeshade
