#include "src/rivals/maps/map_warp.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeshade {
namespace {

constexpr int cells = MapWarp::cells;

/// Least width of an outer cell, as a share of the casters' width.
constexpr double leastOuter = 1.0 / (8 * cells);
/// How far inner cells extend beyond the visible places found, as a share of their extent: there
/// are others between those found.
constexpr double between = 0.02;
/// Share of texels that all inner cells get alike, so that places not found have some.
constexpr double alike = 0.15;
/// Texels of an outer cell, as a share of an inner cell's equal share.
constexpr double outerShare = 0.25;
/// Number of neighbouring cells on each side over which importance is averaged: in both grids, and
/// between rows and between columns of a non-orthogonal grid, so that they differ little.
constexpr int smoothing = 1, likeness = 5;
/// Least remaining area of a half cell, as a share of its original area.
constexpr double leastArea = 2e-4;

using Line = std::array<double, cells>;
using Ends = std::array<double, cells + 1>;
using Counts = std::array<Line, cells>; ///< by y, then x
using Nodes = std::array<std::array<glm::dvec2, cells + 1>, cells + 1>;

/// Averages over `reach` neighbours on each side, with more weight for nearer ones.
Line smoothed(const Line& of, int reach) {
    Line result{};
    for (int i = 0; i < cells; ++i) {
        double weights = 0.0;
        for (int k = std::max(0, i - reach); k <= std::min(cells - 1, i + reach); ++k) {
            const double weight = reach + 1 - std::abs(i - k);
            result[i] += weight * of[k];
            weights += weight;
        }
        result[i] /= weights;
    }
    return result;
}

/// The boundaries of a row's cells, with widths that follow importance.
Ends endsOf(const Line& importance) {
    Line widths = smoothed(importance, smoothing);
    double sum = 0.0;
    for (int i = 1; i + 1 < cells; ++i)
        sum += widths[i];
    const double mean = sum / (cells - 2);
    for (int i = 0; i < cells; ++i) {
        const bool outer = i == 0 || i + 1 == cells;
        widths[i] = mean > 0.0 ? (outer ? 0.0 : (1.0 - alike) * widths[i] / mean) +
                                     alike * (outer ? outerShare : 1.0)
                               : 1.0;
    }
    Ends ends{};
    for (int i = 0; i < cells; ++i)
        ends[i + 1] = ends[i] + widths[i];
    for (double& end : ends)
        end /= ends[cells];
    return ends;
}

/// Interpolates between the boundaries at a fractional position in the lattice.
double endAt(const Ends& ends, double place) {
    const int cell = std::clamp(static_cast<int>(place), 0, cells - 1);
    return ends[cell] + (ends[cell + 1] - ends[cell]) * (place - cell);
}

void count(Counts& counts, const glm::dvec2& inLattice) {
    const glm::ivec2 cell = glm::clamp(glm::ivec2(inLattice), glm::ivec2(0), glm::ivec2(cells - 1));
    counts[static_cast<std::size_t>(cell.y)][static_cast<std::size_t>(cell.x)] += 1.0;
}

Counts transposed(const Counts& counts) {
    Counts result{};
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            result[x][y] = counts[y][x];
    return result;
}

/// Rosen's grid: a column is as important as its most important cell.
Ends endsOfColumns(const Counts& counts) {
    Line most{};
    for (const Line& row : counts)
        for (int x = 0; x < cells; ++x)
            most[x] = std::max(most[x], std::sqrt(row[x]));
    return endsOf(most);
}

/// Milet's grid: each row has its own columns, smoothed between neighbouring rows. One set for each
/// line between rows.
std::array<Ends, cells + 1> endsOfRows(const Counts& counts) {
    const Counts columns = transposed(counts);
    Counts alikeColumns{};
    for (int x = 0; x < cells; ++x)
        alikeColumns[x] = smoothed(columns[x], likeness);
    const Counts rows = transposed(alikeColumns);
    std::array<Ends, cells + 1> ends{};
    for (int line = 0; line <= cells; ++line) {
        Line both{};
        for (const int row : {std::max(line - 1, 0), std::min(line, cells - 1)})
            for (int x = 0; x < cells; ++x)
                both[x] += rows[row][x];
        ends[line] = endsOf(both);
    }
    return ends;
}

Nodes rectilinearNodes(const Counts& counts) {
    const Ends x = endsOfColumns(counts), y = endsOfColumns(transposed(counts));
    Nodes nodes{};
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i)
            nodes[j][i] = {x[i], y[j]};
    return nodes;
}

/// Moves nodes along rows first, then along columns, with importance counted at the moved places.
Nodes nonOrthogonalNodes(const Counts& counts, std::span<const glm::dvec2> inLattice) {
    const std::array<Ends, cells + 1> alongX = endsOfRows(counts);
    Counts moved{};
    for (const glm::dvec2& place : inLattice) {
        const int row = std::clamp(static_cast<int>(place.y), 0, cells - 1);
        const double x =
            glm::mix(endAt(alongX[row], place.x), endAt(alongX[row + 1], place.x), place.y - row);
        count(moved, {x * cells, place.y});
    }
    const std::array<Ends, cells + 1> alongY = endsOfRows(transposed(moved));
    Nodes nodes{};
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const double x = alongX[j][i];
            const int column = std::clamp(static_cast<int>(x * cells), 0, cells - 1);
            nodes[j][i] = {x,
                           glm::mix(alongY[column][j], alongY[column + 1][j], x * cells - column)};
        }
    return nodes;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Whether no half cell is flipped or has almost no area.
bool unfolded(const Nodes& nodes) {
    constexpr double least = leastArea / (cells * cells);
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const glm::dvec2 a = nodes[j][i], diagonal = nodes[j + 1][i + 1] - a;
            if (cross(nodes[j][i + 1] - a, diagonal) < least ||
                cross(diagonal, nodes[j + 1][i] - a) < least)
                return false;
        }
    return true;
}

/// The nodes closest to `wanted`, blended with a rectilinear grid, of which no cell folds.
Nodes withoutFolds(const Nodes& wanted, const Nodes& rectilinear) {
    for (double share = 1.0; share > 0.05; share -= 0.1) {
        Nodes nodes = rectilinear;
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i)
                nodes[j][i] = glm::mix(nodes[j][i], wanted[j][i], share);
        if (unfolded(nodes)) return nodes;
    }
    return rectilinear;
}

/// Fits the low and high corner of the inner cells around the visible places.
void fitInnerCells(MapWarp& warp, std::span<const glm::dvec2> visible) {
    glm::dvec2 low(1.0), high(0.0);
    for (const glm::dvec2& place : visible) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    const glm::dvec2 more = between * (high - low) + 1e-6;
    const bool none = visible.empty();
    warp.low = glm::clamp(none ? glm::dvec2(0.0) : low - more, leastOuter, 1.0 - 2.0 * leastOuter);
    warp.high = glm::clamp(none ? glm::dvec2(1.0) : high + more, warp.low + 1e-4 * leastOuter,
                           glm::dvec2(1.0 - leastOuter));
}

} // namespace

glm::dvec2 MapWarp::line(int index) const {
    if (index <= 0) return glm::dvec2(0.0);
    if (index >= cells) return glm::dvec2(1.0);
    return low + (high - low) * (static_cast<double>(index - 1) / (cells - 2));
}

glm::dvec4 MapWarp::inner() const {
    const glm::dvec2 perLength = 1.0 / (high - low);
    return {low, perLength};
}

glm::dvec4 MapWarp::outer() const {
    return {1.0 / low, 1.0 / (1.0 - high)};
}

glm::dvec2 MapWarp::inLattice(const glm::dvec2& place) const {
    const glm::dvec2 within = glm::clamp((place - low) / (high - low), 0.0, 1.0);
    return 1.0 + within * (cells - 2.0) + glm::min(place - low, 0.0) / low +
           glm::max(place - high, 0.0) / (1.0 - high);
}

glm::dvec2 MapWarp::node(int x, int y) const {
    const glm::dvec2 at(nodes[static_cast<std::size_t>(y * (cells + 1) + x)]);
    return margin + (1.0 - 2.0 * margin) / 65535.0 * at;
}

MapWarp mapWarp(WarpGrid grid, std::span<const glm::dvec2> visible, double margin) {
    std::vector<glm::dvec2> inside;
    for (const glm::dvec2& place : visible)
        if (glm::all(glm::greaterThanEqual(place, glm::dvec2(0.0))) &&
            glm::all(glm::lessThanEqual(place, glm::dvec2(1.0))))
            inside.push_back(place);
    MapWarp warp;
    warp.margin = margin;
    warp.rectilinear = grid == WarpGrid::rectilinear;
    fitInnerCells(warp, inside);
    Counts counts{};
    for (glm::dvec2& place : inside) {
        place = warp.inLattice(place);
        count(counts, place);
    }
    Nodes nodes = rectilinearNodes(counts);
    if (!warp.rectilinear) nodes = withoutFolds(nonOrthogonalNodes(counts, inside), nodes);
    for (const auto& row : nodes)
        for (const glm::dvec2& node : row)
            warp.nodes.emplace_back(glm::round(glm::clamp(node, 0.0, 1.0) * 65535.0));
    return warp;
}

} // namespace edgeshade
