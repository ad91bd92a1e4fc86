#include "src/desktop/screenshot.hpp"

#include "src/gl/objects.hpp"
#include "src/image/png.hpp"

#include <algorithm>
#include <GLES2/gl2.h>
#include <string>

namespace edgeshade::desktop {

Bytes screenshotPng(int width, int height) {
    const std::size_t stride = std::size_t{4} * static_cast<std::size_t>(width);
    Bytes upwards(stride * static_cast<std::size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upwards.data());
    gl::requireNoError("reading the picture");
    Bytes downwards;
    downwards.reserve(upwards.size());
    for (auto row = upwards.end(); row != upwards.begin(); row -= static_cast<long>(stride))
        downwards.insert(downwards.end(), row - static_cast<long>(stride), row);
    return encodePng(downwards, width, height);
}

std::filesystem::path freeScreenshotName() {
    for (int number = 1;; ++number) {
        const std::filesystem::path path = "edgeshade-" + std::to_string(number) + ".png";
        if (!std::filesystem::exists(path)) return path;
    }
}

} // namespace edgeshade::desktop
