#pragma once

#include "src/image/image_choice.hpp"
#include "src/scene/load.hpp"

#include <emscripten/val.h>
#include <optional>
#include <string>

namespace edgeshade::web {

/// The worker's half: reads a scene from files of the current folder of the file system in memory.
/// Images come in between, as fetching them and decoding WebP is the browser's:
///
///     read(name, variant, onStage)
///     while wantedImages() has some: for each of them
///         webpOf(image), where that has bytes roomFor(...) and the pixels into room()
///         decideImage(image, "")
///     finish(onStage)
///
/// Failures are returned as sentences, "" where all went well. `onStage` gets a stage's name.
class SceneReader {
  public:
    /// All but images and shadow data. `variant`: see flattenScene(); "" for the file's own
    /// materials.
    std::string read(const std::string& name, const std::string& variant, emscripten::val onStage);

    /// JSON, [{image, uri}]: images to decide on next. The uri is "" where no file is named.
    std::string wantedImages() const;

    /// The image's bytes where they are WebP and no animation; else there are none.
    emscripten::val webpOf(int image);

    /// Makes room for an image's pixels, RGBA, rows top to bottom.
    std::string roomFor(int image, int width, int height);
    emscripten::val room();

    /// Decides on an image: that the pixels in the room are its own, or, without a room, by
    /// decoding it. `problem`, a sentence unless "", says why it can't be had.
    std::string decideImage(int image, const std::string& problem);

    /// Shadow data, and what the page takes over.
    std::string finish(emscripten::val onStage);

    emscripten::val bytes() const; ///< see toTransfer()
    std::string warnings() const;  ///< JSON, an array of sentences
    std::string variants() const;  ///< JSON, an array of names
    std::string cameras() const;   ///< JSON, an array of {name, camera}: to orbit from
    std::size_t triangles() const { return loaded_.scene.triangleCount(); }

  private:
    std::string nameOfImage(int image) const;

    LoadedScene loaded_;
    std::optional<ImageChoice> choice_;
    MemoryBudget memory_;
    Bytes webp_;
    Image room_;
    Bytes bytes_;
};

} // namespace edgeshade::web
