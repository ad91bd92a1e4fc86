#include "src/city/part_tree.hpp"

#include "preprocess/base/morton.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::city {
namespace {

constexpr double partWidth = 64.0; ///< metres, at least
constexpr double mostAlong = 16.0; ///< parts along a side of a source

} // namespace

std::vector<Part> partsOf(std::span<const CityTriangle> triangles, std::size_t source) {
    Box all;
    for (const CityTriangle& triangle : triangles)
        all.add(triangle.box());
    if (all.empty()) return {};
    const double width = std::max(
        {partWidth, (all.high.x - all.low.x) / mostAlong, (all.high.y - all.low.y) / mostAlong});
    const auto squareOf = [&](double middle, double low) {
        return static_cast<std::size_t>(
            std::clamp(std::floor((middle - low) / width), 0.0, mostAlong - 1.0));
    };
    std::vector<Part> squares(static_cast<std::size_t>(mostAlong * mostAlong));
    for (const CityTriangle& triangle : triangles) {
        const Box box = triangle.box();
        const glm::dvec3 middle = box.center();
        Part& part = squares[squareOf(middle.y, all.low.y) * static_cast<std::size_t>(mostAlong) +
                             squareOf(middle.x, all.low.x)];
        part.box.add(box);
        part.source = source;
        ++part.triangles;
    }
    std::erase_if(squares, [](const Part& part) { return part.triangles == 0; });
    return squares;
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
