#include "src/rays/ray_tree.hpp"

#include "preprocess/base/parallel.hpp"
#include "preprocess/base/vectors.hpp"
#include "src/rays/embree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace edgeshade::rays {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Half a unit in the last place of a float at 1.
constexpr double floatUnit = 0x1p-24;
/// How much wider than a triangle its box is, on each side, where all coordinates are at most 1:
/// the sum of all roundings between an exact ray and Embree's test of a box is less than half of it
/// (docs/method.md, C56).
constexpr double padding = 32.0 * floatUnit;
/// Coordinates up to which an origin counts as within the tree's box.
constexpr double largestOrigin = 1.0 + 2.0 * padding;
/// Coordinates up to which doubles move an origin to the tree's box with errors far below
/// `padding`.
constexpr double farthestOrigin = 0x1p20;

/// One ray's search, as the callback sees it.
struct Search {
    embree::Context context; // first member: Embree passes on its address
    const std::function<bool(std::uint32_t)>* visit = nullptr; ///< null: of a packet
    const std::function<double(std::uint32_t)>* visitInOrder = nullptr;
    double scale = 1.0, offset = 0.0; ///< Embree's distance: t * scale - offset
    RayTree::Test test = nullptr;
    void* state = nullptr;
};

/// Where a ray's search ends, of a length in the tree's coordinates: rounding included.
float endOf(double length) {
    return static_cast<float>(std::min(length + padding * (1.0 + std::abs(length)), 1e9));
}

RTCRay rayOf(const glm::dvec3& start, const glm::dvec3& along) {
    RTCRay ray{};
    ray.org_x = static_cast<float>(start.x);
    ray.org_y = static_cast<float>(start.y);
    ray.org_z = static_cast<float>(start.z);
    ray.dir_x = static_cast<float>(along.x);
    ray.dir_y = static_cast<float>(along.y);
    ray.dir_z = static_cast<float>(along.z);
    ray.mask = ~0u;
    return ray;
}

} // namespace

struct RayTree::Data {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<std::uint32_t> triangles; ///< by Embree's number
    std::span<const Corners> corners;     ///< while building
    glm::dvec3 center{0.0};
    double scale = 1.0; ///< a power of two; places in the tree: (p - center) * scale, at most 1

    Data(std::span<const Corners> all, std::vector<std::uint32_t> which);
    ~Data() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Data(const Data&) = delete;
    Data& operator=(const Data&) = delete;

    glm::dvec3 local(const glm::dvec3& place) const { return (place - center) * scale; }

    static void bounds(const RTCBoundsFunctionArguments* arguments);
    static void offer(const RTCOccludedFunctionNArguments* arguments);
    static void offerInOrder(const RTCIntersectFunctionNArguments* arguments);
};

RayTree::Data::Data(std::span<const Corners> all, std::vector<std::uint32_t> which)
    : triangles(std::move(which)), corners(all) {
    std::erase_if(triangles, [&](std::uint32_t i) {
        return !std::all_of(corners[i].begin(), corners[i].end(),
                            [](const glm::dvec3& corner) { return isFinite(corner); });
    });
    Box box;
    for (const std::uint32_t i : triangles)
        for (const glm::dvec3& corner : corners[i])
            box.add(corner);
    if (!box.empty()) {
        center = 0.5 * box.low + 0.5 * box.high;
        const double reach =
            std::max(largestComponent(box.low - center), largestComponent(box.high - center));
        if (reach > 0.0) scale = std::ldexp(1.0, -std::ilogb(reach) - 1);
    }

    const std::string threads = "threads=" + std::to_string(Threads::available());
    device = rtcNewDevice(threads.c_str());
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    if (!triangles.empty()) {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(triangles.size()));
        rtcSetGeometryUserData(geometry, this);
        rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
        rtcSetGeometryOccludedFunction(geometry, offer);
        rtcSetGeometryIntersectFunction(geometry, offerInOrder);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene);
    corners = {};
}

void RayTree::Data::bounds(const RTCBoundsFunctionArguments* arguments) {
    const Data& data = *static_cast<const Data*>(arguments->geometryUserPtr);
    Box box;
    for (const glm::dvec3& corner : data.corners[data.triangles[arguments->primID]])
        box.add(data.local(corner));
    const glm::vec3 low(box.low - padding), high(box.high + padding);
    RTCBounds& bounds = *arguments->bounds_o;
    bounds.lower_x = low.x;
    bounds.lower_y = low.y;
    bounds.lower_z = low.z;
    bounds.upper_x = high.x;
    bounds.upper_y = high.y;
    bounds.upper_z = high.z;
}

void RayTree::Data::offer(const RTCOccludedFunctionNArguments* arguments) {
    const Data& data = *static_cast<const Data*>(arguments->geometryUserPtr);
    const auto* search = reinterpret_cast<const Search*>(arguments->context);
    const std::uint32_t triangle = data.triangles[arguments->primID];
    Lanes done = 0;
    if (search->visit)
        done = (*search->visit)(triangle) ? 1 : 0;
    else
        done = search->test(search->state, triangle);
    if (done == 0) return;
    for (unsigned i = 0; i < arguments->N; ++i) {
        const unsigned ray = RTCRayN_id(arguments->ray, arguments->N, i);
        if (arguments->valid[i] != 0 && (done >> ray & 1) != 0)
            RTCRayN_tfar(arguments->ray, arguments->N, i) = -infinity;
    }
}

void RayTree::Data::offerInOrder(const RTCIntersectFunctionNArguments* arguments) {
    const Data& data = *static_cast<const Data*>(arguments->geometryUserPtr);
    const auto* search = reinterpret_cast<const Search*>(arguments->context);
    const double length = (*search->visitInOrder)(data.triangles[arguments->primID]);
    float& end = RTCRayN_tfar(RTCRayHitN_RayN(arguments->rayhit, arguments->N), arguments->N, 0);
    end = std::min(end, endOf(length * search->scale - search->offset));
}

RayTree::RayTree(std::span<const Corners> corners, std::vector<std::uint32_t> which)
    : data_(std::make_unique<Data>(corners, std::move(which))) {}
RayTree::~RayTree() = default;
RayTree::RayTree(RayTree&&) noexcept = default;
RayTree& RayTree::operator=(RayTree&&) noexcept = default;

struct RayTree::Line {
    glm::dvec3 start;      ///< in the tree's coordinates, within its box or close to it
    glm::dvec3 along;      ///< of length 1
    double scale = 0.0;    ///< lengths along it of t = 1
    double skipped = 0.0;  ///< length between the origin and the start
    bool isTooFar = false; ///< doubles don't place the start well enough
};

std::optional<RayTree::Line> RayTree::lineOf(const glm::dvec3& origin,
                                             const glm::dvec3& direction) const {
    const double reach = largestComponent(direction);
    if (reach == 0.0 || data_->triangles.empty()) return std::nullopt;
    const double size = glm::length(direction / reach);
    Line line{data_->local(origin), direction / reach / size, reach * size * data_->scale};
    const double farthest = largestComponent(line.start);
    line.isTooFar = farthest > farthestOrigin;
    if (farthest <= largestOrigin || line.isTooFar) return line;
    // A start far away would lose digits: it is moved to where the line comes near the box.
    double from = 0.0, to = std::numeric_limits<double>::infinity();
    const double grown = 1.0 + padding + 1e-12 * farthest;
    for (glm::length_t i = 0; i < 3; ++i) {
        if (line.along[i] == 0.0) {
            if (std::abs(line.start[i]) > grown) return std::nullopt;
            continue;
        }
        const double a = (-grown - line.start[i]) / line.along[i],
                     b = (grown - line.start[i]) / line.along[i];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    if (from > to * (1.0 + 1e-12)) return std::nullopt;
    line.skipped = from * (1.0 - 1e-12);
    line.start += line.skipped * line.along;
    return line;
}

void RayTree::visit(const glm::dvec3& origin, const glm::dvec3& direction, double length,
                    const std::function<bool(std::uint32_t)>& visit) const {
    const std::optional<Line> line = lineOf(origin, direction);
    if (!line) return;
    if (line->isTooFar) {
        for (const std::uint32_t triangle : data_->triangles)
            if (visit(triangle)) return;
        return;
    }
    Search search;
    embree::init(search.context);
    search.visit = &visit;
    RTCRay ray = rayOf(line->start, line->along);
    ray.tfar = endOf(length * line->scale - line->skipped);
    embree::occluded(data_->scene, search.context, ray);
}

void RayTree::visitInOrder(const glm::dvec3& origin, const glm::dvec3& direction,
                           const std::function<double(std::uint32_t)>& visit) const {
    const std::optional<Line> line = lineOf(origin, direction);
    if (!line) return;
    if (line->isTooFar) {
        for (const std::uint32_t triangle : data_->triangles)
            visit(triangle);
        return;
    }
    Search search;
    embree::init(search.context);
    search.visitInOrder = &visit;
    search.scale = line->scale;
    search.offset = line->skipped;
    RTCRayHit ray{};
    ray.ray = rayOf(line->start, line->along);
    ray.ray.tfar = endOf(std::numeric_limits<double>::infinity());
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(data_->scene, search.context, ray);
}

RayTree::Origins RayTree::originsOf(std::span<const glm::dvec3> places) const {
    Origins origins{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::dvec3 start = data_->local(places[i]);
        origins.inside = origins.inside && largestComponent(start) <= largestOrigin;
        origins.x[i] = static_cast<float>(start.x);
        origins.y[i] = static_cast<float>(start.y);
        origins.z[i] = static_cast<float>(start.z);
    }
    return origins;
}

void RayTree::visitPacket(const Origins& origins, const glm::dvec3& direction, Lanes rays,
                          Test test, void* state) const {
    if (data_->triangles.empty()) return;
    const double reach = largestComponent(direction);
    const glm::vec3 toward(glm::normalize(direction / reach));
    Search search;
    embree::init(search.context);
    search.test = test;
    search.state = state;
    alignas(64) int valid[packetSize];
    RTCRay16 packet;
    for (std::size_t i = 0; i < packetSize; ++i) {
        valid[i] = (rays >> i & 1) != 0 ? -1 : 0;
        packet.org_x[i] = origins.x[i];
        packet.org_y[i] = origins.y[i];
        packet.org_z[i] = origins.z[i];
        packet.dir_x[i] = toward.x;
        packet.dir_y[i] = toward.y;
        packet.dir_z[i] = toward.z;
        packet.tnear[i] = packet.time[i] = 0.0f;
        packet.tfar[i] = infinity;
        packet.mask[i] = ~0u;
        packet.id[i] = static_cast<unsigned>(i);
        packet.flags[i] = 0;
    }
    embree::occluded(data_->scene, search.context, valid, packet);
}

} // namespace edgeshade::rays
