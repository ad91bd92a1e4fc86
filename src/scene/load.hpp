#pragma once

#include "preprocess/base/limits.hpp"
#include "preprocess/scene/ground.hpp"
#include "preprocess/scene/looks.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "preprocess/volumes/shadow_data.hpp"
#include "src/image/scene_images.hpp"

#include <filesystem>
#include <functional>
#include <optional>

namespace edgeshade {

struct GltfDocument;

/// Scene::culls where nobody says.
inline constexpr bool cullsByDefault = true;

/// A scene on the CPU, ready for the GPU.
struct LoadedScene {
    std::shared_ptr<const GltfDocument> document; ///< null: the scene comes from no file
    Scene scene;
    SceneImages images; ///< of the materials' images those whose pixels are at hand
    std::vector<std::shared_ptr<const PlanePairShadow>> planePairs; ///< one a batch
    Shadows shadows; ///< with opposite vertices, where the file has them; or empty
    CasterSettings settings;
    Looks looks = {};                  ///< as they were asked for
    std::optional<double> time = {};   ///< of its animation, seconds; nothing: at rest
    std::string animation = {};        ///< which, as it was asked for; empty: the first
    bool cutoutsCast = false;          ///< MASK surfaces cast what alpha leaves of them, by lookups
    std::optional<Ground> ground = {}; ///< that was laid beneath the scene
    bool showsGround = true;           ///< it is seen now, if there is one
};

/// What loading does, in this order.
enum class LoadStage { read, flatten, images, shadows };

/// "read", "flatten", "images", "shadows".
const char* nameOf(LoadStage stage);

/// Reads a file, packed or not. `wanted`: what the user asked for, if anything; shadow data packed
/// with other settings are left aside and made anew, with a warning. What passes `limits` is
/// refused. `onStage` is called at the start of each stage. `looks`: see flattenScene(); what a
/// variant shades may differ, so that nothing packed is used with it. Throws InputError.
LoadedScene loadScene(const std::filesystem::path& path,
                      const std::optional<CasterSettings>& wanted, const ReadingLimits& limits = {},
                      const std::function<void(LoadStage)>& onStage = {}, const Looks& looks = {});

/// Its first two stages; decoding the images is the caller's.
LoadedScene readScene(const std::filesystem::path& path,
                      const std::optional<CasterSettings>& wanted, const ReadingLimits& limits = {},
                      const std::function<void(LoadStage)>& onStage = {}, const Looks& looks = {});

/// Its last stage. Throws InputError.
void addShadows(LoadedScene& loaded);

/// Lays a ground beneath a scene that has its shadow data and no ground yet; see addGround() of a
/// Scene.
void addGround(LoadedScene& loaded, const Ground& ground);

/// The pixels of an image that a material is drawn with: those at hand, or decoded anew. Throws
/// InputError.
std::shared_ptr<const Image> pixelsOf(const LoadedScene& loaded, int image);

/// What tells the cutouts of a batch's opposite-vertex caps: three vec4s a cap, one a corner of the
/// sorted triangle, (u, v, alpha of the vertex colour, 0).
std::vector<glm::vec4> alphaCorners(const Batch& batch, const Casters& casters,
                                    const CasterMesh& mesh);

/// The same of plane-pair caps, in their order and of their corners as they are wound; empty where
/// nothing is alpha-tested.
std::vector<glm::vec4> alphaCorners(const Batch& batch, const Casters& casters,
                                    const CasterMesh& mesh, const PlanePairShadow& shadow);

} // namespace edgeshade
