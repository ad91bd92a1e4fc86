#include "src/city/part_tree.hpp"

#include "preprocess/base/morton.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::city {
namespace {

constexpr double partWidth = 64.0;    ///< metres, at least
constexpr std::size_t mostAlong = 16; ///< parts along a side of a source

} // namespace

PartSquares::PartSquares(std::span<const CityTriangle> triangles) {
    for (const CityTriangle& triangle : triangles)
        all_.add(triangle.box());
    if (all_.empty()) return;
    width_ = std::max({partWidth, (all_.high.x - all_.low.x) / static_cast<double>(mostAlong),
                       (all_.high.y - all_.low.y) / static_cast<double>(mostAlong)});
}

std::size_t PartSquares::count() const {
    return mostAlong * mostAlong;
}

std::size_t PartSquares::squareOf(const Box& triangle) const {
    const auto along = [&](double middle, double low) {
        return static_cast<std::size_t>(std::clamp(std::floor((middle - low) / width_), 0.0,
                                                   static_cast<double>(mostAlong - 1)));
    };
    const glm::dvec3 middle = triangle.center();
    return along(middle.y, all_.low.y) * mostAlong + along(middle.x, all_.low.x);
}

std::vector<Part> partsOf(std::span<const CityTriangle> triangles, std::size_t source) {
    const PartSquares squares(triangles);
    std::vector<Part> parts(squares.count());
    for (const CityTriangle& triangle : triangles) {
        const Box box = triangle.box();
        Part& part = parts[squares.squareOf(box)];
        part.box.add(box);
        part.source = source;
        ++part.triangles;
    }
    std::erase_if(parts, [](const Part& part) { return part.triangles == 0; });
    return parts;
}

PartTree::PartTree(std::vector<Part> parts) : parts_(std::move(parts)), boxes_(parts_.size()) {
    Box all;
    for (const Part& part : parts_)
        all.add(part.box);
    std::ranges::stable_sort(parts_, {},
                             [&](const Part& part) { return mortonCode(part.box.center(), all); });
    for (std::size_t i = 0; i < parts_.size(); ++i)
        boxes_.set(i, parts_[i].box.low, parts_[i].box.high);
    boxes_.fit();
}

} // namespace edgeshade::city
