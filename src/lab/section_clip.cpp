#include "src/lab/section_clip.hpp"

namespace edgeshade::lab {
namespace {

struct Corner {
    glm::dvec3 at;
    glm::dvec2 place; ///< see EyeTriangle::places
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
        const double from = heightOver(plane, a.at), to = heightOver(plane, b.at);
        if (from >= 0.0) part.push_back(a);
        if ((from >= 0.0) == (to >= 0.0)) continue;
        const double share = from / (from - to);
        part.push_back({a.at + share * (b.at - a.at), a.place + share * (b.place - a.place)});
    }
    return part;
}

/// Adds a convex polygon as a fan of triangles.
void addFan(const Polygon& polygon, EyeTriangle like, std::vector<EyeTriangle>& to) {
    like.isCut = true;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        like.a = polygon[0].at;
        like.b = polygon[i].at;
        like.c = polygon[i + 1].at;
        like.places = {polygon[0].place, polygon[i].place, polygon[i + 1].place};
        to.push_back(like);
    }
}

} // namespace

SectionClip::SectionClip(const Section& section, const glm::dvec3& eye)
    : castsWhole_(section.shadows == SectionShadows::whole) {
    for (const glm::dvec4& plane : section.planes)
        planes_.emplace_back(glm::dvec3(plane), heightOver(plane, eye));
}

void SectionClip::add(const EyeTriangle& triangle, std::vector<EyeTriangle>& to) const {
    Polygon kept = {{triangle.a, triangle.places[0]},
                    {triangle.b, triangle.places[1]},
                    {triangle.c, triangle.places[2]}};
    bool isWhole = true;
    for (const glm::dvec4& plane : planes_) {
        int below = 0;
        for (const Corner& corner : kept)
            below += heightOver(plane, corner.at) < 0.0 ? 1 : 0;
        if (below == 0) continue;
        isWhole = false;
        if (castsWhole_ && triangle.casts) {
            EyeTriangle away = triangle;
            away.visible = false;
            addFan(above(-plane, kept), away, to);
        }
        kept = above(plane, kept);
    }
    if (isWhole)
        to.push_back(triangle);
    else
        addFan(kept, triangle, to);
}

} // namespace edgeshade::lab
