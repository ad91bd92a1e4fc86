#include "src/rays/box_tree.hpp"

#include "preprocess/base/parallel.hpp"
#include "src/rays/embree.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace edgeshade::rays {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// One ray's search, as the callback sees it.
struct Search {
    embree::Context context; // first member: Embree passes on its address
    const std::function<bool(std::uint32_t)>* visit = nullptr; ///< null: of a packet
    const std::function<float(std::uint32_t)>* visitInOrder = nullptr;
    BoxTree::Test test = nullptr;
    void* state = nullptr;
};

RTCRay rayOf(const BoxTree::Ray& from) {
    RTCRay ray{};
    ray.org_x = from.start.x;
    ray.org_y = from.start.y;
    ray.org_z = from.start.z;
    ray.dir_x = from.along.x;
    ray.dir_y = from.along.y;
    ray.dir_z = from.along.z;
    ray.tfar = from.end;
    ray.mask = ~0u;
    return ray;
}

} // namespace

struct BoxTree::Data {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<std::uint32_t> items;                              ///< by Embree's number
    const std::function<FloatBox(std::uint32_t)>* boxOf = nullptr; ///< while building

    Data(std::vector<std::uint32_t> all, const std::function<FloatBox(std::uint32_t)>& boxOf);
    ~Data() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Data(const Data&) = delete;
    Data& operator=(const Data&) = delete;

    static void bounds(const RTCBoundsFunctionArguments* arguments);
    static void offer(const RTCOccludedFunctionNArguments* arguments);
    static void offerInOrder(const RTCIntersectFunctionNArguments* arguments);
};

BoxTree::Data::Data(std::vector<std::uint32_t> all,
                    const std::function<FloatBox(std::uint32_t)>& boxes)
    : items(std::move(all)), boxOf(&boxes) {
    const std::string threads = "threads=" + std::to_string(Threads::available());
    device = rtcNewDevice(threads.c_str());
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    if (!items.empty()) {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(items.size()));
        rtcSetGeometryUserData(geometry, this);
        rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
        rtcSetGeometryOccludedFunction(geometry, offer);
        rtcSetGeometryIntersectFunction(geometry, offerInOrder);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene);
    boxOf = nullptr;
}

void BoxTree::Data::bounds(const RTCBoundsFunctionArguments* arguments) {
    const Data& data = *static_cast<const Data*>(arguments->geometryUserPtr);
    const FloatBox box = (*data.boxOf)(data.items[arguments->primID]);
    RTCBounds& bounds = *arguments->bounds_o;
    bounds.lower_x = box.low.x;
    bounds.lower_y = box.low.y;
    bounds.lower_z = box.low.z;
    bounds.upper_x = box.high.x;
    bounds.upper_y = box.high.y;
    bounds.upper_z = box.high.z;
}

void BoxTree::Data::offer(const RTCOccludedFunctionNArguments* arguments) {
    const Data& data = *static_cast<const Data*>(arguments->geometryUserPtr);
    const auto* search = reinterpret_cast<const Search*>(arguments->context);
    const std::uint32_t item = data.items[arguments->primID];
    Lanes done = 0;
    if (search->visit)
        done = (*search->visit)(item) ? 1 : 0;
    else
        done = search->test(search->state, item);
    if (done == 0) return;
    for (unsigned i = 0; i < arguments->N; ++i) {
        const unsigned ray = RTCRayN_id(arguments->ray, arguments->N, i);
        if (arguments->valid[i] != 0 && (done >> ray & 1) != 0)
            RTCRayN_tfar(arguments->ray, arguments->N, i) = -infinity;
    }
}

void BoxTree::Data::offerInOrder(const RTCIntersectFunctionNArguments* arguments) {
    const Data& data = *static_cast<const Data*>(arguments->geometryUserPtr);
    const auto* search = reinterpret_cast<const Search*>(arguments->context);
    const float until = (*search->visitInOrder)(data.items[arguments->primID]);
    float& end = RTCRayN_tfar(RTCRayHitN_RayN(arguments->rayhit, arguments->N), arguments->N, 0);
    end = std::min(end, until);
}

BoxTree::BoxTree(std::vector<std::uint32_t> items,
                 const std::function<FloatBox(std::uint32_t)>& boxOf)
    : data_(std::make_unique<Data>(std::move(items), boxOf)) {}
BoxTree::~BoxTree() = default;
BoxTree::BoxTree(BoxTree&&) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&&) noexcept = default;

const std::vector<std::uint32_t>& BoxTree::items() const {
    return data_->items;
}

void BoxTree::visit(const Ray& ray, const std::function<bool(std::uint32_t)>& visit) const {
    Search search;
    embree::init(search.context);
    search.visit = &visit;
    RTCRay traced = rayOf(ray);
    embree::occluded(data_->scene, search.context, traced);
}

void BoxTree::visitInOrder(const Ray& ray, const std::function<float(std::uint32_t)>& visit) const {
    Search search;
    embree::init(search.context);
    search.visitInOrder = &visit;
    RTCRayHit traced{};
    traced.ray = rayOf(ray);
    traced.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(data_->scene, search.context, traced);
}

void BoxTree::visitPacket(const Origins& origins, const glm::vec3& direction, Lanes rays, Test test,
                          void* state) const {
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
        packet.dir_x[i] = direction.x;
        packet.dir_y[i] = direction.y;
        packet.dir_z[i] = direction.z;
        packet.tnear[i] = packet.time[i] = 0.0f;
        packet.tfar[i] = infinity;
        packet.mask[i] = ~0u;
        packet.id[i] = static_cast<unsigned>(i);
        packet.flags[i] = 0;
    }
    embree::occluded(data_->scene, search.context, valid, packet);
}

} // namespace edgeshade::rays
