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

/// Draws the edges and triangles of one batch.
class BatchDrawing {
  public:
    /// `box`: around all points.
    BatchDrawing(const LightView& view, const RaysOfBatch& rays, const Box& box,
                 std::vector<FaceChain>& faces)
        : view_(view), rays_(rays), faces_(faces) {
        if (view.directional) sunRays_.emplace(rays, box);
        nearest_.fill(view.directional ? 1.0 : INFINITY);
        for (std::size_t face = 0; face < faces.size(); ++face) {
            // A point of the chain is to the left of a counter-clockwise triangle's edges. A
            // triangle that faces a sun is counter-clockwise on its plane, and one that faces a
            // lamp is clockwise on a face with right-handed axes.
            const bool clockwise = !view.directional && glm::determinant(view.faces[face]) > 0.0;
            turn_[face] = clockwise != rays.mirrors ? 1 : -1;
        }
    }

    /// `Record`: PairRecord or SingleRecord.
    template <class Record>
    void addEdges(const std::vector<ChainEdge>& edges, const std::vector<Record>& records) {
        if (view_.directional) return addToSun(edges, records);
        forEachEdge(edges, records, [&](const Record& record, int weight) {
            addEdge(rays_.to(record.a), rays_.to(record.b), weight);
        });
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

    /// Call this last.
    void addError() {
        for (std::size_t face = 0; face < faces_.size(); ++face) {
            const double error = 3.0 * rays_.rounding / nearest_[face];
            addError(error, faces_[face]);
        }
        if (sunRays_) addError(3.0 * sunRays_->rounding(), faces_[0]);
    }

  private:
    template <class Record, class Use>
    static void forEachEdge(const std::vector<ChainEdge>& edges, const std::vector<Record>& records,
                            Use use) {
        constexpr std::size_t ahead = 16;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (i + ahead < edges.size()) prefetch(records[edges[i + ahead].record]);
            use(records[edges[i].record], edges[i].weight);
        }
    }

    template <class Record>
    void addToSun(const std::vector<ChainEdge>& edges, const std::vector<Record>& records) {
        FaceChain& face = faces_[0];
        if (edges.empty()) return;
        Floats low = all(INFINITY), high = all(-INFINITY);
        std::size_t size = face.segments.size();
        face.segments.resize(size + edges.size());
        forEachEdge(edges, records, [&](const Record& record, int weight) {
            const Floats ends = sunRays_->to(record.a, record.b);
            low = lesser(ends, low);
            high = greater(ends, high);
            // Without a branch, as nothing predicts it.
            const int down = ends[1] > ends[3];
            const Floats turned{ends[2], ends[3], ends[0], ends[1]};
            const Floats upward = all(ends[1]) > all(ends[3]) ? turned : ends;
            FaceSegment& segment = face.segments[size++];
            std::memcpy(&segment, &upward, sizeof(upward));
            segment.weight = turn_[0] * weight * (1 - 2 * down);
        });
        face.reached.add({std::min(low[0], low[2]), std::max(high[0], high[2]),
                          std::min(low[1], low[3]), std::max(high[1], high[3])});
    }

    static void addError(double error, FaceChain& face) {
        face.error = std::isfinite(error) ? std::max(face.error, error) : INFINITY;
    }

    void addEdge(const glm::dvec3& a, const glm::dvec3& b, int weight) {
        const int face = faceAround(a);
        if (face >= 0 && face == faceAround(b))
            return project(static_cast<std::size_t>(face), onFace(face, a), onFace(face, b),
                           weight);
        for (int of = 0; of < 6; ++of)
            addCut(of, onFace(of, a), onFace(of, b), weight);
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
        const double mixed = mixRounding * (largestComponent(a) + largestComponent(b)) / depth;
        faces_[of].error = depth > 0.0 ? std::max(faces_[of].error, 3.0 * mixed) : INFINITY;
        if (depth > 0.0) project(of, from, to, weight);
    }

    void project(std::size_t face, const glm::dvec3& a, const glm::dvec3& b, int weight) {
        nearest_[face] = std::min({nearest_[face], a.z, b.z});
        put(face, glm::dvec2(a) * (1.0 / a.z), glm::dvec2(b) * (1.0 / b.z), weight);
    }

    void put(std::size_t of, const glm::dvec2& from, const glm::dvec2& to, int weight) {
        FaceChain& face = faces_[of];
        // Without a branch, as nothing predicts it.
        const std::array<glm::dvec2, 2> ends{from, to};
        const int down = from.y > to.y;
        face.drawn.push_back({ends[static_cast<std::size_t>(down)],
                              ends[static_cast<std::size_t>(1 - down)],
                              turn_[of] * weight * (1 - 2 * down)});
        Outline& reached = face.reached;
        reached.u0 = std::min({reached.u0, from.x, to.x});
        reached.u1 = std::max({reached.u1, from.x, to.x});
        reached.v0 = std::min({reached.v0, from.y, to.y});
        reached.v1 = std::max({reached.v1, from.y, to.y});
    }
    static void put(FaceChain& face, const FacePolygon& polygon) {
        face.uncertain.push_back(polygon);
        face.reached.add(outlineOf(polygon.all()));
    }

    const LightView& view_;
    const RaysOfBatch& rays_;
    std::vector<FaceChain>& faces_;
    std::optional<SunRays> sunRays_;  ///< of a directional light
    std::array<int, 6> turn_{};       ///< by face: sign of an upward edge's weight
    std::array<double, 6> nearest_{}; ///< by face: least depth of a segment's end
};

} // namespace

void settle(FaceChain& face) {
    if (face.drawn.empty() && face.uncertain.empty()) return;
    face.frame = FaceFrame::around(face.reached);
    for (const DrawnSegment& drawn : face.drawn)
        face.segments.push_back({glm::vec2(face.frame.to(drawn.from)),
                                 glm::vec2(face.frame.to(drawn.to)), drawn.weight});
    for (FacePolygon& polygon : face.uncertain)
        for (std::size_t i = 0; i < polygon.count; ++i)
            polygon.corners[i] = face.frame.to(polygon.corners[i]);
    const glm::dvec2 low = face.frame.to({face.reached.u0, face.reached.v0});
    const glm::dvec2 high = face.frame.to({face.reached.u1, face.reached.v1});
    face.reached = {low.x, high.x, low.y, high.y};
    face.error = face.error * face.frame.scale + 3.0 * placeRounding;
}

void drawChain(const LightView& view, const RaysOfBatch& rays, const CasterChain& chain,
               const SeenCasters& seen, std::vector<FaceChain>& faces) {
    BatchDrawing drawing(view, rays, chain.bounds(), faces);
    drawing.addEdges(seen.pairs, chain.shadow().pairs);
    drawing.addEdges(seen.singles, chain.shadow().singles);
    for (const std::uint32_t cap : seen.uncertain) {
        const CapRecord& of = chain.shadow().caps[cap];
        drawing.addUncertain({rays.to(of.a), rays.to(of.b), rays.to(of.c)});
    }
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
