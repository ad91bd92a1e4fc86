#pragma once

#include "src/image/image_choice.hpp"
#include "src/scene/load.hpp"

#include <emscripten/val.h>
#include <optional>
#include <string>

namespace edgeshade::web {

/// The worker's side: reads a scene from files in the current folder of the file system in memory.
/// Images are handled in between, as the browser fetches them and decodes WebP:
///
///     read(name, variant, onStage)
///     while wantedImages() has some: for each of them
///         if webpOf(image) has bytes, roomFor(...), then the pixels into room()
///         decideImage(image, "")
///     finish(onStage)
///
/// Failures are returned as sentences, "" for success. `onStage` gets a stage's name.
class SceneReader {
  public:
    /// Reads everything except images and shadow data. `variant`: see flattenScene(); "" for the
    /// file's own materials.
    std::string read(const std::string& name, const std::string& variant, emscripten::val onStage);

    /// JSON, [{image, uri}]: the next images to decide on. The uri is "" if no file is named.
    std::string wantedImages() const;

    /// The image's bytes if they are WebP without animation; else empty.
    emscripten::val webpOf(int image);

    /// Makes room for an image's pixels, RGBA, rows top to bottom.
    std::string roomFor(int image, int width, int height);
    emscripten::val room();

    /// Decides on an image: the pixels in the room are its own or, without a room, it is decoded.
    /// `problem`, a sentence unless "", says why it can't be had.
    std::string decideImage(int image, const std::string& problem);

    /// Builds the shadow data, and the bytes for the page.
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
