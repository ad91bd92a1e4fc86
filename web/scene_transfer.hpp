#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/scene/load.hpp"

#include <span>

namespace edgeshade::web {

/// A loaded scene as bytes that another instance of this same program takes over with little more
/// than copying: a worker reads a file and finds its shadow data, the page draws. This is no file
/// format; never use it for bytes from elsewhere. Only the parts of the document that drawing needs
/// are included: the images in use, or everything if something is animated. `images` passes pixels
/// to the page for formats that it can't decode. Throws InputError.
Bytes toTransfer(const LoadedScene& loaded);

/// The scene, restored.
LoadedScene fromTransfer(std::span<const std::uint8_t> bytes);

} // namespace edgeshade::web
