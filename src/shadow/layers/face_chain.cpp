#include "src/shadow/layers/face_chain.hpp"

#include "preprocess/base/prefetch.hpp"
#include "src/shadow/geometry/vectors.hpp"
#include "src/shadow/layers/sun_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

namespace edgeshade {
namespace {

using namespace silhouette;

/// Share of a face's half side to which segments are cut: beyond the face, so that rounding takes
/// nothing from it.
constexpr double faceCut = 1.001;

/// Shares of a ray's length. A point of a triangle that is nearer to the light than this has no
/// reliable place on a face; rounding of a point between two corners.
constexpr double leastDistance = 0x1p-18, mixRounding = 0x1p-50;

/// Rounding of a coordinate in [-1, 1] to floats.
constexpr double placeRounding = 0x1p-24;

constexpr std::size_t faceCount = 6; ///< of a point light

/// A segment that rises by more than so many of its ends' errors rises in its exact place. Beside
/// both errors it holds the rounding of the rise.
constexpr double risingErrors = 2.0001;

/// Draws the edges and triangles of one batch.
class BatchDrawing {
  public:
    BatchDrawing(const LightView& view, const RaysOfBatch& rays, const CasterChain& chain,
                 const SeenCasters& seen, ChainPaths& paths, std::vector<FaceChain>& faces)
        : view_(view), rays_(rays), paths_(paths), faces_(faces) {
        if (view.directional) sunRays_.emplace(rays, chain.bounds());
        paths.begin(chain.vertices().places.size(), seen.pairs.size() + seen.singles.size());
        nearest_.fill(view.directional ? 1.0 : INFINITY);
        for (std::size_t face = 0; face < faces.size(); ++face) {
            // A point of the chain is to the left of a counter-clockwise triangle's edges. A
            // triangle that faces a sun is counter-clockwise on its plane, and one that faces a
            // lamp is clockwise on a face with right-handed axes.
            const bool clockwise = !view.directional && glm::determinant(view.faces[face]) > 0.0;
            turn_[face] = clockwise != rays.mirrors ? 1 : -1;
        }
    }

    /// `ends`: of the records, in `places`.
    void addEdges(const std::vector<ChainEdge>& edges, const std::vector<EndNumbers>& ends,
                  const std::vector<glm::vec3>& places) {
        if (view_.directional)
            addToSun(edges, ends, places);
        else
            addToLamp(edges, ends, places);
    }

    void addUncertain(const std::array<glm::dvec3, 3>& corners) {
        if (view_.directional) {
            FacePolygon polygon;
            for (const glm::dvec3& corner : corners)
                polygon.add(glm::dvec2(corner));
            return put(faces_[0], polygon);
        }
        Box box;
        double farthest = 0.0;
        for (const glm::dvec3& corner : corners) {
            box.add(corner);
            farthest = std::max(farthest, largestComponent(corner));
        }
        const bool isPlaced =
            box.distanceTo(glm::dvec3(0.0)) > leastDistance * farthest + 0x1p30 * rays_.rounding;
        for (std::size_t face = 0; face < faces_.size(); ++face) {
            if (!isPlaced) {
                ++faces_[face].everywhere;
                continue;
            }
            const FacePolygon polygon = polygonOn(view_.faces[face], corners);
            if (polygon.count > 0 && !outlineOf(polygon.all()).misses(view_.wholeFace()))
                put(faces_[face], polygon);
        }
    }

    /// Call these last.
    void findStarts() {
        paths_.findStarts([&](std::size_t segment, int starts) {
            if (view_.directional)
                faces_[0].segments[segment].starts = starts;
            else
                faces_[segment % faceCount].drawn[segment / faceCount].starts = starts;
        });
    }
    void addError() {
        for (std::size_t face = 0; face < faces_.size(); ++face)
            addError(lampError(1.0 / nearest_[face]), faces_[face]);
        if (sunRays_) addError(sunError(), faces_[0]);
    }

  private:
    /// Calls use(numbers of the ends, weight) for each edge.
    template <class Use>
    static void forEachEdge(const std::vector<ChainEdge>& edges,
                            const std::vector<EndNumbers>& ends, Use use) {
        constexpr std::size_t ahead = 16;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (i + ahead < edges.size()) prefetch(ends[edges[i + ahead].record]);
            use(ends[edges[i].record], edges[i].weight);
        }
    }

    void addToSun(const std::vector<ChainEdge>& edges, const std::vector<EndNumbers>& numbers,
                  const std::vector<glm::vec3>& places) {
        FaceChain& face = faces_[0];
        if (edges.empty()) return;
        Floats low = all(INFINITY), high = all(-INFINITY);
        std::size_t size = face.segments.size();
        face.segments.resize(size + edges.size());
        FaceSegment* const segments = face.segments.data();
        const int turn = turn_[0];
        const double leastRise = risingErrors * sunError();
        ChainPaths::Adding adding(paths_);
        forEachEdge(edges, numbers, [&](const EndNumbers& edge, int weight) {
            const auto [a, b] = edge;
            const Floats ends = sunRays_->to(places[a], places[b]);
            low = lesser(ends, low);
            high = greater(ends, high);
            // Without a branch, as nothing predicts it.
            const int down = ends[1] > ends[3];
            const Floats turned{ends[2], ends[3], ends[0], ends[1]};
            const Floats upward = all(ends[1]) > all(ends[3]) ? turned : ends;
            const int upwardWeight = turn * weight * (1 - 2 * down);
            FaceSegment& segment = segments[size];
            std::memcpy(&segment, &upward, sizeof(upward));
            segment.weight = static_cast<std::int16_t>(upwardWeight);
            segment.level = static_cast<double>(upward[3] - upward[1]) <= leastRise;
            const std::uint32_t change = (a ^ b) & static_cast<std::uint32_t>(-down);
            adding.add(a ^ change, b ^ change, upwardWeight, size++);
        });
        face.reached.add({std::min(low[0], low[2]), std::max(high[0], high[2]),
                          std::min(low[1], low[3]), std::max(high[1], high[3])});
    }

    double sunError() const { return 3.0 * std::max(sunRays_->rounding(), rays_.rounding); }
    /// The error of a place on a lamp's face. `perDepth`: one divided by its depth.
    double lampError(double perDepth) const { return 3.0 * rays_.rounding * perDepth; }

    static void addError(double error, FaceChain& face) {
        face.error = std::isfinite(error) ? std::max(face.error, error) : INFINITY;
    }

    void addToLamp(const std::vector<ChainEdge>& edges, const std::vector<EndNumbers>& numbers,
                   const std::vector<glm::vec3>& places) {
        ChainPaths::Adding adding(paths_);
        forEachEdge(edges, numbers, [&](const EndNumbers& ends, int weight) {
            const glm::dvec3 a = rays_.to(places[ends[0]]), b = rays_.to(places[ends[1]]);
            const int around = faceAround(a);
            if (around < 0 || around != faceAround(b)) return addCut(a, b, weight);
            const auto face = static_cast<std::size_t>(around);
            std::vector<DrawnSegment>& drawn = faces_[face].drawn;
            const bool down = project(face, onFace(around, a), onFace(around, b), weight);
            adding.add(ends[down ? 1 : 0], ends[down ? 0 : 1], drawn.back().weight,
                       faceCount * (drawn.size() - 1) + face);
        });
    }

    /// Adds the parts of an edge that isn't on one face alone. Each is a path by itself.
    void addCut(const glm::dvec3& a, const glm::dvec3& b, int weight) {
        for (int face = 0; face < static_cast<int>(faceCount); ++face)
            addCut(face, onFace(face, a), onFace(face, b), weight);
    }

    /// A ray by a face's axes; its place on the face is (x, y) / z.
    static glm::dvec3 onFace(int face, const glm::dvec3& ray) {
        const double sign = face % 2 == 0 ? 1.0 : -1.0;
        switch (face / 2) {
        case 0:
            return {ray.y, ray.z, sign * ray.x};
        case 1:
            return {ray.z, ray.x, sign * ray.y};
        default:
            return {ray.x, ray.y, sign * ray.z};
        }
    }

    /// Adds the part of an edge within a face's cone. The edge may be partly behind the light.
    void addCut(int face, const glm::dvec3& a, const glm::dvec3& b, int weight) {
        double first = 0.0, last = 1.0;
        for (const glm::dvec3& plane :
             {glm::dvec3(1.0, 0.0, faceCut), glm::dvec3(-1.0, 0.0, faceCut),
              glm::dvec3(0.0, 1.0, faceCut), glm::dvec3(0.0, -1.0, faceCut)}) {
            const double atA = glm::dot(plane, a), atB = glm::dot(plane, b);
            if (atA < 0.0 && atB < 0.0) return;
            if (atA < 0.0)
                first = std::max(first, atA / (atA - atB));
            else if (atB < 0.0)
                last = std::min(last, atA / (atA - atB));
        }
        if (!(first < last)) return;
        const glm::dvec3 from = first > 0.0 ? a + first * (b - a) : a;
        const glm::dvec3 to = last < 1.0 ? a + last * (b - a) : b;
        const auto of = static_cast<std::size_t>(face);
        const double depth = std::min(from.z, to.z);
        const double mixed =
            3.0 * mixRounding * (largestComponent(a) + largestComponent(b)) / depth;
        faces_[of].error = depth > 0.0 ? std::max(faces_[of].error, mixed) : INFINITY;
        if (!(depth > 0.0)) return;
        project(of, from, to, weight, mixed);
        DrawnSegment& drawn = faces_[of].drawn.back();
        drawn.starts = std::max<int>(drawn.weight, 0);
    }

    /// `error`: of ends on the face, beyond that of vertices. Returns whether the segment runs from
    /// b to a.
    bool project(std::size_t face, const glm::dvec3& a, const glm::dvec3& b, int weight,
                 double error = 0.0) {
        nearest_[face] = std::min({nearest_[face], a.z, b.z});
        const double perA = 1.0 / a.z, perB = 1.0 / b.z;
        return put(face, glm::dvec2(a) * perA, glm::dvec2(b) * perB, weight,
                   lampError(std::max(perA, perB)) + error);
    }

    bool put(std::size_t of, const glm::dvec2& from, const glm::dvec2& to, int weight,
             double error) {
        FaceChain& face = faces_[of];
        // Without a branch, as nothing predicts it.
        const std::array<glm::dvec2, 2> ends{from, to};
        const int down = from.y > to.y;
        DrawnSegment& drawn = face.drawn.emplace_back();
        drawn.from = ends[static_cast<std::size_t>(down)];
        drawn.to = ends[static_cast<std::size_t>(1 - down)];
        drawn.weight = static_cast<std::int16_t>(turn_[of] * weight * (1 - 2 * down));
        drawn.level = std::abs(to.y - from.y) <= 2.0 * risingErrors * error;
        Outline& reached = face.reached;
        reached.u0 = std::min({reached.u0, from.x, to.x});
        reached.u1 = std::max({reached.u1, from.x, to.x});
        reached.v0 = std::min({reached.v0, from.y, to.y});
        reached.v1 = std::max({reached.v1, from.y, to.y});
        return down != 0;
    }
    static void put(FaceChain& face, const FacePolygon& polygon) {
        face.uncertain.push_back(polygon);
        face.reached.add(outlineOf(polygon.all()));
    }

    const LightView& view_;
    const RaysOfBatch& rays_;
    ChainPaths& paths_;
    std::vector<FaceChain>& faces_;
    std::optional<SunRays> sunRays_;  ///< of a directional light
    std::array<int, 6> turn_{};       ///< by face: sign of an upward edge's weight
    std::array<double, 6> nearest_{}; ///< by face: least depth of a segment's end
};

} // namespace

void settle(FaceChain& face) {
    if (face.drawn.empty() && face.uncertain.empty()) return;
    face.frame = FaceFrame::around(face.reached);
    constexpr auto leastRise = static_cast<float>(2.0 * risingErrors * 3.0 * placeRounding);
    face.segments.resize(face.drawn.size());
    for (std::size_t i = 0; i < face.drawn.size(); ++i) {
        const DrawnSegment& drawn = face.drawn[i];
        FaceSegment& segment = face.segments[i];
        segment.from = glm::vec2(face.frame.to(drawn.from));
        segment.to = glm::vec2(face.frame.to(drawn.to));
        segment.starts = drawn.starts;
        segment.weight = drawn.weight;
        // Both errors together are at most twice the larger one.
        segment.level = drawn.level | (segment.to.y - segment.from.y <= leastRise);
    }
    for (FacePolygon& polygon : face.uncertain)
        for (std::size_t i = 0; i < polygon.count; ++i)
            polygon.corners[i] = face.frame.to(polygon.corners[i]);
    const glm::dvec2 low = face.frame.to({face.reached.u0, face.reached.v0});
    const glm::dvec2 high = face.frame.to({face.reached.u1, face.reached.v1});
    face.reached = {low.x, high.x, low.y, high.y};
    face.error = face.error * face.frame.scale + 3.0 * placeRounding;
}

void drawChain(const LightView& view, const RaysOfBatch& rays, const CasterChain& chain,
               const SeenCasters& seen, ChainPaths& paths, std::vector<FaceChain>& faces) {
    BatchDrawing drawing(view, rays, chain, seen, paths, faces);
    const EdgeVertices& vertices = chain.vertices();
    drawing.addEdges(seen.pairs, vertices.pairs, vertices.places);
    drawing.addEdges(seen.singles, vertices.singles, vertices.places);
    for (const std::uint32_t cap : seen.uncertain) {
        const CapRecord& of = chain.shadow().caps[cap];
        drawing.addUncertain({rays.to(of.a), rays.to(of.b), rays.to(of.c)});
    }
    drawing.findStarts();
    drawing.addError();
}

int trianglesAlong(const glm::dvec3& direction, const RaysOfBatch& rays, const CasterChain& chain,
                   const std::vector<std::int8_t>& facings,
                   const std::vector<std::uint32_t>& caps) {
    int met = 0;
    for (const std::uint32_t cap : caps) {
        if (facings[cap] == 0) continue;
        const CapRecord& of = chain.shadow().caps[cap];
        const std::array<glm::dvec3, 3> corners{rays.to(of.a), rays.to(of.b), rays.to(of.c)};
        // A triangle that faces the light runs clockwise around the ray.
        const double sense = (facings[cap] > 0) != rays.mirrors ? -1.0 : 1.0;
        bool misses = false;
        for (std::size_t i = 0; i < 3 && !misses; ++i) {
            const glm::dvec3 &p = corners[i], &q = corners[(i + 1) % 3];
            const double side = sense * glm::dot(direction, glm::cross(p, q));
            const double sizes = largestComponent(p) + largestComponent(q);
            misses = side < -16.0 * (rays.rounding + 0x1p-50 * sizes) * sizes *
                                largestComponent(direction);
        }
        met += misses ? 0 : 1;
    }
    return met;
}

} // namespace edgeshade
