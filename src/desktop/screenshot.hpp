#pragma once

#include "preprocess/base/file_io.hpp"

namespace edgeshade::desktop {

/// The current framebuffer as a PNG.
Bytes screenshotPng(int width, int height);

/// The first of edgeshade-1.png, edgeshade-2.png ... that doesn't exist in the working directory.
std::filesystem::path freeScreenshotName();

} // namespace edgeshade::desktop
