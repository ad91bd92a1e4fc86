#include "preprocess/mesh/tessellation.hpp"

#include <deque>
#include <GL/glu.h>
#include <memory>

namespace edgeshade {
namespace {

/// A corner as GLU takes it. It calls back with pointers to corners.
struct Corner {
    std::array<GLdouble, 3> place;
    std::uint32_t number;
};

/// GLU's tessellator with one polygon.
class Tessellator {
  public:
    /// Null: memory ran out.
    std::optional<Tessellation> divide(const std::vector<std::vector<glm::dvec3>>& loops,
                                       const glm::dvec3& normal, WindingRule rule) {
        if (!tess_) return std::nullopt;
        using Callback = void(GLAPIENTRY*)();
        const auto on = [&](GLenum event, Callback call) {
            gluTessCallback(tess_.get(), event, call);
        };
        on(GLU_TESS_VERTEX_DATA, reinterpret_cast<Callback>(&useCorner));
        on(GLU_TESS_COMBINE_DATA, reinterpret_cast<Callback>(&combine));
        on(GLU_TESS_ERROR_DATA, reinterpret_cast<Callback>(&note));
        // With this callback GLU makes triangles alone, no strips and fans.
        on(GLU_TESS_EDGE_FLAG, reinterpret_cast<Callback>(&ignoreFlag));
        gluTessProperty(tess_.get(), GLU_TESS_WINDING_RULE,
                        rule == WindingRule::odd ? GLU_TESS_WINDING_ODD : GLU_TESS_WINDING_NONZERO);
        gluTessNormal(tess_.get(), normal.x, normal.y, normal.z);
        gluTessBeginPolygon(tess_.get(), this);
        for (const std::vector<glm::dvec3>& loop : loops) {
            gluTessBeginContour(tess_.get());
            for (const glm::dvec3& at : loop) {
                Corner& corner = newCorner(at);
                gluTessVertex(tess_.get(), corner.place.data(), &corner);
            }
            gluTessEndContour(tess_.get());
        }
        gluTessEndPolygon(tess_.get());
        if (failed_) return std::nullopt;
        for (std::size_t i = 0; i + 2 < used_.size(); i += 3)
            made_.triangles.push_back({used_[i], used_[i + 1], used_[i + 2]});
        return std::move(made_);
    }

  private:
    struct Delete {
        void operator()(GLUtesselator* tess) const { gluDeleteTess(tess); }
    };

    Corner& newCorner(const glm::dvec3& at) {
        const auto number = static_cast<std::uint32_t>(corners_.size());
        return corners_.emplace_back(Corner{{at.x, at.y, at.z}, number});
    }

    static void GLAPIENTRY useCorner(void* corner, void* self) {
        static_cast<Tessellator*>(self)->used_.push_back(static_cast<Corner*>(corner)->number);
    }
    static void GLAPIENTRY combine(GLdouble place[3], void* [4], GLfloat[4], void** made,
                                   void* self) {
        auto& of = *static_cast<Tessellator*>(self);
        const glm::dvec3 at(place[0], place[1], place[2]);
        of.made_.added.push_back(at);
        *made = &of.newCorner(at);
    }
    static void GLAPIENTRY note(GLenum error, void* self) {
        if (error == GLU_OUT_OF_MEMORY) static_cast<Tessellator*>(self)->failed_ = true;
    }
    static void GLAPIENTRY ignoreFlag(GLboolean) {}

    std::unique_ptr<GLUtesselator, Delete> tess_{gluNewTess()};
    std::deque<Corner> corners_;      ///< by number; GLU keeps pointers to them
    std::vector<std::uint32_t> used_; ///< three for each triangle
    Tessellation made_;
    bool failed_ = false;
};

} // namespace

std::optional<Tessellation> tessellate(const std::vector<std::vector<glm::dvec3>>& loops,
                                       const glm::dvec3& normal, WindingRule rule) {
    return Tessellator().divide(loops, normal, rule);
}

} // namespace edgeshade
