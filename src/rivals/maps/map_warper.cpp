#include "src/rivals/maps/map_warper.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {

void MapWarper::fit(ShadowMapView& view, double margin) {
    std::vector<glm::dvec2> places;
    places.reserve(visible_.size());
    for (const glm::dvec3& place : visible_)
        places.emplace_back(view.mapFromWorld * glm::dvec4(place, 1.0));
    MapWarp warp = mapWarp(grid_, places, margin);
    if (warp != warp_ || revision_ == 0) {
        warp_ = std::move(warp);
        ++revision_;
    }
    view.revision = revision_;
    view.faces = {{glm::dmat4(1.0), true}}; // no projection: cut casters are already in place
}

const WarpedCasters& MapWarper::cut(const GpuScene& scene, const ShadowMapView& view) {
    if (!table_) table_.emplace();
    table_->fill(warp_);
    casters_ = WarpedCasters(scene, view.mapFromWorld, warp_);
    return casters_;
}

void MapWarper::set(const gl::Program& program, int unit) const {
    program.setTexture("u_warp", unit, table_->texture());
    program.set("u_warpInner", glm::vec4(warp_.inner()));
    program.set("u_warpOuter", glm::vec4(warp_.outer()));
}

} // namespace edgeshade
