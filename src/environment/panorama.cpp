#include "src/environment/panorama.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgeshade {
namespace {

constexpr double pi = std::numbers::pi;

/// The row or column of the `to` cells that contains the `i`-th of the `from` source cells.
int cellOf(int i, int from, int to) {
    return static_cast<int>(std::int64_t{i} * to / from);
}

} // namespace

Panorama::Panorama(RadianceFile& file)
    : width_(std::min(file.width(), mostColumns)), height_(std::min(file.height(), mostRows)),
      texels_(index(0, height_), glm::vec3(0.0f)) {
    std::vector<std::size_t> cells;
    std::vector<int> columns(static_cast<std::size_t>(width_), 0); // source columns per cell
    for (int x = 0; x < file.width(); ++x) {
        cells.push_back(static_cast<std::size_t>(cellOf(x, file.width(), width_)));
        ++columns[cells.back()];
    }
    // double, as floats would overflow
    std::vector<glm::dvec3> sums(columns.size(), glm::dvec3(0.0));
    int rows = 0;
    for (int y = 0; y < file.height(); ++y) {
        const std::span<const glm::vec3> row = file.readRow();
        for (std::size_t x = 0; x < row.size(); ++x)
            sums[cells[x]] += glm::dvec3(row[x]);
        ++rows;
        const int cell = cellOf(y, file.height(), height_);
        if (cellOf(y + 1, file.height(), height_) == cell) continue;
        for (std::size_t x = 0; x < sums.size(); ++x)
            texels_[index(0, cell) + x] = glm::vec3(sums[x] / double(rows * columns[x]));
        std::fill(sums.begin(), sums.end(), glm::dvec3(0.0));
        rows = 0;
    }
}

glm::vec3 Panorama::direction(int x, int y) const {
    const double polar = pi * (y + 0.5) / height_;
    const double azimuth = 2.0 * pi * (x + 0.5) / width_ - pi; // from -Z towards +X
    return {std::sin(polar) * std::sin(azimuth), std::cos(polar),
            -std::sin(polar) * std::cos(azimuth)};
}

double Panorama::solidAngle(int y) const {
    const double heights = std::cos(pi * y / height_) - std::cos(pi * (y + 1) / height_);
    return 2.0 * pi / width_ * heights;
}

void Panorama::scale(double factor, double largest) {
    for (glm::vec3& texel : texels_)
        texel = glm::vec3(glm::min(glm::dvec3(texel) * factor, largest));
}

glm::vec3 Panorama::lookUp(const glm::vec3& direction) const {
    constexpr auto floatPi = static_cast<float>(pi);
    const float azimuth = std::atan2(direction.x, -direction.z);
    const float polar = std::acos(std::clamp(direction.y, -1.0f, 1.0f));
    const float column = (azimuth / (2.0f * floatPi) + 0.5f) * static_cast<float>(width_) - 0.5f;
    const float row = std::clamp(polar / floatPi * static_cast<float>(height_) - 0.5f, 0.0f,
                                 static_cast<float>(height_ - 1));
    const float left = std::floor(column);
    const int x0 = (static_cast<int>(left) + width_) % width_, x1 = (x0 + 1) % width_;
    const int y0 = static_cast<int>(row), y1 = std::min(y0 + 1, height_ - 1);
    const float across = column - left, down = row - static_cast<float>(y0);
    return glm::mix(glm::mix(at(x0, y0), at(x1, y0), across),
                    glm::mix(at(x0, y1), at(x1, y1), across), down);
}

} // namespace edgeshade
