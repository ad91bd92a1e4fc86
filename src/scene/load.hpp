#pragma once

#include "preprocess/base/limits.hpp"
#include "preprocess/scene/ground.hpp"
#include "preprocess/scene/looks.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "preprocess/volumes/shadow_data.hpp"
#include "src/image/scene_images.hpp"
#include "src/shadow/layers/layer_casters.hpp"

#include <filesystem>
#include <functional>
#include <optional>

namespace edgeshade {

struct GltfDocument;
struct UncutScene;

/// The default of Scene::culls.
inline constexpr bool cullsByDefault = true;

/// A scene on the CPU, ready for the GPU.
struct LoadedScene {
    std::shared_ptr<const GltfDocument> document; ///< null: the scene isn't from a file
    Scene scene;
    SceneImages images; ///< images of materials whose pixels are loaded
    std::vector<std::shared_ptr<const PlanePairShadow>> planePairs; ///< one per batch
    Shadows shadows; ///< opposite-vertex data, if the file has them; otherwise empty
    CasterSettings settings;
    Looks looks = {};                  ///< as requested
    std::optional<double> time = {};   ///< time of its animation in seconds; null: at rest
    std::string animation = {};        ///< the animation requested; empty: the first
    bool cutoutsCast = false;          ///< MASK surfaces cast where their alpha leaves them, in
                                       ///< primitive maps
    std::optional<Ground> ground = {}; ///< laid beneath the scene
    bool showsGround = true;           ///< the ground, if any, is visible now
    std::shared_ptr<UncutScene> uncut = {}; ///< what cutScene() cuts; null: no section did

    bool mayHaveHoles() const { return scene.mayHaveHoles(settings.castMasked); }
    LayerCasters layerCasters() const { return {scene, planePairs, settings.castMasked}; }
};

/// Stages of loading, in order.
enum class LoadStage { read, flatten, images, shadows };

/// "read", "flatten", "images", "shadows".
const char* nameOf(LoadStage stage);

/// Reads a file, packed or not. `wanted`: the user's settings, if any; shadow data packed with
/// other settings are ignored and rebuilt, with a warning. A file beyond `limits` is refused.
/// `onStage` is called at the start of each stage. `looks`: see flattenScene(); with a variant
/// nothing packed is used, as its materials may cast differently. Throws InputError.
LoadedScene loadScene(const std::filesystem::path& path,
                      const std::optional<CasterSettings>& wanted, const ReadingLimits& limits = {},
                      const std::function<void(LoadStage)>& onStage = {}, const Looks& looks = {});

/// Runs the first two stages of loadScene(); the caller decodes the images.
LoadedScene readScene(const std::filesystem::path& path,
                      const std::optional<CasterSettings>& wanted, const ReadingLimits& limits = {},
                      const std::function<void(LoadStage)>& onStage = {}, const Looks& looks = {});

/// As loadScene(), but without shadow data, which rays don't need: every batch's are empty. The
/// scene is not to be posed or cut.
LoadedScene loadSurfaces(const std::filesystem::path& path,
                         const std::optional<CasterSettings>& wanted,
                         const ReadingLimits& limits = {}, const Looks& looks = {});

/// Runs the last stage of loadScene(). Throws InputError.
void addShadows(LoadedScene& loaded);

/// Adds a ground to a scene that has its shadow data and no ground yet; see addGround() for a
/// Scene.
void addGround(LoadedScene& loaded, const Ground& ground);

/// The pixels of a material's image: those loaded, or else decoded. Throws InputError.
std::shared_ptr<const Image> pixelsOf(const LoadedScene& loaded, int image);

/// Data of the cutouts of a batch's opposite-vertex caps: three vec4s per cap, one for each corner
/// of the sorted triangle, (u, v, alpha of the vertex colour, 0).
std::vector<glm::vec4> alphaCorners(const Batch& batch, const Casters& casters,
                                    const CasterMesh& mesh);

/// The same data for plane-pair caps, in their order, and for corners in winding order; empty if no
/// caster is alpha-tested.
std::vector<glm::vec4> alphaCorners(const Batch& batch, const Casters& casters,
                                    const CasterMesh& mesh, const PlanePairShadow& shadow);

} // namespace edgeshade
