// sun_rays SCENE REPORT WIDTH HEIGHT: the processor's time for masks to count the positions of
// `sunhours`, for Embree to trace them, and for src/rays to do so without rounding. REPORT comes
// from `sunhours` for a picture of that size. Prints JSON, in seconds of all threads together, of
// several turns, one after another: {"rays": .., "upload_s": [..], "count_s": [..], "tree_s": [..],
// "rays_s":
// [..], "certified_tree_s": [..], "certified_rays_s": [..], "lit_by_count": .., "lit_by_rays": ..,
// "lit_by_certified_rays": ..}.
//
// Embree traces one occlusion ray for each visible pixel and sun position, eight pixels at once,
// flagged as coherent, on all cores; the rays' origins are found beforehand. Its answers are in
// floats. Certified rays are those of sunhours, in its order of pixels.
#include "src/gl/headless_context.hpp"
#include "src/lab/sun_counts.hpp"
#include "src/lab/texture_alpha.hpp"
#include "src/rays/embree.hpp"
#include "src/rays/surface_set.hpp"
#include "src/render/accumulation/direction_counts.hpp"

#include "preprocess/base/parallel.hpp"

#include <ctime>
#include <fstream>
#include <glm/gtc/type_ptr.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

using namespace edgeshade;
using Json = nlohmann::ordered_json;

namespace {

constexpr int turns = 5;
constexpr std::size_t packet = 8, packetsAtOnce = 256;
/// Distance of a ray's origin from its surface, as a share of the scene's diagonal.
constexpr float clear = 1e-5f;

struct Place {
    glm::vec3 point;  ///< relative to the camera
    glm::vec3 normal; ///< on the visible side
};

Frustum frustumOf(const Json& camera, double aspect) {
    Frustum frustum;
    const auto matrix = camera["matrix"].get<std::vector<double>>();
    frustum.viewFromWorld = glm::make_mat4(matrix.data());
    frustum.orthographic = camera.contains("ortho");
    const double height = frustum.orthographic
                              ? camera["ortho"].get<double>()
                              : 2.0 * std::tan(0.5 * glm::radians(camera["fov"].get<double>()));
    frustum.high = 0.5 * height * glm::dvec2(aspect, 1.0);
    frustum.low = -frustum.high;
    return frustum;
}

/// The surface point of each pixel that shows one.
std::vector<Place> placesOf(const lab::Oracle& oracle,
                            const std::vector<lab::PixelSurface>& surfaces) {
    const lab::Question& question = oracle.question();
    std::vector<Place> places;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (surfaces[i].area == 0.0) continue;
        const auto width = static_cast<std::size_t>(question.width);
        const lab::PixelRay ray = lab::pixelRay(question, static_cast<double>(i % width) + 0.5,
                                                static_cast<double>(i / width) + 0.5);
        const rays::SurfaceTriangle& triangle = oracle.triangles()[surfaces[i].triangle];
        const glm::dvec3 normal = rays::normalOf(triangle);
        const double depth =
            glm::dot(normal, triangle.a - ray.origin) / glm::dot(normal, ray.direction);
        const double side = oracle.eyeSide(triangle) < 0.0 ? -1.0 : 1.0;
        places.push_back({glm::vec3(ray.at(depth)), glm::vec3(side * glm::normalize(normal))});
    }
    return places;
}

/// Embree's tree of the casters, built for speed only.
class Tree {
  public:
    explicit Tree(const std::vector<rays::SurfaceTriangle>& triangles)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        std::vector<glm::vec3> corners;
        for (const rays::SurfaceTriangle& triangle : triangles)
            if (triangle.casts)
                for (const glm::dvec3& corner : {triangle.a, triangle.b, triangle.c})
                    corners.push_back(glm::vec3(corner));
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* vertices =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    sizeof(glm::vec3), corners.size());
        std::copy(corners.begin(), corners.end(), static_cast<glm::vec3*>(vertices));
        auto* indices = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), corners.size() / 3));
        std::iota(indices, indices + corners.size(), 0u);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~Tree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;

    /// Number of up to eight places that a light from a direction of length 1 reaches.
    std::size_t lit(std::span<const Place> places, const glm::vec3& direction, float offset) const {
        alignas(32) int valid[packet] = {};
        RTCRay8 traced;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const glm::vec3 from = places[i].point + offset * places[i].normal;
            valid[i] = -1;
            traced.org_x[i] = from.x;
            traced.org_y[i] = from.y;
            traced.org_z[i] = from.z;
            traced.dir_x[i] = direction.x;
            traced.dir_y[i] = direction.y;
            traced.dir_z[i] = direction.z;
            traced.tnear[i] = traced.time[i] = 0.0f;
            traced.tfar[i] = std::numeric_limits<float>::infinity();
            traced.mask[i] = ~0u;
            traced.flags[i] = 0;
        }
        rays::embree::Context context;
        rays::embree::init(context);
        rays::embree::occluded(scene_, context, valid, traced);
        std::size_t count = 0;
        for (std::size_t i = 0; i < places.size(); ++i)
            count += traced.tfar[i] > 0.0f && glm::dot(places[i].normal, direction) > 0.0f ? 1 : 0;
        return count;
    }

  private:
    RTCDevice device_;
    RTCScene scene_;
};

std::size_t litOf(const Tree& tree, std::span<const Place> places,
                  std::span<const glm::dvec3> directions, float offset) {
    std::atomic<std::size_t> lit = 0;
    constexpr std::size_t placesAtOnce = packet * packetsAtOnce;
    const std::size_t parts = (places.size() + placesAtOnce - 1) / placesAtOnce;
    inParallel(parts * directions.size(), {}, [&](std::size_t i) {
        const glm::vec3 direction(directions[i / parts]);
        const std::size_t first = i % parts * placesAtOnce;
        const std::size_t end = std::min(first + placesAtOnce, places.size());
        std::size_t of = 0;
        for (std::size_t at = first; at < end; at += packet)
            of += tree.lit(places.subspan(at, std::min(packet, end - at)), direction, offset);
        lit += of;
    });
    return lit;
}

} // namespace

int main(int count, char** words) {
    if (count != 5) {
        std::cerr << "sun_rays SCENE REPORT WIDTH HEIGHT\n";
        return 2;
    }
    LoadedScene loaded = loadScene(words[1], std::nullopt);
    loaded.scene.culls = cullsByDefault;
    const Json report = Json::parse(std::ifstream(words[2]));
    FrameRequest request;
    request.width = std::stoi(words[3]);
    request.height = std::stoi(words[4]);
    request.frustum =
        frustumOf(report["camera"], static_cast<double>(request.width) / request.height);
    std::vector<glm::dvec3> directions;
    for (const Json& position : report["positions"])
        directions.push_back(glm::normalize(
            glm::make_vec3(position["direction"].get<std::vector<double>>().data())));

    const Box bounds = worldBounds(loaded.scene);
    const FrameView view = makeFrameView(loaded.scene, request, bounds);
    lab::Question question;
    question.scene = &loaded.scene;
    question.frustum = view.frustum;
    question.near = view.near();
    question.width = request.width;
    question.height = request.height;
    const lab::Oracle oracle(question, lab::textureAlpha(loaded));
    const std::vector<lab::PixelSurface> surfaces = lab::pixelSurfaces(oracle, {});
    const std::vector<Place> places = placesOf(oracle, surfaces);
    const auto offset = clear * static_cast<float>(glm::length(bounds.high - bounds.low));

    const gl::HeadlessContext context({request.width, request.height, 0, gl::Limits::device});
    RenderSettings settings;
    settings.layout = bestLayout(context.capabilities());
    Json told = {{"rays", places.size() * directions.size()}};
    std::clock_t began = std::clock();
    const auto lap = [&began] {
        const std::clock_t now = std::clock();
        return static_cast<double>(now - std::exchange(began, now)) / CLOCKS_PER_SEC;
    };
    for (int turn = 0; turn < turns; ++turn) {
        lap();
        Renderer renderer(settings, context.capabilities());
        GpuScene scene = uploadScene(loaded, settings.records(), context.capabilities());
        told["upload_s"].push_back(lap());
        const LitCounts counts = countDirections(loaded, request, directions, renderer, scene,
                                                 context.capabilities(), [](double) {});
        told["count_s"].push_back(lap());
        const Tree tree(oracle.triangles());
        told["tree_s"].push_back(lap());
        told["lit_by_rays"] = litOf(tree, places, directions, offset);
        told["rays_s"].push_back(lap());
        const rays::SurfaceSet set(oracle.triangles());
        told["certified_tree_s"].push_back(lap());
        const std::vector<std::uint16_t> certified =
            lab::litCounts(oracle, surfaces, directions, [](double) {});
        told["certified_rays_s"].push_back(lap());
        told["lit_by_certified_rays"] =
            std::accumulate(certified.begin(), certified.end(), std::size_t{0});
        told["lit_by_count"] =
            std::accumulate(counts.lit.begin(), counts.lit.end(), std::size_t{0});
    }
    std::cout << told.dump(1) << std::endl;
}
