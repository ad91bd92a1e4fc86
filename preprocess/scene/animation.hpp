#pragma once

#include "preprocess/scene/node_transform.hpp"
#include "preprocess/scene/scene.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace edgeshade {

/// Largest time, in seconds.
inline constexpr double longestTime = 1e9;

/// How values are interpolated between two keyframes (glTF 2.0, appendix C).
enum class Interpolation { step, linear, cubicSpline };

/// One property of a node over time (glTF 2.0, 3.11). Samplers that share an accessor share its
/// array.
struct Keyframes {
    Interpolation interpolation = Interpolation::linear;
    /// Seconds, never decreasing, with two equal ones at a step; at least one. Keyframes before 0
    /// are not played.
    std::shared_ptr<const std::vector<float>> times;
    /// 3 floats per value; 4 for a rotation (x, y, z, w; not zero); 1 per morph target. One value
    /// per time; for splines three: in-tangent, value, out-tangent.
    std::shared_ptr<const std::vector<float>> values;
};

/// An animation's effect on one node; properties without keyframes stay at rest.
struct NodeMotion {
    NodeTransform rest;
    std::optional<Keyframes> translation;
    std::optional<Keyframes> rotation;
    std::optional<Keyframes> scale;

    /// The node's transform relative to its parent; a time outside the keyframes is clamped to
    /// them.
    NodeTransform at(double seconds) const;
};

/// An animation of nodes, ready to evaluate; made by readAnimation().
struct Animation {
    double duration = 0.0;             ///< seconds, from 0 to the last keyframe
    std::map<int, NodeMotion> motions; ///< by glTF node
    /// Keyframes of the morph targets of a glTF node's mesh, by node; never null.
    std::map<int, std::optional<Keyframes>> weights;
};

/// A scene's transforms and shapes at one time of an animation.
struct Pose {
    /// For each batch. Null if it draws nothing and casts nothing: the matrix or its inverse does
    /// not fit into floats, so the batch is scaled to nothing or out of range.
    std::vector<std::optional<glm::dmat4>> worldFromBatch;
    std::vector<BatchShape> shapes; ///< for each batch; empty unless it deforms
    /// The scene's cameras and lights, moved. One keeps its place if its node's transform gives no
    /// position, or no rotation where it needs one.
    std::vector<SceneCamera> cameras;
    std::vector<SceneLight> lights;
};

/// The pose at a time, which is clamped to the keyframes. Everything that the animation doesn't
/// move is at rest. `scene` and `animation` come from the same document.
Pose poseAt(const Animation& animation, const Scene& scene, double seconds);

/// Effect of placing a batch.
struct Placed {
    bool visible = true;   ///< false: it draws nothing and casts nothing
    bool reshaped = false; ///< its vertices have moved
};

/// Applies the pose to the scene, and returns the effect on each batch. Batches without a
/// transform, and those with a vertex that doesn't fit into floats, stay as they are.
std::vector<Placed> place(Scene& scene, const Pose& pose);

} // namespace edgeshade
