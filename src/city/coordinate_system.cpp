#include "src/city/coordinate_system.hpp"

#include "preprocess/base/error.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

#ifdef EDGESHADE_HAS_GEOTIFF
#include <memory>
#include <proj.h>
#endif

namespace edgeshade::city {

#ifdef EDGESHADE_HAS_GEOTIFF

namespace {

/// Degrees of latitude over which north is measured: about ten metres.
constexpr double northward = 1e-4;

struct DeleteContext {
    void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct DeleteProjection {
    void operator()(PJ* projection) const { proj_destroy(projection); }
};

} // namespace

FramePlace placeInSystem(int epsg, const glm::dvec3& point) {
    const std::string code = "EPSG:" + std::to_string(epsg);
    const auto fail = [&](const std::string& what) {
        return InputError("--place auto: " + code + " " + what + "; type --place LAT,LON.");
    };
    const std::unique_ptr<PJ_CONTEXT, DeleteContext> context(proj_context_create());
    proj_log_level(context.get(), PJ_LOG_NONE);
    const std::unique_ptr<PJ, DeleteProjection> typed(
        proj_create_crs_to_crs(context.get(), code.c_str(), "EPSG:4326", nullptr));
    if (!typed) throw fail("is a coordinate system that PROJ doesn't know");
    // Axes become east and north, and longitude and latitude, whatever the code's own order is.
    const std::unique_ptr<PJ, DeleteProjection> projection(
        proj_normalize_for_visualization(context.get(), typed.get()));
    if (!projection) throw fail("has axes that PROJ can't put in order");
    const PJ_COORD at =
        proj_trans(projection.get(), PJ_FWD, proj_coord(point.x, point.y, point.z, 0.0));
    FramePlace found;
    found.place = {at.xy.y, at.xy.x};
    const PJ_COORD beyond =
        proj_trans(projection.get(), PJ_INV, proj_coord(at.xy.x, at.xy.y + northward, 0.0, 0.0));
    const double east = beyond.xy.x - point.x, north = beyond.xy.y - point.y;
    // The distance tells metres from degrees and feet.
    const double metres = std::hypot(east, north) / northward;
    if (!(std::abs(found.place.latitude) <= 90.0 && std::abs(found.place.longitude) <= 180.0) ||
        !(metres > 0.9 * 111e3 && metres < 1.1 * 111e3))
        throw fail("has no place on the ground in metres for the tiles' middle");
    found.north = glm::degrees(std::atan2(east, north));
    return found;
}

int horizontalSystemOf(int epsg) {
    const std::unique_ptr<PJ_CONTEXT, DeleteContext> context(proj_context_create());
    proj_log_level(context.get(), PJ_LOG_NONE);
    const std::unique_ptr<PJ, DeleteProjection> system(
        proj_create(context.get(), ("EPSG:" + std::to_string(epsg)).c_str()));
    if (!system || proj_get_type(system.get()) != PJ_TYPE_COMPOUND_CRS) return epsg;
    const std::unique_ptr<PJ, DeleteProjection> horizontal(
        proj_crs_get_sub_crs(context.get(), system.get(), 0));
    const char* const code = horizontal ? proj_get_id_code(horizontal.get(), 0) : nullptr;
    return code ? std::atoi(code) : epsg;
}

#else

FramePlace placeInSystem(int, const glm::dvec3&) {
    throw Error(ExitStatus::unavailable,
                "--place auto needs PROJ, but this program was built without libgeotiff and PROJ; "
                "type --place LAT,LON.");
}

int horizontalSystemOf(int epsg) {
    return epsg;
}

#endif

} // namespace edgeshade::city
