#include "preprocess/section/section_fill.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/mesh/weld.hpp"

#include <algorithm>
#include <deque>
#include <GL/glu.h>
#include <memory>

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

/// GLU's tessellator, called back with vertices as pointers to their numbers.
class Tessellator {
  public:
    Tessellator(Geometry& geometry, const glm::dvec4& plane)
        : geometry_(geometry), tess_(gluNewTess()) {
        if (!tess_)
            throw Error(ExitStatus::unavailable, "There is no memory for a section's fill.");
        using Callback = void(GLAPIENTRY*)();
        const auto on = [&](GLenum event, Callback call) {
            gluTessCallback(tess_.get(), event, call);
        };
        on(GLU_TESS_VERTEX_DATA, reinterpret_cast<Callback>(&addVertex));
        on(GLU_TESS_COMBINE_DATA, reinterpret_cast<Callback>(&combine));
        on(GLU_TESS_ERROR_DATA, reinterpret_cast<Callback>(&fail));
        // With this callback GLU makes triangles alone, no strips and fans.
        on(GLU_TESS_EDGE_FLAG, reinterpret_cast<Callback>(&ignoreFlag));
        gluTessProperty(tess_.get(), GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_NONZERO);
        const glm::dvec3 outward = -glm::dvec3(plane);
        gluTessNormal(tess_.get(), outward.x, outward.y, outward.z);
    }

    std::vector<std::array<std::uint32_t, 3>>
    trianglesOf(const std::vector<std::vector<std::uint32_t>>& loops) {
        gluTessBeginPolygon(tess_.get(), this);
        for (const std::vector<std::uint32_t>& loop : loops) {
            gluTessBeginContour(tess_.get());
            for (const std::uint32_t vertex : loop)
                add(vertex);
            gluTessEndContour(tess_.get());
        }
        gluTessEndPolygon(tess_.get());
        if (failed_)
            throw Error(ExitStatus::unavailable, "There is no memory for a section's fill.");
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (std::size_t i = 0; i + 2 < corners_.size(); i += 3)
            triangles.push_back({corners_[i], corners_[i + 1], corners_[i + 2]});
        return triangles;
    }

  private:
    struct Vertex {
        std::array<GLdouble, 3> place;
        std::uint32_t number;
    };
    struct Delete {
        void operator()(GLUtesselator* tess) const { gluDeleteTess(tess); }
    };

    void add(std::uint32_t number) {
        const glm::dvec3 at(geometry_.positions[number]);
        Vertex& vertex = vertices_.emplace_back(Vertex{{at.x, at.y, at.z}, number});
        gluTessVertex(tess_.get(), vertex.place.data(), &vertex);
    }

    static void GLAPIENTRY addVertex(void* vertex, void* self) {
        static_cast<Tessellator*>(self)->corners_.push_back(static_cast<Vertex*>(vertex)->number);
    }
    static void GLAPIENTRY combine(GLdouble place[3], void* [4], GLfloat[4], void** made,
                                   void* self) {
        auto& of = *static_cast<Tessellator*>(self);
        const auto number = static_cast<std::uint32_t>(of.geometry_.positions.size());
        of.geometry_.positions.push_back(glm::vec3(place[0], place[1], place[2]) + 0.0f);
        *made = &of.vertices_.emplace_back(Vertex{{place[0], place[1], place[2]}, number});
    }
    static void GLAPIENTRY fail(GLenum error, void* self) {
        if (error == GLU_OUT_OF_MEMORY) static_cast<Tessellator*>(self)->failed_ = true;
    }
    static void GLAPIENTRY ignoreFlag(GLboolean) {}

    Geometry& geometry_;
    std::unique_ptr<GLUtesselator, Delete> tess_;
    std::deque<Vertex> vertices_; ///< GLU keeps pointers to them
    std::vector<std::uint32_t> corners_;
    bool failed_ = false;
};

} // namespace

std::vector<std::array<std::uint32_t, 3>> fillOf(const std::vector<CutLine>& lines,
                                                 const glm::dvec4& plane, Geometry& geometry) {
    if (lines.empty()) return {};
    std::vector<std::array<std::uint32_t, 3>> faces =
        Tessellator(geometry, plane).trianglesOf(loopsOf(lines, geometry.positions));
    closeSlivers(lines, geometry.positions, faces);
    return faces;
}

} // namespace edgeshade
