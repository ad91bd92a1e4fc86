#pragma once

#include "src/hours/surfaces/cells.hpp"

#include <span>

namespace edgeshade::hours {

/// Cells and their scene as plain arrays, for files; they hold all that results are made from.
struct CellArrays {
    // The scene's triangles.
    std::vector<double> corners; ///< 9 a triangle: a, b, c
    std::vector<std::uint32_t> node, material;
    std::vector<std::uint8_t> chosen; ///< 1: of SurfaceCells::triangles, in that order
    // Cells.
    std::vector<double> point, normal; ///< 3 a cell
    std::vector<double> area;
    std::vector<std::uint32_t> triangle, firstFace, faceCount;
    std::vector<std::uint8_t> state;
    // Faces, and their corners, 3 numbers each.
    std::vector<std::uint32_t> firstCorner, cornerCount;
    std::vector<double> faceCorners;
};

/// An array of CellArrays, as files and messages name it.
struct ArrayName {
    const char* group;      ///< "cells"
    const char* element;    ///< "cell"
    const char* member;     ///< "point"
    std::size_t components; ///< numbers of an element
};

/// Calls use(ArrayName, pointer to the member) for each array.
template <class Use>
void forEachArray(const Use& use) {
    use(ArrayName{"triangles", "triangle", "corners", 9}, &CellArrays::corners);
    use(ArrayName{"triangles", "triangle", "node", 1}, &CellArrays::node);
    use(ArrayName{"triangles", "triangle", "material", 1}, &CellArrays::material);
    use(ArrayName{"triangles", "triangle", "chosen", 1}, &CellArrays::chosen);
    use(ArrayName{"cells", "cell", "point", 3}, &CellArrays::point);
    use(ArrayName{"cells", "cell", "normal", 3}, &CellArrays::normal);
    use(ArrayName{"cells", "cell", "area", 1}, &CellArrays::area);
    use(ArrayName{"cells", "cell", "triangle", 1}, &CellArrays::triangle);
    use(ArrayName{"cells", "cell", "first_face", 1}, &CellArrays::firstFace);
    use(ArrayName{"cells", "cell", "face_count", 1}, &CellArrays::faceCount);
    use(ArrayName{"cells", "cell", "state", 1}, &CellArrays::state);
    use(ArrayName{"faces", "face", "first_corner", 1}, &CellArrays::firstCorner);
    use(ArrayName{"faces", "face", "corner_count", 1}, &CellArrays::cornerCount);
    use(ArrayName{"corners", "corner", "point", 3}, &CellArrays::faceCorners);
}

/// `scene`: all of its triangles, of which the cells' are some, in that order.
CellArrays arraysOf(const SurfaceCells& cells, std::span<const WorldTriangle> scene);

/// All triangles, as if they were of one batch: results don't need the scene's.
std::vector<WorldTriangle> sceneOf(const CellArrays& arrays);

/// The cells, without patches and offset, which results don't need.
SurfaceCells cellsOf(const CellArrays& arrays);

} // namespace edgeshade::hours
