#include "src/hours/surfaces/cell_arrays.hpp"

namespace edgeshade::hours {
namespace {

void append(const glm::dvec3& vector, std::vector<double>& to) {
    to.insert(to.end(), {vector.x, vector.y, vector.z});
}

glm::dvec3 vectorAt(const std::vector<double>& from, std::size_t i) {
    return {from[3 * i], from[3 * i + 1], from[3 * i + 2]};
}

WorldTriangle triangleAt(const CellArrays& arrays, std::size_t t) {
    WorldTriangle triangle;
    triangle.a = vectorAt(arrays.corners, 3 * t);
    triangle.b = vectorAt(arrays.corners, 3 * t + 1);
    triangle.c = vectorAt(arrays.corners, 3 * t + 2);
    triangle.node = arrays.node[t];
    triangle.material = arrays.material[t];
    triangle.firstIndex = static_cast<std::uint32_t>(3 * t);
    return triangle;
}

} // namespace

CellArrays arraysOf(const SurfaceCells& cells, std::span<const WorldTriangle> scene) {
    CellArrays arrays;
    std::size_t next = 0; // of the cells' triangles
    for (const WorldTriangle& triangle : scene) {
        for (const glm::dvec3& corner : {triangle.a, triangle.b, triangle.c})
            append(corner, arrays.corners);
        arrays.node.push_back(triangle.node);
        arrays.material.push_back(triangle.material);
        const bool chosen = next < cells.triangles.size() &&
                            cells.triangles[next].batch == triangle.batch &&
                            cells.triangles[next].firstIndex == triangle.firstIndex;
        arrays.chosen.push_back(chosen);
        next += chosen;
    }
    for (const Cell& cell : cells.cells) {
        append(cell.point, arrays.point);
        append(cell.normal, arrays.normal);
        arrays.area.push_back(cell.area);
        arrays.triangle.push_back(cell.triangle);
        arrays.firstFace.push_back(cell.firstFace);
        arrays.faceCount.push_back(cell.faceCount);
        arrays.state.push_back(static_cast<std::uint8_t>(cell.state));
    }
    for (const CellFace& face : cells.faces) {
        arrays.firstCorner.push_back(face.firstCorner);
        arrays.cornerCount.push_back(face.cornerCount);
    }
    for (const glm::dvec3& corner : cells.corners)
        append(corner, arrays.faceCorners);
    return arrays;
}

std::vector<WorldTriangle> sceneOf(const CellArrays& arrays) {
    std::vector<WorldTriangle> scene;
    for (std::size_t t = 0; t < arrays.node.size(); ++t)
        scene.push_back(triangleAt(arrays, t));
    return scene;
}

SurfaceCells cellsOf(const CellArrays& arrays) {
    SurfaceCells cells;
    for (std::size_t t = 0; t < arrays.node.size(); ++t)
        if (arrays.chosen[t] != 0) cells.triangles.push_back(triangleAt(arrays, t));
    for (std::size_t i = 0; i < arrays.area.size(); ++i)
        cells.cells.push_back({vectorAt(arrays.point, i), vectorAt(arrays.normal, i),
                               arrays.area[i], arrays.triangle[i], arrays.firstFace[i],
                               arrays.faceCount[i], static_cast<CellState>(arrays.state[i])});
    for (std::size_t f = 0; f < arrays.firstCorner.size(); ++f)
        cells.faces.push_back({arrays.firstCorner[f], arrays.cornerCount[f]});
    for (std::size_t c = 0; 3 * c < arrays.faceCorners.size(); ++c)
        cells.corners.push_back(vectorAt(arrays.faceCorners, c));
    return cells;
}

} // namespace edgeshade::hours
