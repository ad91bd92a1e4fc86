#pragma once

#include "src/render/frame/light_methods.hpp"
#include "src/render/timing/stage_timer.hpp"

#include <nlohmann/json.hpp>
#include <optional>

namespace edgeshade::viewer {

/// Measurements of the last frames and their contents. Times are means over the last frames, 0
/// before the first.
struct FrameStats {
    double frameMs = 0.0;           ///< until the picture was finished
    double planMs = 0.0;            ///< part of frameMs: work on the CPU before drawing
    double poseMs = 0.0;            ///< not in frameMs: posing, of a frame with a new pose
    std::optional<StageMs> stageMs; ///< of the last frame whose stages were timed (one in 16)
    std::size_t triangles = 0;
    std::size_t edges = 0;
    std::size_t records = 0;
    std::size_t silhouettes = 0; ///< records with non-zero multiplicity for the chosen light
    std::size_t shadowBytes = 0;
    std::size_t mapBytes = 0;
    std::size_t primitiveMapBytes = 0;
    std::vector<LightMethod> lights; ///< method of each light's shadows, on the left
};

/// Progress of soft shadows: the points that stand for each light with an extent.
struct LightPoints {
    std::size_t shown = 0; ///< points; 0: only the light's centre
    std::size_t of = 0;    ///< points in the end, when nothing has moved for a while; 0: no light
                           ///< has an extent
};

/// {"shown", "of"}.
nlohmann::ordered_json toJson(const LightPoints& points);

/// {"frame_ms", "plan_ms", "pose_ms", "triangles", "edges", "records", "silhouettes",
/// "shadow_bytes",
///  "map_bytes", "primitive_map_bytes", "lights": [{"method", "why", "build_ms", "bytes"}, …],
///  "stage_ms": {"ambient", "map", "silhouette", "rasterise", "lit"}}; stage_ms only once known.
nlohmann::ordered_json toJson(const FrameStats& stats);

} // namespace edgeshade::viewer
