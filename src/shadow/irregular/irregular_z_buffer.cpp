#include "src/shadow/irregular/irregular_z_buffer.hpp"

#include "src/shadow/lights/light_contact.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace edgeshade {
namespace {

/// Bound of the rounding error, in double precision, of a height over a plane, relative to its
/// terms.
constexpr double heightRounding = 0x1p-48;

/// Bound of the rounding error of a coordinate of 1 in a PointFrame.
constexpr float directionRounding = 0x1p-20f;

/// Most boxes of a run's groups to test each of its triangles against. With more, a triangle
/// gathers its own groups.
constexpr std::size_t mostBoxes = 12;

std::size_t faceAlong(const glm::dvec3& place) {
    const glm::dvec3 size = glm::abs(place);
    const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<std::size_t>(2 * axis + (place[axis] < 0.0 ? 1 : 0));
}

/// A vector around a point light in a face's coordinates: two across the face, one along its axis.
glm::dvec3 turnedTo(std::size_t face, const glm::dvec3& vector) {
    const auto axis = static_cast<glm::length_t>(face / 2);
    return {vector[(axis + 1) % 3], vector[(axis + 2) % 3],
            face % 2 != 0 ? -vector[axis] : vector[axis]};
}

/// The ray and the height of a point on a point light's face; planes stay planes in these
/// coordinates.
glm::dvec3 raysOn(std::size_t face, const glm::dvec3& place) {
    const glm::dvec3 turned = turnedTo(face, place);
    const double height = 1.0 / turned.z;
    return {turned.x * height, turned.y * height, height};
}

/// The ray and the height for a directional light.
glm::dvec3 raysOn(const glm::dvec3& place) {
    return {place.x, place.y, -place.z};
}

/// The side of the line through a and b that p is on, as seen by the light. Swapping a and b only
/// changes the sign, bit for bit, so that triangles that share an edge agree on it.
double edgeSide(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p, bool directional) {
    const glm::dvec3 from = a - p, to = b - p;
    return directional ? from.x * to.y - from.y * to.x : glm::dot(glm::cross(from, to), p);
}

/// The half space normal . rays + offset >= 0 in the frame's own coordinates, with a margin for
/// rounding.
HalfSpace inFrame(const PointFrame& frame, const glm::dvec3& normal, double offset) {
    const glm::dvec3 own = normal * frame.half;
    const double d = offset + glm::dot(normal, frame.middle);
    const double size = std::abs(own.x) + std::abs(own.y) + std::abs(own.z) + std::abs(d);
    if (!(size > 0.0) || !std::isfinite(size)) return {0.0f, 0.0f, 0.0f, 1.0f};
    const double by = 1.0 / size;
    return {static_cast<float>(own.x * by), static_cast<float>(own.y * by),
            static_cast<float>(own.z * by), static_cast<float>(d * by) + directionRounding};
}

float above(float value) {
    return value + directionRounding * (1.0f + std::abs(value));
}

float below(float value) {
    return value - directionRounding * (1.0f + std::abs(value));
}

CasterBox boxAround(const std::array<glm::vec3, 3>& places) {
    const glm::vec3 low = glm::min(glm::min(places[0], places[1]), places[2]);
    const glm::vec3 high = glm::max(glm::max(places[0], places[1]), places[2]);
    return {below(low.x), above(high.x), below(low.y), above(high.y), above(high.z)};
}

constexpr CasterBox everything{-CasterBox::infinity, CasterBox::infinity, -CasterBox::infinity,
                               CasterBox::infinity, CasterBox::infinity};

/// The frame of a face with points in these bounds.
PointFrame frameOf(const Box& extent) {
    constexpr double least = 1e-300; // its inverse is finite
    return {0.5 * (extent.low + extent.high),
            glm::max(0.5 * (extent.high - extent.low), glm::dvec3(least))};
}

} // namespace

/// Data to test whether a triangle is between a point and the light.
struct IrregularZBuffer::Corners {
    std::array<glm::dvec3, 3> places;
    SpacePlane plane;
    double behind;   ///< factor of a height over the plane: the product is above 0 on the side away
                     ///< from the light
    double rounding; ///< of heights; together with `perPlace` times the size of the point's
                     ///< coordinates
    double perPlace;
};

/// A visible triangle.
struct IrregularZBuffer::OwnTriangle {
    std::uint32_t number = 0;
    std::array<glm::dvec3, 3> corners{};
    SpacePlane plane{};
    bool dark = false; ///< the light grazes it, or it casts and faces away from the light
};

/// A thread's working memory.
struct IrregularZBuffer::Scratch {
    std::array<PointTree::Groups, 6> groups; ///< by face, for a run
    PointTree::Groups own;                   ///< for one triangle
    std::array<Vertex, 3 * CasterRuns::length> vertices;
};

struct IrregularZBuffer::PlacedInLight {
    const CasterRuns* casters;
    glm::dmat4 lightFromBatch;
    glm::dvec4 lightInBatch;
};

IrregularZBuffer::IrregularZBuffer(const SeenTriangles& seen, const FrameView& view,
                                   const Light& light, const PixelRectangle& reach, Threads threads)
    : seen_(seen), light_(light), space_(light, view.frustum.position()), lines_(view, space_),
      places_(seen.numbers.size()), faces_(space_.faceCount()), shadowed_(seen.numbers.size(), 0) {
    const PixelRectangle within = intersection(reach, seen.area);
    findPlaces(within, threads);
    addPoints(within, threads);
}

IrregularZBuffer::OwnTriangle IrregularZBuffer::ownTriangle(std::uint32_t number) const {
    const auto after =
        std::upper_bound(seen_.surfaces.begin(), seen_.surfaces.end(), number,
                         [](std::uint32_t n, const PlacedSurfaces& of) { return n < of.first; });
    const PlacedSurfaces& of = *(after - 1);
    const std::size_t triangle = number - of.first;
    const glm::dmat4 lightFromBatch = space_.fromBatch(of.worldFromBatch);
    std::array<glm::dvec3, 3> inBatch;
    OwnTriangle own{.number = number};
    for (std::size_t c = 0; c < 3; ++c) {
        inBatch[c] = of.positions[of.indices[3 * triangle + c]];
        own.corners[c] = glm::dvec3(lightFromBatch * glm::dvec4(inBatch[c], 1.0));
    }
    own.plane = SpacePlane::through(own.corners);
    const double light = space_.directional() ? -own.plane.normal.z : own.plane.offset;
    const int eyeSide = lines_.eyeSideOf(own.plane);
    own.dark = (of.casts[triangle] != 0 && light * eyeSide < 0.0) ||
               contactOf(inBatch, placeInObject(light_, of.worldFromBatch)).grazes;
    return own;
}

void IrregularZBuffer::findPlaces(const PixelRectangle& within, Threads threads) {
    constexpr std::size_t leastRows = 32, kept = 64; // triangles: neighbouring pixels show the same
                                                     // ones
    const auto parts = partsOf(static_cast<std::size_t>(within.height), leastRows, threads);
    forEachPart(parts, [&](std::size_t, const ItemRange& rows) {
        std::array<OwnTriangle, kept> known{};
        for (int y = within.y + static_cast<int>(rows.first);
             y < within.y + static_cast<int>(rows.end); ++y)
            for (int x = within.x; x < within.x + within.width; ++x) {
                const std::size_t i = indexOf(Pixel(x - seen_.area.x, y - seen_.area.y));
                const std::uint32_t number = seen_.numbers[i];
                if (number == 0) continue;
                OwnTriangle& own = known[number % kept];
                if (own.number != number) own = ownTriangle(number);
                if (own.dark)
                    shadowed_[i] = 255;
                else
                    places_[i] = lines_.placeOn(own.corners, own.plane, x, y);
            }
    });
}

template <class Use>
void IrregularZBuffer::forEachPoint(const PixelRectangle& of, int step, Use use) const {
    constexpr int block = 4; // pixels: keeps neighbours together
    const int right = of.x + of.width, top = of.y + of.height;
    for (int y0 = of.y; y0 < top; y0 += block)
        for (int x0 = of.x; x0 < right; x0 += block)
            for (int y = y0; y < std::min(y0 + block, top); y += step)
                for (int x = x0; x < std::min(x0 + block, right); x += step) {
                    const Pixel pixel(x - seen_.area.x, y - seen_.area.y);
                    const std::size_t i = indexOf(pixel);
                    if (seen_.numbers[i] == 0 || shadowed_[i] != 0) continue;
                    const glm::dvec3& place = places_[i];
                    const std::size_t face = space_.directional() ? 0 : faceAlong(place);
                    use(pixel, face, space_.directional() ? raysOn(place) : raysOn(face, place));
                }
}

void IrregularZBuffer::addPoints(const PixelRectangle& within, Threads threads) {
    constexpr std::size_t leastRows = 128;
    const auto parts = partsOf(static_cast<std::size_t>(within.height), leastRows, threads);
    const auto rowsOf = [&](const ItemRange& range) {
        return PixelRectangle{within.x, within.y + static_cast<int>(range.first), within.width,
                              static_cast<int>(range.size())};
    };
    const auto framesOf = [&](int step) {
        std::vector<std::vector<Box>> extents(parts.size(), std::vector<Box>(faces_.size()));
        forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
            forEachPoint(rowsOf(range), step, [&](Pixel, std::size_t face, const glm::dvec3& rays) {
                extents[part][face].add(rays);
            });
        });
        std::vector<PointFrame> frames;
        for (std::size_t face = 0; face < faces_.size(); ++face) {
            Box all;
            for (const auto& of : extents)
                all.add(of[face]);
            frames.push_back(frameOf(all));
        }
        return frames;
    };
    std::vector<std::vector<std::vector<FacePoint>>> points; // by face and part
    // Returns false if some points are too far outside for floats.
    const auto put = [&](const std::vector<PointFrame>& frames) {
        points.assign(faces_.size(), std::vector<std::vector<FacePoint>>(parts.size()));
        std::atomic<bool> within2 = true;
        forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
            bool fit = true;
            forEachPoint(rowsOf(range), 1,
                         [&](Pixel pixel, std::size_t face, const glm::dvec3& rays) {
                             const glm::vec3 at(frames[face].of(rays));
                             fit = fit && std::abs(at.x) <= 2.0f && std::abs(at.y) <= 2.0f &&
                                   std::abs(at.z) <= 2.0f;
                             points[face][part].push_back({at, pixel});
                         });
            if (!fit) within2 = false;
        });
        return within2.load();
    };
    // A sample of points shows where most of them are.
    std::vector<PointFrame> frames = framesOf(4);
    if (!put(frames)) {
        frames = framesOf(1);
        put(frames);
    }
    for (std::size_t face = 0; face < faces_.size(); ++face)
        faces_[face].build(frames[face], points[face], threads);
}

void IrregularZBuffer::cast(std::span<const PlacedRuns> casters, Threads threads) {
    std::vector<std::size_t> first;
    std::vector<PlacedInLight> placed;
    std::size_t count = 0;
    for (const PlacedRuns& of : casters) {
        first.push_back(count);
        count += of.casters->runs().size();
        placed.push_back({of.casters, space_.fromBatch(of.worldFromBatch),
                          placeInObject(light_, of.worldFromBatch)});
    }
    constexpr std::size_t leastRuns = 8; // enough large triangles with many points each
    forEachPart(partsOf(count, leastRuns, threads), [&](std::size_t, const ItemRange& range) {
        Scratch scratch;
        std::size_t b = 0;
        for (std::size_t run = range.first; run < range.end; ++run) {
            while (b + 1 < first.size() && first[b + 1] <= run)
                ++b;
            castRun(placed[b], placed[b].casters->runs()[run - first[b]], scratch);
        }
    });
}

bool IrregularZBuffer::gatherFor(const Box& bounds, const glm::dmat4& lightFromBatch,
                                 Scratch& scratch) const {
    const glm::dmat3 turn(lightFromBatch);
    const glm::dvec3 middle(lightFromBatch * glm::dvec4(bounds.center(), 1.0));
    const glm::dvec3 half = 0.5 * (bounds.high - bounds.low);
    const glm::dvec3 reach =
        glm::abs(turn[0]) * half.x + glm::abs(turn[1]) * half.y + glm::abs(turn[2]) * half.z;
    LightBox box{glm::vec3(middle - reach), glm::vec3(middle + reach)};
    const glm::vec3 most = glm::max(glm::abs(box.low), glm::abs(box.high));
    box = box.grown(directionRounding * std::max({most.x, most.y, most.z}));
    bool any = false;
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        PointTree::Groups& groups = scratch.groups[face];
        groups.clear();
        if (faces_[face].empty()) continue;
        const FaceExtent extent = space_.extentIn(face, box);
        if (extent.empty()) continue;
        const double highest = space_.directional()    ? -extent.nearest
                               : extent.nearest > 0.0f ? 1.0 / extent.nearest
                                                       : std::numeric_limits<double>::infinity();
        const PointFrame& frame = faces_[face].frame();
        const glm::vec3 low(frame.of(glm::dvec3(extent.low, highest)));
        const glm::vec3 high(frame.of(glm::dvec3(extent.high, highest)));
        faces_[face].gather(boxAround({low, high, high}), nullptr, groups);
        any = any || !groups.boxes.empty();
    }
    return any;
}

IrregularZBuffer::Vertex IrregularZBuffer::vertexAt(const glm::dvec3& place) const {
    Vertex vertex;
    vertex.place = place;
    if (!space_.directional()) vertex.face = faceAlong(vertex.place);
    vertex.own = glm::vec3(faces_[vertex.face].frame().of(
        space_.directional() ? raysOn(vertex.place) : raysOn(vertex.face, vertex.place)));
    return vertex;
}

void IrregularZBuffer::castRun(const PlacedInLight& placed, const CasterRuns::Run& run,
                               Scratch& scratch) {
    if (!gatherFor(run.bounds, placed.lightFromBatch, scratch)) return;
    const auto vertices = placed.casters->verticesOf(run);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        scratch.vertices[i] =
            vertexAt(glm::dvec3(placed.lightFromBatch * glm::dvec4(vertices[i], 1.0)));
    const bool nearLight = mayTouch(run.bounds, placed.lightInBatch);
    for (const CasterRuns::Triangle& of : placed.casters->trianglesOf(run)) {
        if (nearLight &&
            touches({vertices[of[0]], vertices[of[1]], vertices[of[2]]}, placed.lightInBatch))
            continue;
        const Triangle triangle{scratch.vertices[of[0]], scratch.vertices[of[1]],
                                scratch.vertices[of[2]]};
        if (triangle.onOneFace()) {
            cast(triangle, triangle.a.face, scratch);
            continue;
        }
        for (std::size_t face = 0; face < faces_.size(); ++face)
            cast(triangle, face, scratch);
    }
}

void IrregularZBuffer::cast(const Triangle& triangle, std::size_t face, Scratch& scratch) {
    const PointTree::Groups* groups = &scratch.groups[face];
    if (groups->boxes.empty()) return;
    const CasterBox box = boxOn(face, triangle);
    PointTree& tree = faces_[face];
    Corners corners;
    CasterPlanes planes;
    const bool alone = groups->boxes.size() > mostBoxes;
    const auto know = [&] {
        corners = cornersOf(triangle);
        planes = planesOn(face, corners);
    };
    if (alone) {
        know();
        tree.gather(box, &planes, scratch.own);
        groups = &scratch.own;
    }
    tree.find(
        *groups, box,
        [&]() -> const CasterPlanes& {
            if (!alone) know();
            return planes;
        },
        [&](Pixel pixel) { return isShadowed(corners, pixel); },
        [&](Pixel pixel) { shadowed_[indexOf(pixel)] = 255; });
}

CasterBox IrregularZBuffer::boxOn(std::size_t face, const Triangle& triangle) const {
    if (triangle.onOneFace()) return boxAround({triangle.a.own, triangle.b.own, triangle.c.own});
    std::array<glm::vec3, 3> own;
    const std::array<const Vertex*, 3> vertices = {&triangle.a, &triangle.b, &triangle.c};
    for (std::size_t i = 0; i < 3; ++i) {
        if (turnedTo(face, vertices[i]->place).z <= 0.0) return everything;
        own[i] = glm::vec3(faces_[face].frame().of(raysOn(face, vertices[i]->place)));
    }
    return boxAround(own);
}

IrregularZBuffer::Corners IrregularZBuffer::cornersOf(const Triangle& triangle) const {
    Corners corners;
    corners.places = {triangle.a.place, triangle.b.place, triangle.c.place};
    corners.plane = SpacePlane::through(corners.places);
    const double light = space_.directional() ? -corners.plane.normal.z : corners.plane.offset;
    corners.behind = light > 0.0 ? -1.0 : light < 0.0 ? 1.0 : 0.0;
    corners.perPlace = heightRounding * glm::length(corners.plane.normal);
    corners.rounding = corners.perPlace * glm::length(corners.places[0]);
    return corners;
}

CasterPlanes IrregularZBuffer::planesOn(std::size_t face, const Corners& corners) const {
    const PointFrame& frame = faces_[face].frame();
    CasterPlanes planes;
    // No point is behind a plane that the light is in.
    if (corners.behind == 0.0) return {HalfSpace{0.0f, 0.0f, 0.0f, -1.0f}};
    const bool directional = space_.directional();
    // Every second face mirrors.
    const double turned = !directional && face % 2 != 0 ? -corners.behind : corners.behind;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &a = corners.places[i], &b = corners.places[(i + 1) % 3];
        if (directional) {
            const glm::dvec3 normal(a.y - b.y, b.x - a.x, 0.0);
            planes[i] =
                inFrame(frame, turned * normal, -turned * (normal.x * a.x + normal.y * a.y));
        } else {
            // a x b, where rounding leaves little accuracy if the light is far away.
            const glm::dvec3 normal = turned * glm::cross(turnedTo(face, a), turnedTo(face, b - a));
            planes[i] = inFrame(frame, {normal.x, normal.y, 0.0}, normal.z);
        }
    }
    const SpacePlane& plane = corners.plane;
    if (directional) {
        const glm::dvec3 normal(plane.normal.x, plane.normal.y, -plane.normal.z);
        planes[3] = inFrame(frame, corners.behind * normal, corners.behind * plane.offset);
    } else {
        const glm::dvec3 normal = turnedTo(face, plane.normal);
        planes[3] = inFrame(frame, corners.behind * glm::dvec3(normal.x, normal.y, plane.offset),
                            corners.behind * normal.z);
    }
    return planes;
}

bool IrregularZBuffer::isShadowed(const Corners& corners, Pixel pixel) const {
    const glm::dvec3& place = places_[indexOf(pixel)];
    const double behind = corners.behind * corners.plane.heightOf(place);
    // Triangles in the plane of a point's own triangle, and that one itself, are not in front of
    // it.
    if (!(behind > corners.rounding + corners.perPlace * glm::length(place))) return false;
    const auto& [a, b, c] = corners.places;
    const bool directional = space_.directional();
    return corners.behind * edgeSide(a, b, place, directional) >= 0.0 &&
           corners.behind * edgeSide(b, c, place, directional) >= 0.0 &&
           corners.behind * edgeSide(c, a, place, directional) >= 0.0;
}

} // namespace edgeshade
