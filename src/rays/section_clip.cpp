#include "src/rays/section_clip.hpp"

#include "preprocess/section/geometry_cut.hpp"

#include <algorithm>

namespace edgeshade::rays {
namespace {

struct Corner {
    glm::dvec3 at; ///< relative to the eye
    glm::dvec3 inBatch;
    glm::dvec2 place; ///< see SurfaceTriangle::places
};
using Polygon = std::vector<Corner>;

double heightOver(const glm::dvec4& plane, const glm::dvec3& at) {
    return glm::dot(glm::dvec3(plane), at) + plane.w;
}

/// The part of a convex polygon on a plane's upper side (Sutherland and Hodgman 1974).
Polygon above(const glm::dvec4& plane, const Polygon& polygon) {
    Polygon part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double from = heightOver(plane, a.inBatch), to = heightOver(plane, b.inBatch);
        if (from >= 0.0) part.push_back(a);
        if ((from >= 0.0) == (to >= 0.0)) continue;
        const double share = from / (from - to);
        part.push_back({a.at + share * (b.at - a.at), a.inBatch + share * (b.inBatch - a.inBatch),
                        a.place + share * (b.place - a.place)});
    }
    return part;
}

/// Adds a convex polygon as a fan of triangles.
void addFan(const Polygon& polygon, SurfaceTriangle like, std::vector<SurfaceTriangle>& to) {
    like.isCut = true;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        like.a = polygon[0].at;
        like.b = polygon[i].at;
        like.c = polygon[i + 1].at;
        like.places = {polygon[0].place, polygon[i].place, polygon[i + 1].place};
        to.push_back(like);
    }
}

/// Whether the polygon lies in the plane and its front faces the kept side.
bool boundsWhatIsBelow(const glm::dvec4& plane, const Polygon& polygon) {
    for (const Corner& corner : polygon)
        if (heightOver(plane, corner.inBatch) != 0.0) return false;
    const glm::dvec3 a = polygon[0].inBatch, b = polygon[1].inBatch, c = polygon[2].inBatch;
    return glm::dot(glm::dvec3(plane), glm::cross(b - a, c - a)) > 0.0;
}

} // namespace

SectionClip::SectionClip(const Section& section, const glm::dmat4& worldFromBatch)
    : castsWhole_(section.shadows == SectionShadows::whole) {
    for (const glm::dvec4& plane : section.planes)
        planes_.push_back(planeInBatch(plane, worldFromBatch));
}

void SectionClip::add(const SurfaceTriangle& triangle, bool solid,
                      std::vector<SurfaceTriangle>& to) const {
    const auto corners = cornersInBatch(triangle);
    Polygon kept = {{triangle.a, corners[0], triangle.places[0]},
                    {triangle.b, corners[1], triangle.places[1]},
                    {triangle.c, corners[2], triangle.places[2]}};
    bool isWhole = true;
    for (const glm::dvec4& plane : planes_) {
        if (kept.size() < 3) return;
        const auto isBelow = [&](const Corner& corner) {
            return heightOver(plane, corner.inBatch) < 0.0;
        };
        const bool bounds = solid && boundsWhatIsBelow(plane, kept);
        if (!bounds && std::none_of(kept.begin(), kept.end(), isBelow)) continue;
        isWhole = false;
        if (castsWhole_ && triangle.casts) {
            SurfaceTriangle away = triangle;
            away.visible = false;
            addFan(bounds ? kept : above(-plane, kept), away, to);
        }
        kept = bounds ? Polygon() : above(plane, kept);
    }
    if (isWhole)
        to.push_back(triangle);
    else
        addFan(kept, triangle, to);
}

} // namespace edgeshade::rays
