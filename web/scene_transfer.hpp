#pragma once

#include "preprocess/file_io.hpp"
#include "src/scene/load.hpp"

#include <span>

namespace edgeshade::web {

/// A loaded scene as bytes that another instance of this same program takes over with little more
/// than copying: a worker reads a file and finds its shadow data, the page draws. No file format;
/// never for bytes from elsewhere. Of the document only what drawing needs goes along: the images
/// in use, or everything where something is animated. Of `images` the page gets the pixels, for
/// formats that it has no decoder for. Throws InputError.
Bytes toTransfer(const LoadedScene& loaded);

/// The scene again.
LoadedScene fromTransfer(std::span<const std::uint8_t> bytes);

} // namespace edgeshade::web
