#pragma once

#include "preprocess/base/file_io.hpp"

namespace edgeshade::desktop {

/// The current framebuffer as a PNG.
Bytes screenshotPng(int width, int height);

/// The first of edgeshade-1.png, edgeshade-2.png ... in the working directory that isn't there.
std::filesystem::path freeScreenshotName();

} // namespace edgeshade::desktop
