#pragma once

#include "preprocess/reading/animation_reading.hpp"
#include "src/scene/load.hpp"
#include "src/scene/pose.hpp"
#include "src/shadow/view/kept_layers.hpp"
#include "src/shadow/view/scene_tree.hpp"
#include "src/viewer/silhouettes.hpp"
#include "src/viewer/view_state.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace edgeshade::viewer {

/// A loaded scene in the pose and the section of a state, and what is known of it in that place.
/// Uses no GL.
class ShownScene {
  public:
    /// Chooses the first animation that can be read; warns of the others.
    explicit ShownScene(LoadedScene scene);

    LoadedScene loaded;

    const std::vector<AnimationTitle>& animations() const { return animations_; }
    /// Index of the chosen one; 0 without one.
    std::size_t animationIndex() const { return index_; }
    const std::optional<Animation>& animation() const { return animation_; }
    /// `index` may be beyond the last: none. Leaves none chosen if it can't be read.
    void chooseAnimation(std::size_t index, Warnings& warnings);

    /// The scene in another state's section, and with its ground.
    LoadedScene cutFor(const ViewState& of) const;
    /// The scene as a whole in the animation's pose at the state's time, cut again.
    LoadedScene cutPosed(const ViewState& state) const;
    /// Drops everything computed for the batches' old places.
    void moved();

    const SceneTree& tree() const { return tree_; }
    KeptLayers& layers() { return layers_; }
    /// Edges for a light; kept until the scene or the light moves.
    const EdgeCounts& edgesFor(const Light& light);

  private:
    std::vector<AnimationTitle> animations_;
    std::size_t index_ = 0;
    std::optional<Animation> animation_;
    SceneTree tree_;
    KeptLayers layers_;
    std::optional<std::pair<glm::dvec4, EdgeCounts>> edges_; ///< for a light at this position
};

} // namespace edgeshade::viewer
