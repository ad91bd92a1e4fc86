#include "preprocess/section/section_fill.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/mesh/tessellation.hpp"
#include "preprocess/mesh/weld.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Closed loops of vertices at different places, in the direction of faces that close the cut.
///
/// Every position has as many lines to it as from it, because solids are closed. Where several
/// pass through one, it doesn't matter which follows which: windings are the same.
std::vector<std::vector<std::uint32_t>> loopsOf(const std::vector<CutLine>& lines,
                                                const std::vector<glm::vec3>& positions) {
    const auto isBefore = [&](std::uint32_t a, std::uint32_t b) {
        return orderedBefore(positions[a], positions[b]);
    };
    // Faces run against the kept border.
    std::vector<CutLine> sorted;
    sorted.reserve(lines.size());
    for (const CutLine& line : lines)
        sorted.push_back({line.to, line.from});
    std::sort(sorted.begin(), sorted.end(),
              [&](const CutLine& a, const CutLine& b) { return isBefore(a.from, b.from); });
    std::vector<std::uint8_t> used(sorted.size(), 0);
    const auto nextFrom = [&](std::uint32_t vertex) {
        auto at = std::lower_bound(
            sorted.begin(), sorted.end(), vertex,
            [&](const CutLine& line, std::uint32_t v) { return isBefore(line.from, v); });
        while (at != sorted.end() && positions[at->from] == positions[vertex] &&
               used[static_cast<std::size_t>(at - sorted.begin())] != 0)
            ++at;
        const bool found = at != sorted.end() && positions[at->from] == positions[vertex];
        return found ? static_cast<std::size_t>(at - sorted.begin()) : sorted.size();
    };
    std::vector<std::vector<std::uint32_t>> loops;
    for (std::size_t first = 0; first < sorted.size(); ++first) {
        if (used[first] != 0) continue;
        std::vector<std::uint32_t> loop;
        std::size_t at = first;
        while (at != sorted.size()) {
            used[at] = 1;
            loop.push_back(sorted[at].from);
            if (positions[sorted[at].to] == positions[sorted[first].from]) break;
            at = nextFrom(sorted[at].to);
        }
        if (at != sorted.size() && loop.size() > 2) loops.push_back(std::move(loop));
    }
    return loops;
}

/// Whether a loop encloses next to nothing.
bool isThin(const std::vector<std::uint32_t>& loop, const std::vector<glm::vec3>& positions) {
    constexpr double share = 1e-5; // of the square of its length
    const glm::dvec3 first(positions[loop.front()]);
    glm::dvec3 area(0.0);
    double length = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec3 a(positions[loop[i]]), b(positions[loop[(i + 1) % loop.size()]]);
        area += glm::cross(a - first, b - first);
        length += glm::length(b - a);
    }
    return glm::length(area) <= share * length * length;
}

/// Adds triangles without area where faces leave the lines' border open: where a tessellator drops
/// points on a straight line, or adds some where lines cross.
void closeSlivers(const std::vector<CutLine>& lines, const std::vector<glm::vec3>& positions,
                  std::vector<std::array<std::uint32_t, 3>>& faces) {
    // The faces' border runs against the lines. What is left of both is what is open.
    struct Directed {
        std::uint32_t from, to;
        int times;
    };
    std::vector<Directed> edges;
    const auto add = [&](std::uint32_t from, std::uint32_t to) {
        const bool swaps = orderedBefore(positions[to], positions[from]);
        edges.push_back(swaps ? Directed{to, from, -1} : Directed{from, to, 1});
    };
    for (const CutLine& line : lines)
        add(line.from, line.to);
    for (const auto& face : faces)
        for (std::size_t c = 0; c < 3; ++c)
            add(face[c], face[(c + 1) % 3]);
    const auto isBefore = [&](const Directed& a, const Directed& b) {
        const glm::vec3 &from = positions[a.from], &other = positions[b.from];
        return from != other ? orderedBefore(from, other)
                             : orderedBefore(positions[a.to], positions[b.to]);
    };
    std::sort(edges.begin(), edges.end(), isBefore);
    std::vector<CutLine> open;
    for (std::size_t i = 0; i < edges.size();) {
        int times = 0;
        const Directed& first = edges[i];
        for (; i < edges.size() && !isBefore(first, edges[i]); ++i)
            times += edges[i].times;
        for (; times > 0; --times)
            open.push_back({first.from, first.to});
        for (; times < 0; ++times)
            open.push_back({first.to, first.from});
    }
    for (const std::vector<std::uint32_t>& loop : loopsOf(open, positions))
        if (isThin(loop, positions))
            for (std::size_t i = 1; i + 1 < loop.size(); ++i)
                faces.push_back({loop[0], loop[i], loop[i + 1]});
}

/// The triangles of loops. Where lines cross, vertices are added.
std::vector<std::array<std::uint32_t, 3>>
trianglesOf(const std::vector<std::vector<std::uint32_t>>& loops, const glm::dvec4& plane,
            Geometry& geometry) {
    std::vector<std::vector<glm::dvec3>> places;
    std::vector<std::uint32_t> numbers;
    for (const std::vector<std::uint32_t>& loop : loops) {
        std::vector<glm::dvec3>& to = places.emplace_back();
        for (const std::uint32_t vertex : loop)
            to.emplace_back(geometry.positions[vertex]);
        numbers.insert(numbers.end(), loop.begin(), loop.end());
    }
    std::optional<Tessellation> made = tessellate(places, -glm::dvec3(plane), WindingRule::nonzero);
    if (!made) throw Error(ExitStatus::unavailable, "There is no memory for a section's fill.");
    for (const glm::dvec3& added : made->added) {
        numbers.push_back(static_cast<std::uint32_t>(geometry.positions.size()));
        geometry.positions.push_back(glm::vec3(added) + 0.0f); // no -0
    }
    for (std::array<std::uint32_t, 3>& triangle : made->triangles)
        for (std::uint32_t& corner : triangle)
            corner = numbers[corner];
    return std::move(made->triangles);
}

} // namespace

std::vector<std::array<std::uint32_t, 3>> fillOf(const std::vector<CutLine>& lines,
                                                 const glm::dvec4& plane, Geometry& geometry) {
    if (lines.empty()) return {};
    std::vector<std::array<std::uint32_t, 3>> faces =
        trianglesOf(loopsOf(lines, geometry.positions), plane, geometry);
    closeSlivers(lines, geometry.positions, faces);
    return faces;
}

} // namespace edgeshade
