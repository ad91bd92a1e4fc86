#pragma once

#include "preprocess/scene/node_transform.hpp"
#include "preprocess/scene/scene.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace edgeshade {

/// Seconds that a time may be.
inline constexpr double longestTime = 1e9;

/// How values between two keyframes come about (glTF 2.0, appendix C).
enum class Interpolation { step, linear, cubicSpline };

/// One property of a node over time (glTF 2.0, 3.11). What samplers share, they share here.
struct Keyframes {
    Interpolation interpolation = Interpolation::linear;
    /// Seconds, never decreasing, two alike where there is a step; at least one. What files have
    /// before 0 is not played.
    std::shared_ptr<const std::vector<float>> times;
    /// 3 floats a value, or 4 (x, y, z, w; not zero) of a rotation, or one a morph target. A value
    /// a time; for splines three: in-tangent, value, out-tangent.
    std::shared_ptr<const std::vector<float>> values;
};

/// What an animation does to one node; what has no keyframes stays at rest.
struct NodeMotion {
    NodeTransform rest;
    std::optional<Keyframes> translation;
    std::optional<Keyframes> rotation;
    std::optional<Keyframes> scale;

    /// Where the node is in its parent; a time outside of the keyframes takes the nearest one.
    NodeTransform at(double seconds) const;
};

/// An animation of nodes, ready to be evaluated; readAnimation() makes it.
struct Animation {
    double duration = 0.0;             ///< seconds, from 0 to the last keyframe of all
    std::map<int, NodeMotion> motions; ///< by glTF node
    /// Of the morph targets of a glTF node's mesh, by node; never null.
    std::map<int, std::optional<Keyframes>> weights;
};

/// Where a scene's parts are at one time of an animation.
struct Pose {
    /// Of each batch. Null where there is nothing to draw and no shadow: the matrix or its inverse
    /// does not fit into floats, so the batch is scaled to nothing or out of all range.
    std::vector<std::optional<glm::dmat4>> worldFromBatch;
    std::vector<BatchShape> shapes; ///< of each batch; empty ones of those that don't deform
    /// The scene's, moved. Where a node gives one no place, or no turn that it needs, it is where
    /// it is in the scene.
    std::vector<SceneCamera> cameras;
    std::vector<SceneLight> lights;
};

/// The pose at a time, which is clamped to the keyframes. What is static and what another animation
/// moves is at rest. `scene` and `animation` come from the same document.
Pose poseAt(const Animation& animation, const Scene& scene, double seconds);

/// What placing a batch did.
struct Placed {
    bool visible = true;   ///< false: there is nothing of it to draw, and no shadow
    bool reshaped = false; ///< its vertices are elsewhere than before
};

/// Puts the scene's parts there, and says of each batch what came of it; batches without a place,
/// and those of which a vertex has none that fits into floats, stay as they are.
std::vector<Placed> place(Scene& scene, const Pose& pose);

} // namespace edgeshade
