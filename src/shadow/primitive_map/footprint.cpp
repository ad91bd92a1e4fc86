#include "src/shadow/primitive_map/footprint.hpp"

#include "preprocess/base/vectors.hpp"
#include "preprocess/mesh/components.hpp"
#include "src/shadow/geometry/polygon.hpp"
#include "src/shadow/lights/light_contact.hpp"
#include "src/shadow/lights/light_extent.hpp"
#include "src/shadow/lights/light_range.hpp"
#include "src/shadow/primitive_map/tile_spread.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace edgeshade {
namespace {

/// Slope from which no ray is distinguishable from the plane in floats.
constexpr double steepestPlane = 1e30;

/// Relative rounding error, in double precision, of a sum of such terms.
constexpr double rounding = 1e-14;

/// The maximum of dot(plane, ray) over the square's rays.
double mostOn(const glm::dvec3& plane, const RaySquare& square) {
    return std::max(plane.x * square.low.x, plane.x * square.high.x) +
           std::max(plane.y * square.low.y, plane.y * square.high.y) + plane.z;
}

/// The minimum of dot(plane, ray) over the square's rays.
double leastOn(const glm::dvec3& plane, const RaySquare& square) {
    return -mostOn(-plane, square);
}

/// The plane through the edge, scaled to a largest component of 1, the same for both neighbours.
glm::dvec3 edgePlane(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 plane = glm::cross(a, b);
    const double largest = largestComponent(plane);
    return largest > 0.0 ? plane / largest : plane;
}

/// For each edge of each triangle (three per triangle, from corner i to i + 1), whether
/// multiplicities of light-facing triangles, or of the others, don't cancel there.
std::vector<std::uint8_t> contoursOf(const CasterEdges& casters, const std::vector<int>& sides) {
    std::vector<std::uint8_t> contours(sides.size(), 0);
    for (const Edge& edge : casters.edges.edges) {
        int facing = 0, away = 0;
        const auto opposites = casters.edges.oppositesOf(edge);
        for (const Opposite& opposite : opposites) {
            const Triangle& triangle = casters.mesh.triangles[opposite.triangle];
            const int direction = directionIn(triangle, edge);
            if (sides[opposite.triangle] > 0) facing += direction;
            if (sides[opposite.triangle] < 0) away += direction;
        }
        if (facing == 0 && away == 0) continue;
        for (const Opposite& opposite : opposites) {
            const Triangle& triangle = casters.mesh.triangles[opposite.triangle];
            for (unsigned i = 0; i < 3; ++i)
                if (triangle[(i + 2) % 3] == opposite.vertex)
                    contours[opposite.triangle] |= static_cast<std::uint8_t>(1u << i);
        }
    }
    return contours;
}

/// The side (lightSideOf) of those triangles of a solid that are on a ray once: of entering
/// triangles, or of leaving ones if the light is within, by the solid angles that the triangles
/// fill (A. Van Oosterom and J. Strackee, "The Solid Angle of a Plane Triangle", 1983).
int sideMetOnce(const WeldedMesh& mesh, const glm::dvec4& light) {
    if (light.w == 0.0) return 1;
    const glm::dvec3 point(light);
    double angle = 0.0;
    for (const Triangle& triangle : mesh.triangles) {
        std::array<glm::dvec3, 3> to;
        for (std::size_t i = 0; i < 3; ++i)
            to[i] = glm::dvec3(mesh.positions[triangle[i]]) - point;
        const double a = glm::length(to[0]), b = glm::length(to[1]), c = glm::length(to[2]);
        angle += std::atan2(glm::dot(to[0], glm::cross(to[1], to[2])),
                            a * b * c + glm::dot(to[0], to[1]) * c + glm::dot(to[1], to[2]) * a +
                                glm::dot(to[2], to[0]) * b);
    }
    const bool within = std::abs(angle) > glm::pi<double>(); // half of it is 2 pi within, 0 outside
    return within && angle > 0.0 ? -1 : 1;
}

/// The plane of a triangle in map space; null if it is so steep that no ray certainly meets it.
std::optional<glm::dvec3> planeOf(const std::array<glm::dvec3, 3>& corners, bool directional) {
    const glm::dvec3& a = corners[0];
    const glm::dvec3 normal = glm::cross(corners[1] - a, corners[2] - a);
    glm::dvec3 plane;
    if (directional) {
        const glm::dvec2 slope = -glm::dvec2(normal) / normal.z;
        plane = {slope, a.z - slope.x * a.x - slope.y * a.y};
    } else {
        plane = normal / glm::dot(normal, a);
    }
    for (glm::length_t i = 0; i < 3; ++i)
        if (!(std::abs(plane[i]) < steepestPlane)) return std::nullopt;
    return plane;
}

void addOccluders(const Light& light, const LightTiles& tiles, const PlacedCasters& placed,
                  Occluders& occluders) {
    const WeldedMesh& mesh = placed.casters->mesh;
    const glm::dvec4 local = glm::inverse(placed.worldFromBatch) * light.position;
    const glm::dmat4 mapFromBatch = tiles.mapFromWorld * placed.worldFromBatch;
    const bool mirrored = glm::determinant(glm::dmat3(mapFromBatch)) < 0.0;
    const LightShape shape = shapeOf(light).in(glm::inverse(placed.worldFromBatch));
    const double range = light.extent ? INFINITY : rangeInObject(light, placed.worldFromBatch);
    std::vector<int> sides(mesh.triangles.size()), middles(mesh.triangles.size());
    for (std::size_t t = 0; t < sides.size(); ++t) {
        const Triangle& triangle = mesh.triangles[t];
        const std::array<glm::dvec3, 3> corners = {
            mesh.positions[triangle[0]], mesh.positions[triangle[1]], mesh.positions[triangle[2]]};
        middles[t] = lightSideOf(corners, local);
        sides[t] = tiles.shape ? sideOfAll(corners, shape) : middles[t];
        if (areBeyond(corners, glm::dvec3(local), range) || touches(corners, local)) sides[t] = 0;
    }
    const int met = placed.casters->tintedSolid ? sideMetOnce(mesh, local) : 0;
    const std::vector<std::uint8_t> contours = contoursOf(*placed.casters, sides);
    for (std::size_t t = 0; t < sides.size(); ++t) {
        if (sides[t] == 0 && !tiles.shape) continue;
        if (met != 0 && sides[t] != met) continue;
        const Triangle& triangle = mesh.triangles[t];
        Occluder occluder;
        std::array<glm::dvec3, 3> rays;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 position(mesh.positions[triangle[i]]);
            occluder.corners[i] = glm::dvec3(mapFromBatch * glm::dvec4(position, 1.0));
            rays[i] = occluder.corners[i];
            if (tiles.directional) rays[i].z = 1.0;
        }
        const auto plane = planeOf(occluder.corners, tiles.directional);
        if (!plane && !tiles.shape) continue;
        occluder.flat = !plane || middles[t] == 0;
        occluder.mixed = sides[t] == 0 || occluder.flat;
        occluder.plane = plane.value_or(glm::dvec3(0.0));
        // Seen from the light, map space makes a light-facing triangle clockwise unless mirrored.
        const bool inward = (middles[t] < 0) != mirrored;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const bool forward = triangle[i] < triangle[j];
            const glm::dvec3 edge =
                forward ? edgePlane(rays[i], rays[j]) : edgePlane(rays[j], rays[i]);
            occluder.takesEdge[i] = forward == inward;
            occluder.edges[i] = occluder.takesEdge[i] ? edge : -edge;
        }
        occluder.triangle = static_cast<std::uint32_t>(t);
        occluder.contours = contours[t];
        occluder.lightFacing = middles[t] > 0;
        if (!placed.casters->cutouts.empty()) {
            occluder.cutout = static_cast<std::uint32_t>(occluders.cutouts.size());
            occluders.cutouts.push_back(cutoutPlanesOf(placed.casters->cutouts[t], rays));
        }
        occluders.all.push_back(occluder);
    }
}

/// The part of the triangle in the tile's pyramid, which is grown slightly, and by the light's
/// extent.
Polygon partInTile(Polygon triangle, const TileSpread& spread) {
    constexpr double grown = 1.0 + 1e-3;
    triangle = clipped(triangle, {1, 0, grown}, spread.low().x);
    triangle = clipped(triangle, {-1, 0, grown}, spread.high().x);
    triangle = clipped(triangle, {0, 1, grown}, spread.low().y);
    return clipped(triangle, {0, -1, grown}, spread.high().y);
}

} // namespace

int lightSideOf(const std::array<glm::dvec3, 3>& corners, const glm::dvec4& light) {
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double side = glm::dot(normal, glm::dvec3(light) - light.w * corners[0]);
    return side > 0.0 ? 1 : side < 0.0 ? -1 : 0;
}

Occluders occludersOf(const Light& light, const LightTiles& tiles,
                      const std::vector<PlacedCasters>& casters) {
    Occluders occluders;
    std::size_t most = 0;
    for (const PlacedCasters& placed : casters)
        most += placed.cast ? placed.casters->mesh.triangles.size() : 0;
    occluders.all.reserve(most);
    for (const PlacedCasters& placed : casters)
        if (placed.cast) addOccluders(light, tiles, placed, occluders);
    return occluders;
}

std::optional<Footprint> footprintOf(const Occluder& occluder, std::uint32_t index,
                                     const LightTiles& tiles, std::size_t tile) {
    Footprint print;
    print.occluder = index;
    const glm::dmat3& axes = tiles.tiles[tile];
    std::array<glm::dvec3, 3> rays;
    Polygon triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        rays[i] = tiles.rayTo(tile, occluder.corners[i]);
        triangle.add(rays[i]);
        print.edges[i] = occluder.edges[i] * axes;
        if (!tiles.directional) continue;
        print.depths.add(occluder.corners[i].z);
    }
    print.plane = occluder.plane * axes;
    print.endsKnown = rays[0].z > 0.0 && rays[1].z > 0.0 && rays[2].z > 0.0;
    for (std::size_t i = 0; i < 3 && print.endsKnown; ++i)
        print.ends[i] = glm::dvec2(rays[i]) / rays[i].z;
    print.flat = occluder.flat;
    print.low = glm::dvec2(INFINITY);
    print.high = glm::dvec2(-INFINITY);
    const TileSpread spread(tiles, tile);
    const Polygon part = tiles.directional ? triangle : partInTile(triangle, spread);
    for (std::size_t i = 0; i < part.count; ++i) {
        const glm::dvec3& point = part.corners[i];
        if (!tiles.directional) print.depths.add(point.z);
        // A point behind the light is not in the tile, and one at the light is everywhere in it.
        const glm::dvec2 at = point.z > 0.0 ? glm::dvec2(point) / point.z : glm::dvec2(0.0);
        print.low = glm::min(print.low, at);
        print.high = glm::max(print.high, at);
    }
    if (part.count == 0) return std::nullopt;
    print.nearLight = spread.any() && print.depths.low <= spread.nearestTold();
    // A light with an extent may see points behind its middle.
    const double behind = spread.any() ? -spread.nearestTold() : 0.0;
    if (!tiles.directional && !(print.depths.high > behind)) return std::nullopt;
    return print;
}

bool Footprint::mayTouch(const RaySquare& square) const {
    if (high.x < square.low.x || low.x > square.high.x || high.y < square.low.y ||
        low.y > square.high.y)
        return false;
    if (flat) return true;
    return std::all_of(edges.begin(), edges.end(),
                       [&](const glm::dvec3& edge) { return mostOn(edge, square) >= -rounding; });
}

bool Footprint::mayCross(int i, const RaySquare& square) const {
    const glm::dvec3& edge = edges[static_cast<std::size_t>(i)];
    if (mostOn(edge, square) < -rounding || leastOn(edge, square) > rounding) return false;
    if (!endsKnown) return true;
    const glm::dvec2 &a = ends[static_cast<std::size_t>(i)],
                     &b = ends[static_cast<std::size_t>((i + 1) % 3)];
    return std::max(a.x, b.x) >= square.low.x && std::min(a.x, b.x) <= square.high.x &&
           std::max(a.y, b.y) >= square.low.y && std::min(a.y, b.y) <= square.high.y;
}

std::optional<bool> Footprint::covers(const glm::dvec3& ray, const Occluder& of) const {
    bool inside = true;
    int doubtful = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        // The same products in the same order for both neighbours, so that only the sign differs.
        const double side = edges[i].x * ray.x + edges[i].y * ray.y + edges[i].z * ray.z;
        inside = inside && (side > 0.0 || (side == 0.0 && of.takesEdge[i]));
        if (side < -rounding) return false;
        if (side <= rounding) ++doubtful;
    }
    if (doubtful > 1) return std::nullopt;
    return inside;
}

Interval Footprint::depthsIn(const RaySquare& square, bool directional) const {
    if (flat) return depths;
    const double terms = std::abs(plane.x) + std::abs(plane.y) + std::abs(plane.z);
    Interval here{leastOn(plane, square) - rounding * terms,
                  mostOn(plane, square) + rounding * terms};
    if (!directional) { // the inverse of a depth is linear along the plane
        const double nearest = here.high > 0.0 ? 1.0 / here.high : 0.0;
        here = {nearest, here.low > 0.0 ? 1.0 / here.low : INFINITY};
    }
    return {std::clamp(here.low, depths.low, depths.high),
            std::clamp(here.high, depths.low, depths.high)};
}

} // namespace edgeshade
