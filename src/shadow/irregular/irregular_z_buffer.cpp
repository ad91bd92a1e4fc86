#include "src/shadow/irregular/irregular_z_buffer.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Rounding of a depth on its way through a rasteriser's floats.
constexpr double depthRounding = 0x1p-21;

/// What rounding may do to an own coordinate of a FaceFrame, where it is 1.
constexpr float faceRounding = 0x1p-20f;

/// Triangles whose points are looked for together, and in how many boxes of groups at most.
constexpr std::size_t runLength = 32, mostBoxes = 12;

std::size_t faceAlong(const glm::dvec3& place) {
    const glm::dvec3 size = glm::abs(place);
    const glm::length_t axis =
        size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<std::size_t>(2 * axis + (place[axis] < 0.0 ? 1 : 0));
}

/// What a vector around a point light is across a face and along its axis.
glm::dvec3 turnedTo(std::size_t face, const glm::dvec3& vector) {
    const auto axis = static_cast<glm::length_t>(face / 2);
    return {vector[(axis + 1) % 3], vector[(axis + 2) % 3],
            face % 2 != 0 ? -vector[axis] : vector[axis]};
}

/// The ray and the height of a place on a face of a point light: planes are planes there too.
glm::dvec3 raysOn(std::size_t face, const glm::dvec3& place) {
    const glm::dvec3 turned = turnedTo(face, place);
    const double height = 1.0 / turned.z;
    return {turned.x * height, turned.y * height, height};
}

/// The same of a directional light.
glm::dvec3 raysOn(const glm::dvec3& place) {
    return {place.x, place.y, -place.z};
}

/// Which side of the line through a and b, as the light sees it, p is on. Of b and a the same with
/// the other sign, bit for bit: triangles that share an edge agree on it.
double edgeSide(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p, bool directional) {
    const glm::dvec3 from = a - p, to = b - p;
    return directional ? from.x * to.y - from.y * to.x : glm::dot(glm::cross(from, to), p);
}

/// normal . rays + offset >= 0 in the frame's own coordinates, with room for rounding.
HalfSpace inFrame(const FaceFrame& frame, const glm::dvec3& normal, double offset) {
    const glm::dvec3 own = normal / frame.scale;
    const double d = offset + glm::dot(normal, frame.middle);
    const double size = std::abs(own.x) + std::abs(own.y) + std::abs(own.z) + std::abs(d);
    if (!(size > 0.0) || !std::isfinite(size)) return {0.0f, 0.0f, 0.0f, 1.0f};
    return {static_cast<float>(own.x / size), static_cast<float>(own.y / size),
            static_cast<float>(own.z / size), static_cast<float>(d / size) + faceRounding};
}

float above(float value) {
    return value + faceRounding * (1.0f + std::abs(value));
}

float below(float value) {
    return value - faceRounding * (1.0f + std::abs(value));
}

CasterBox boxAround(const std::array<glm::vec3, 3>& places) {
    const glm::vec3 low = glm::min(glm::min(places[0], places[1]), places[2]);
    const glm::vec3 high = glm::max(glm::max(places[0], places[1]), places[2]);
    return {below(low.x), above(high.x), below(low.y), above(high.y), above(high.z)};
}

constexpr CasterBox everything{-CasterBox::infinity, CasterBox::infinity, -CasterBox::infinity,
                               CasterBox::infinity, CasterBox::infinity};

/// Where points are on a face.
struct Extent {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    std::size_t count = 0;

    void add(const glm::dvec3& rays) {
        low = glm::min(low, rays);
        high = glm::max(high, rays);
        ++count;
    }
    FaceFrame frame() const {
        return {0.5 * (low + high),
                2.0 / glm::max(high - low, glm::dvec3(std::numeric_limits<double>::min()))};
    }
};

} // namespace

/// What tells whether a triangle is between a point and the light.
struct IrregularZBuffer::Corners {
    std::array<glm::dvec3, 3> places;
    SpacePlane plane;
    double behind;    ///< times a height over the plane: above 0 where the light isn't
    SeenPlane seen;
    bool litSideSeen; ///< eye and light are on one side
    double tolerance; ///< of what is left
};

IrregularZBuffer::IrregularZBuffer(const DepthPicture& depths, const FrameView& view,
                                   const DepthSlice& slice, const Light& light,
                                   const PixelRectangle& reach, int subpixelBits)
    : depths_(depths), space_(light, view.frustum.position()), lines_(view, slice, space_),
      depthError_(std::ldexp(2.0, -depths.bits) + depthRounding),
      snapError_(std::ldexp(1.0, -subpixelBits)), faces_(space_.faceCount()),
      shadowed_(depths.depths.size(), 0) {
    addPoints(intersection(reach, {0, 0, depths.width, depths.height}));
}

void IrregularZBuffer::addPoints(const PixelRectangle& within) {
    constexpr int block = 4; // pixels: neighbours stay neighbours
    const auto forEachPoint = [&](auto use) {
        for (int y0 = within.y; y0 < within.y + within.height; y0 += block)
            for (int x0 = within.x; x0 < within.x + within.width; x0 += block)
                for (int y = y0; y < std::min(y0 + block, within.y + within.height); ++y)
                    for (int x = x0; x < std::min(x0 + block, within.x + within.width); ++x) {
                        const auto pixel = static_cast<std::uint32_t>(y * depths_.width + x);
                        const double left = leftOf(pixel);
                        if (left == 0.0) continue;
                        const glm::dvec3 place = lines_.placeOf(x, y, left);
                        const std::size_t face = space_.directional() ? 0 : faceAlong(place);
                        use(pixel, face,
                            space_.directional() ? raysOn(place) : raysOn(face, place));
                    }
    };
    std::vector<Extent> extents(faces_.size());
    forEachPoint([&](std::uint32_t, std::size_t face, const glm::dvec3& rays) {
        extents[face].add(rays);
    });
    std::vector<FaceFrame> frames;
    std::vector<std::vector<FacePoint>> points(faces_.size());
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        frames.push_back(extents[face].frame());
        points[face].reserve(extents[face].count);
    }
    forEachPoint([&](std::uint32_t pixel, std::size_t face, const glm::dvec3& rays) {
        const glm::dvec3 own = frames[face].of(rays);
        points[face].push_back({static_cast<float>(own.x), static_cast<float>(own.y),
                                static_cast<float>(own.z), pixel});
    });
    for (std::size_t face = 0; face < faces_.size(); ++face)
        faces_[face].build(frames[face], points[face]);
}

std::vector<IrregularZBuffer::Vertex> IrregularZBuffer::placed(const PlacedTriangles& triangles,
                                                               Threads threads) const {
    std::vector<Vertex> vertices(triangles.positions.size());
    forEachItem(vertices.size(), itemsOfThread, threads, [&](std::size_t i) {
        Vertex& vertex = vertices[i];
        vertex.place = space_.of(
            glm::dvec3(triangles.worldFromBatch * glm::dvec4(triangles.positions[i], 1.0)));
        vertex.face = space_.directional() ? 0 : faceAlong(vertex.place);
        const glm::dvec3 own = faces_[vertex.face].frame().of(
            space_.directional() ? raysOn(vertex.place) : raysOn(vertex.face, vertex.place));
        vertex.u = static_cast<float>(own.x);
        vertex.v = static_cast<float>(own.y);
        vertex.height = static_cast<float>(own.z);
    });
    return vertices;
}

void IrregularZBuffer::cast(const PlacedTriangles& triangles, Threads threads) {
    const std::vector<Vertex> vertices = placed(triangles, threads);
    const auto parts = partsOf(triangles.indices.size() / 3, itemsOfThread / 4, threads);
    forEachPart(parts, [&](std::size_t, const ItemRange& range) {
        Scratch scratch;
        for (std::size_t first = range.first; first < range.end; first += runLength) {
            scratch.triangles.clear();
            for (std::size_t t = first; t < std::min(first + runLength, range.end); ++t) {
                const std::uint32_t* of = &triangles.indices[3 * t];
                scratch.triangles.push_back(
                    {&vertices[of[0]], &vertices[of[1]], &vertices[of[2]]});
            }
            castRun(scratch);
        }
    });
}

void IrregularZBuffer::castRun(Scratch& scratch) {
    std::array<CasterBox, 6> around;
    for (Triangle& triangle : scratch.triangles) {
        if (!triangle.onOneFace()) {
            for (std::size_t face = 0; face < faces_.size(); ++face)
                if (!faces_[face].empty())
                    castAlone(triangle, face, boxOn(face, triangle), scratch);
            continue;
        }
        const auto at = [](const Vertex* of) { return glm::vec3(of->u, of->v, of->height); };
        triangle.box = boxAround({at(triangle.a), at(triangle.b), at(triangle.c)});
        triangle.waits = true;
        around[triangle.a->face].add(triangle.box);
    }
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        if (around[face].u0 > around[face].u1) continue;
        PointTree& tree = faces_[face];
        PointTree::Groups& groups = scratch.groups;
        tree.gather(around[face], nullptr, groups);
        if (groups.boxes.empty()) continue;
        const bool together = groups.boxes.size() <= mostBoxes;
        for (const Triangle& triangle : scratch.triangles) {
            if (!triangle.waits || triangle.a->face != face) continue;
            if (!together) {
                castAlone(triangle, face, triangle.box, scratch);
                continue;
            }
            Corners corners;
            tree.find(
                groups, triangle.box,
                [&] {
                    corners = cornersOf(triangle);
                    return planesOn(face, corners);
                },
                [&](std::uint32_t pixel) { return isShadowed(corners, pixel); },
                [&](std::uint32_t pixel) { shadowed_[pixel] = 255; });
        }
    }
}

void IrregularZBuffer::castAlone(const Triangle& triangle, std::size_t face, const CasterBox& box,
                                 Scratch& scratch) {
    PointTree& tree = faces_[face];
    const Corners corners = cornersOf(triangle);
    const CasterPlanes planes = planesOn(face, corners);
    tree.gather(box, &planes, scratch.groups);
    tree.find(
        scratch.groups, box, [&] { return planes; },
        [&](std::uint32_t pixel) { return isShadowed(corners, pixel); },
        [&](std::uint32_t pixel) { shadowed_[pixel] = 255; });
}

CasterBox IrregularZBuffer::boxOn(std::size_t face, const Triangle& triangle) const {
    std::array<glm::vec3, 3> places;
    const std::array<const Vertex*, 3> vertices = {triangle.a, triangle.b, triangle.c};
    for (std::size_t i = 0; i < 3; ++i) {
        if (turnedTo(face, vertices[i]->place).z <= 0.0) return everything;
        places[i] = glm::vec3(faces_[face].frame().of(raysOn(face, vertices[i]->place)));
    }
    return boxAround(places);
}

IrregularZBuffer::Corners IrregularZBuffer::cornersOf(const Triangle& triangle) const {
    Corners corners;
    corners.places = {triangle.a->place, triangle.b->place, triangle.c->place};
    const auto& [a, b, c] = corners.places;
    corners.plane.normal = glm::cross(b - a, c - a);
    corners.plane.offset = -glm::dot(corners.plane.normal, a);
    const double light =
        space_.directional() ? -corners.plane.normal.z : corners.plane.offset;
    corners.behind = light > 0.0 ? -1.0 : light < 0.0 ? 1.0 : 0.0;
    corners.seen = lines_.seen(corners.plane);
    corners.litSideSeen = corners.seen.eyeSide != 0 && (light > 0.0) == (corners.seen.eyeSide > 0);
    corners.tolerance = depthError_ + snapError_ * (std::abs(corners.seen.perColumn) +
                                                    std::abs(corners.seen.perRow));
    return corners;
}

CasterPlanes IrregularZBuffer::planesOn(std::size_t face, const Corners& corners) const {
    const FaceFrame& frame = faces_[face].frame();
    CasterPlanes planes;
    // Nothing is behind a plane that the light is in.
    if (corners.behind == 0.0) return {HalfSpace{0.0f, 0.0f, 0.0f, -1.0f}};
    const bool directional = space_.directional();
    // Every other face mirrors.
    const double turned = !directional && face % 2 != 0 ? -corners.behind : corners.behind;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &a = corners.places[i], &b = corners.places[(i + 1) % 3];
        if (directional) {
            const glm::dvec3 normal(a.y - b.y, b.x - a.x, 0.0);
            planes[i] = inFrame(frame, turned * normal,
                                -turned * (normal.x * a.x + normal.y * a.y));
        } else {
            const glm::dvec3 normal = turned * glm::cross(turnedTo(face, a), turnedTo(face, b));
            planes[i] = inFrame(frame, {normal.x, normal.y, 0.0}, normal.z);
        }
    }
    // Where the lit side isn't seen, points that are taken to be before the plane may be behind it.
    const SpacePlane& plane = corners.plane;
    if (!corners.litSideSeen) {
        planes[3] = {0.0f, 0.0f, 0.0f, 1.0f};
    } else if (directional) {
        const glm::dvec3 normal(plane.normal.x, plane.normal.y, -plane.normal.z);
        planes[3] = inFrame(frame, corners.behind * normal, corners.behind * plane.offset);
    } else {
        const glm::dvec3 normal = turnedTo(face, plane.normal);
        planes[3] = inFrame(frame, corners.behind * glm::dvec3(normal.x, normal.y, plane.offset),
                            corners.behind * normal.z);
    }
    return planes;
}

bool IrregularZBuffer::isShadowed(const Corners& corners, std::uint32_t pixel) const {
    const int x = static_cast<int>(pixel % static_cast<std::uint32_t>(depths_.width));
    const int y = static_cast<int>(pixel / static_cast<std::uint32_t>(depths_.width));
    const double left = leftOf(pixel);
    if (corners.seen.eyeSide != 0) {
        const double behind = corners.seen.leftAt(x, y) - left;
        const bool before =
            behind <= 0.0 || (behind <= corners.tolerance &&
                              lines_.meets(x, y, corners.places, snapError_));
        if (before == corners.litSideSeen) return false;
    }
    const glm::dvec3 place = lines_.placeOf(x, y, left);
    if (corners.seen.eyeSide == 0 && corners.behind * corners.plane.heightOf(place) <= 0.0)
        return false;
    const auto& [a, b, c] = corners.places;
    const bool directional = space_.directional();
    return corners.behind * edgeSide(a, b, place, directional) >= 0.0 &&
           corners.behind * edgeSide(b, c, place, directional) >= 0.0 &&
           corners.behind * edgeSide(c, a, place, directional) >= 0.0;
}

} // namespace edgeshade
