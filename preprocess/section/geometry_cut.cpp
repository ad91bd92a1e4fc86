#include "preprocess/section/geometry_cut.hpp"

#include "preprocess/mesh/edge_numbers.hpp"
#include "preprocess/section/plane_height.hpp"
#include "preprocess/section/vertex_attributes.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// The position on the edge from `a`, which is kept, to `b`, which isn't: `share` of the way.
glm::vec3 crossingOf(const glm::vec3& a, const glm::vec3& b, double share) {
    const glm::vec3 at(glm::dvec3(a) + share * (glm::dvec3(b) - glm::dvec3(a)));
    // Rounding must not leave the edge's box. Adding 0 turns -0 into 0.
    return glm::clamp(at, glm::min(a, b), glm::max(a, b)) + 0.0f;
}

template <class Value>
void addBetween(std::vector<Value>& values, std::uint32_t a, std::uint32_t b, float share) {
    if (!values.empty()) values.push_back(values[a] + share * (values[b] - values[a]));
}

glm::vec3 unit(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0.0f ? v / length : v;
}

/// Adds vertices on cut edges, once for each edge between two vertices.
class EdgeCutter {
  public:
    /// `triangles`: number of those that are cut, about.
    EdgeCutter(Geometry& geometry, const glm::dvec4& plane, std::size_t triangles)
        : geometry_(geometry), plane_(plane), made_(triangles) {}

    double height(std::uint32_t vertex) const {
        return heightOver(plane_, geometry_.positions[vertex]);
    }

    /// The vertex where the edge between a kept vertex and one that isn't crosses the plane; the
    /// kept vertex itself if it lies in the plane.
    std::uint32_t vertexOn(std::uint32_t kept, std::uint32_t other) {
        if (height(kept) == 0.0) return kept;
        std::uint32_t& vertex = made_.at(kept, other);
        if (vertex == EdgeNumbers::none) {
            vertex = static_cast<std::uint32_t>(geometry_.positions.size());
            add(kept, other);
        }
        return vertex;
    }

  private:
    /// `a` is kept, so every triangle at the edge computes the same.
    void add(std::uint32_t a, std::uint32_t b) {
        const double from = height(a), share = from / (from - height(b));
        const auto part = static_cast<float>(share);
        forEachAttribute([&](auto& values) { addBetween(values, a, b, part); }, geometry_);
        std::vector<glm::vec3>&positions = geometry_.positions, &normals = geometry_.normals;
        positions.back() = crossingOf(positions[a], positions[b], share);
        if (!normals.empty()) normals.back() = unit(normals.back());
        if (std::vector<glm::vec4>& tangents = geometry_.tangents; !tangents.empty()) {
            const glm::vec4 first = tangents[a], second = tangents[b];
            // The bitangent's sign is a vertex's, not a mean.
            tangents.back() =
                glm::vec4(unit(glm::mix(glm::vec3(first), glm::vec3(second), part)), first.w);
        }
    }

    Geometry& geometry_;
    const glm::dvec4& plane_;
    EdgeNumbers made_; ///< of vertices, by edge
};

/// Whether two of the corners are at one place, so that the piece has no area.
bool isCollapsed(const std::vector<glm::vec3>& positions, const std::array<std::uint32_t, 3>& of) {
    const glm::vec3 &a = positions[of[0]], &b = positions[of[1]], &c = positions[of[2]];
    return a == b || b == c || c == a;
}

/// The side of the plane that a triangle's front is on: above 0 if that is the kept one.
double frontOver(const glm::dvec4& plane, const std::vector<glm::vec3>& positions,
                 const std::array<std::uint32_t, 3>& corners) {
    const glm::dvec3 a(positions[corners[0]]), b(positions[corners[1]]), c(positions[corners[2]]);
    return glm::dot(glm::dvec3(plane), glm::cross(b - a, c - a));
}

} // namespace

GeometryCut::GeometryCut(Geometry& geometry, const std::vector<std::uint32_t>& indices)
    : geometry_(geometry) {
    triangles_.reserve(indices.size() / 3);
    for (std::uint32_t i = 0; 3 * i + 2 < indices.size(); ++i)
        triangles_.push_back(
            {{indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]}, i, false, false});
}

GeometryCut::GeometryCut(Geometry& geometry, const std::vector<std::uint32_t>& indices,
                         const std::vector<std::uint8_t>& solid,
                         const std::vector<std::uint32_t>& triangles)
    : geometry_(geometry) {
    triangles_.reserve(triangles.size());
    for (const std::uint32_t i : triangles)
        triangles_.push_back(
            {{indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]}, i, solid[i] != 0, false});
}

std::vector<CutLine> GeometryCut::cut(const glm::dvec4& plane, bool keepsAway) {
    EdgeCutter cutter(geometry_, plane, triangles_.size());
    std::vector<CutLine> lines;
    const auto addLine = [&](const CutTriangle& whole, std::uint32_t from, std::uint32_t to) {
        if (whole.solid && !whole.away && geometry_.positions[from] != geometry_.positions[to])
            lines.push_back({from, to});
    };
    std::vector<CutTriangle> pieces;
    pieces.reserve(triangles_.size());
    const auto addPiece = [&](const CutTriangle& whole, std::uint32_t a, std::uint32_t b,
                              std::uint32_t c, bool isKept) {
        const CutTriangle piece{{a, b, c}, whole.source, whole.solid, whole.away || !isKept};
        if ((isKept || keepsAway) && !isCollapsed(geometry_.positions, piece.corners))
            pieces.push_back(piece);
    };
    for (const CutTriangle& whole : triangles_) {
        const std::array<double, 3> heights = {cutter.height(whole.corners[0]),
                                               cutter.height(whole.corners[1]),
                                               cutter.height(whole.corners[2])};
        const auto isKept = [&](std::size_t c) { return heights[c] >= 0.0; };
        const int kept = int{isKept(0)} + int{isKept(1)} + int{isKept(2)};
        if (kept == 3 || kept == 0) {
            const bool bounds = whole.solid && heights == std::array<double, 3>{} &&
                                frontOver(plane, geometry_.positions, whole.corners) > 0.0;
            for (std::size_t c = 0; bounds && c < 3; ++c)
                addLine(whole, whole.corners[(c + 1) % 3], whole.corners[c]);
            const bool stays = kept == 3 && !bounds;
            if (stays || keepsAway) {
                pieces.push_back(whole);
                pieces.back().away = whole.away || !stays;
            }
            continue;
        }
        // Turn the triangle so that its first corner is alone on its side.
        const bool aloneIsKept = kept == 1;
        const std::size_t alone = isKept(0) == aloneIsKept ? 0 : isKept(1) == aloneIsKept ? 1 : 2;
        const std::uint32_t a = whole.corners[alone], b = whole.corners[(alone + 1) % 3],
                            c = whole.corners[(alone + 2) % 3];
        const std::uint32_t ab = aloneIsKept ? cutter.vertexOn(a, b) : cutter.vertexOn(b, a),
                            ac = aloneIsKept ? cutter.vertexOn(a, c) : cutter.vertexOn(c, a);
        addPiece(whole, a, ab, ac, aloneIsKept);
        addPiece(whole, ab, b, c, !aloneIsKept);
        addPiece(whole, ab, c, ac, !aloneIsKept);
        aloneIsKept ? addLine(whole, ab, ac) : addLine(whole, ac, ab);
    }
    triangles_ = std::move(pieces);
    return lines;
}

glm::dvec4 planeInBatch(const glm::dvec4& plane, const glm::dmat4& worldFromBatch) {
    return glm::transpose(worldFromBatch) * plane;
}

BoxSide sideOf(const Box& box, const std::vector<glm::dvec4>& planes) {
    BoxSide side = BoxSide::kept;
    for (const glm::dvec4& plane : planes) {
        const glm::dvec3 normal(plane), middle = box.center();
        const glm::dvec3 half = 0.5 * (box.high - box.low);
        const double height = glm::dot(normal, middle) + plane.w;
        // Coordinates are floats, so that their rounding is far below this share.
        const double reach =
            glm::dot(glm::abs(normal), half) * (1.0 + 1e-9) +
            1e-12 * (glm::dot(glm::abs(normal), glm::abs(middle)) + std::abs(plane.w));
        if (height < -reach) return BoxSide::away;
        if (height <= reach) side = BoxSide::crossed;
    }
    return side;
}

} // namespace edgeshade
