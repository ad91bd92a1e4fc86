#include "src/viewer/frame_stats.hpp"

namespace edgeshade::viewer {

nlohmann::ordered_json toJson(const LightPoints& points) {
    return {{"shown", points.shown}, {"of", points.of}};
}

nlohmann::ordered_json toJson(const FrameStats& stats) {
    nlohmann::ordered_json json = {{"frame_ms", stats.frameMs},
                                   {"plan_ms", stats.planMs},
                                   {"pose_ms", stats.poseMs},
                                   {"triangles", stats.triangles},
                                   {"edges", stats.edges},
                                   {"records", stats.records},
                                   {"silhouettes", stats.silhouettes},
                                   {"shadow_bytes", stats.shadowBytes},
                                   {"map_bytes", stats.mapBytes},
                                   {"primitive_map_bytes", stats.primitiveMapBytes}};
    json["lights"] = nlohmann::ordered_json::array();
    for (const LightMethod& light : stats.lights)
        json["lights"].push_back({{"method", light.method},
                                  {"why", light.why},
                                  {"build_ms", light.buildMs},
                                  {"bytes", light.bytes}});
    if (stats.stageMs)
        json["stage_ms"] = {{"ambient", stats.stageMs->ambient},
                            {"map", stats.stageMs->map},
                            {"silhouette", stats.stageMs->silhouette},
                            {"rasterise", stats.stageMs->rasterise},
                            {"lit", stats.stageMs->lit}};
    return json;
}

} // namespace edgeshade::viewer
