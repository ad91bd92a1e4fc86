#include "src/viewer/shown_scene.hpp"

#include "src/scene/cut_loaded.hpp"

namespace edgeshade::viewer {

ShownScene::ShownScene(LoadedScene scene) : loaded(std::move(scene)) {
    if (loaded.document) animations_ = animationTitles(*loaded.document);
    for (std::size_t i = 0; i < animations_.size() && !animation_; ++i)
        chooseAnimation(i, loaded.scene.warnings);
    if (!animation_) index_ = 0;
}

void ShownScene::chooseAnimation(std::size_t index, Warnings& warnings) {
    index_ = index;
    animation_.reset();
    if (index < animations_.size())
        animation_ = readAnimation(*loaded.document, warnings, animations_[index].index);
}

LoadedScene ShownScene::cutFor(const ViewState& of) const {
    LoadedScene cut = loaded;
    cutScene(cut, of.section.value_or(Section()));
    if (cut.ground && of.ground) setGround(cut.scene, *of.ground);
    return cut;
}

LoadedScene ShownScene::cutPosed(const ViewState& state) const {
    LoadedScene posed = loaded;
    cutScene(posed, Section());
    placeScene(posed, poseAt(*animation_, posed.scene, state.time));
    cutScene(posed, *state.section);
    if (posed.ground && state.ground) setGround(posed.scene, *state.ground);
    return posed;
}

void ShownScene::moved() {
    tree_.update(loaded.scene);
    layers_.clear();
    edges_.reset();
}

const EdgeCounts& ShownScene::edgesFor(const Light& light) {
    if (!edges_ || edges_->first != light.position)
        edges_.emplace(light.position, countEdges(loaded, light));
    return edges_->second;
}

} // namespace edgeshade::viewer
