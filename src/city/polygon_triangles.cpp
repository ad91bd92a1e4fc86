#include "src/city/polygon_triangles.hpp"

#include "preprocess/base/error.hpp"

#include <deque>
#include <GL/glu.h>
#include <memory>

namespace edgeshade::city {
namespace {

/// Newell's normal of a ring, relative to its first corner.
glm::dvec3 normalOf(const std::vector<glm::dvec3>& ring) {
    glm::dvec3 normal(0.0);
    for (std::size_t i = 0; i < ring.size(); ++i)
        normal += glm::cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
    return normal;
}

/// One polygon in GLU's tessellator, relative to its first corner.
class PolygonTessellation {
  public:
    PolygonTessellation(const glm::dvec3& origin, const glm::dvec3& normal)
        : origin_(origin), tess_(gluNewTess()) {
        if (!tess_) fail();
        using Callback = void(GLAPIENTRY*)();
        const auto on = [&](GLenum event, Callback call) {
            gluTessCallback(tess_.get(), event, call);
        };
        on(GLU_TESS_VERTEX_DATA, reinterpret_cast<Callback>(&addCorner));
        on(GLU_TESS_COMBINE_DATA, reinterpret_cast<Callback>(&combine));
        on(GLU_TESS_ERROR_DATA, reinterpret_cast<Callback>(&note));
        // With this callback GLU makes triangles alone, no strips and fans.
        on(GLU_TESS_EDGE_FLAG, reinterpret_cast<Callback>(&ignoreFlag));
        gluTessProperty(tess_.get(), GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_ODD);
        gluTessNormal(tess_.get(), normal.x, normal.y, normal.z);
    }

    std::vector<std::array<glm::dvec3, 3>>
    trianglesOf(const std::vector<std::vector<glm::dvec3>>& rings) {
        gluTessBeginPolygon(tess_.get(), this);
        for (const std::vector<glm::dvec3>& ring : rings) {
            gluTessBeginContour(tess_.get());
            for (const glm::dvec3& corner : ring) {
                Place& place = places_.emplace_back(placeOf(corner - origin_));
                gluTessVertex(tess_.get(), place.data(), &place);
            }
            gluTessEndContour(tess_.get());
        }
        gluTessEndPolygon(tess_.get());
        if (failed_) fail();
        std::vector<std::array<glm::dvec3, 3>> triangles;
        for (std::size_t i = 0; i + 2 < corners_.size(); i += 3)
            triangles.push_back({corners_[i], corners_[i + 1], corners_[i + 2]});
        return triangles;
    }

  private:
    using Place = std::array<GLdouble, 3>;
    struct Delete {
        void operator()(GLUtesselator* tess) const { gluDeleteTess(tess); }
    };

    static Place placeOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
    [[noreturn]] static void fail() {
        throw Error(ExitStatus::unavailable, "There is no memory to triangulate a polygon.");
    }
    static void GLAPIENTRY addCorner(void* corner, void* self) {
        auto& of = *static_cast<PolygonTessellation*>(self);
        const Place& place = *static_cast<Place*>(corner);
        of.corners_.push_back(of.origin_ + glm::dvec3(place[0], place[1], place[2]));
    }
    static void GLAPIENTRY combine(GLdouble place[3], void* [4], GLfloat[4], void** made,
                                   void* self) {
        auto& of = *static_cast<PolygonTessellation*>(self);
        *made = &of.places_.emplace_back(Place{place[0], place[1], place[2]});
    }
    static void GLAPIENTRY note(GLenum error, void* self) {
        if (error == GLU_OUT_OF_MEMORY) static_cast<PolygonTessellation*>(self)->failed_ = true;
    }
    static void GLAPIENTRY ignoreFlag(GLboolean) {}

    glm::dvec3 origin_;
    std::unique_ptr<GLUtesselator, Delete> tess_;
    std::deque<Place> places_; ///< GLU keeps pointers to them
    std::vector<glm::dvec3> corners_;
    bool failed_ = false;
};

} // namespace

std::vector<std::array<glm::dvec3, 3>>
trianglesOf(const std::vector<std::vector<glm::dvec3>>& rings) {
    if (rings.empty() || rings.front().size() < 3) return {};
    if (rings.size() == 1 && rings.front().size() == 3)
        return {{rings[0][0], rings[0][1], rings[0][2]}};
    const glm::dvec3 normal = normalOf(rings.front());
    if (normal == glm::dvec3(0.0)) return {};
    return PolygonTessellation(rings.front().front(), normal).trianglesOf(rings);
}

} // namespace edgeshade::city
