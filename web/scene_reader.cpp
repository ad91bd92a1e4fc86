#include "web/scene_reader.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/image_type.hpp"
#include "preprocess/reading/variants.hpp"
#include "src/image/webp.hpp"
#include "src/shadow/view/scene_cameras.hpp"
#include "src/viewer/view_state.hpp"
#include "web/page_bytes.hpp"
#include "web/scene_transfer.hpp"
#include "web/sentence.hpp"

#include <utility>

namespace edgeshade::web {
namespace {

void enter(const emscripten::val& onStage, LoadStage stage) {
    onStage(std::string(nameOf(stage)));
}

} // namespace

std::string SceneReader::nameOfImage(int image) const {
    return loaded_.document->where("images[" + std::to_string(image) + "]");
}

std::string SceneReader::read(const std::string& name, const std::string& variant,
                              emscripten::val onStage) {
    return sentenceOfFailure([&] {
        loaded_ = readScene(
            name, std::nullopt, ReadingLimits(), [&](LoadStage stage) { enter(onStage, stage); },
            Looks{variant});
        enter(onStage, LoadStage::images);
        memory_ = loaded_.document->memory;
        choice_.emplace(*loaded_.document, loaded_.scene);
    });
}

std::string SceneReader::wantedImages() const {
    auto wanted = nlohmann::ordered_json::array();
    for (const int image : choice_->wanted()) {
        const auto& source = loaded_.document->json["images"].at(static_cast<std::size_t>(image));
        const bool named = source.contains("uri") && source["uri"].is_string();
        wanted.push_back(
            {{"image", image}, {"uri", named ? source["uri"].get<std::string>() : ""}});
    }
    return wanted.dump();
}

emscripten::val SceneReader::webpOf(int image) {
    webp_.clear();
    try {
        Bytes bytes = encodedImageBytes(*loaded_.document, image);
        if (imageTypeOf(bytes) == "image/webp") {
            requireStillWebp(bytes, nameOfImage(image));
            webp_ = std::move(bytes);
        }
    } catch (const InputError&) {
        // decideImage() reports what is wrong.
    }
    return viewOf(webp_);
}

std::string SceneReader::roomFor(int image, int width, int height) {
    return sentenceOfFailure([&] {
        countPixels(width, height, nameOfImage(image), memory_);
        room_ = {width, height,
                 Bytes(std::size_t{4} * static_cast<std::size_t>(width) *
                       static_cast<std::size_t>(height))};
    });
}

emscripten::val SceneReader::room() {
    return viewOf(room_.rgba);
}

std::string SceneReader::decideImage(int image, const std::string& problem) {
    return sentenceOfFailure([&] {
        choice_->decide(image, [&]() -> std::shared_ptr<const Image> {
            if (!problem.empty()) throw InputError(nameOfImage(image) + ": " + problem);
            if (!room_.rgba.empty())
                return std::make_shared<const Image>(std::exchange(room_, Image()));
            decodeImage(*loaded_.document, image, memory_); // as the page will, when it draws the
                                                            // image
            return nullptr;
        });
    });
}

std::string SceneReader::finish(emscripten::val onStage) {
    return sentenceOfFailure([&] {
        loaded_.images = choice_->finish();
        enter(onStage, LoadStage::shadows);
        addShadows(loaded_);
        onStage(std::string("hand over"));
        bytes_ = toTransfer(loaded_);
    });
}

emscripten::val SceneReader::bytes() const {
    return viewOf(bytes_);
}

std::string SceneReader::warnings() const {
    return nlohmann::ordered_json(loaded_.scene.warnings.sentences()).dump();
}

std::string SceneReader::variants() const {
    return nlohmann::ordered_json(variantNames(*loaded_.document)).dump();
}

std::string SceneReader::cameras() const {
    auto all = nlohmann::ordered_json::array();
    for (const FileCamera& camera : fileCameras(loaded_.scene))
        all.push_back({{"name", camera.title}, {"camera", viewer::toJson(camera.camera)}});
    return all.dump();
}

} // namespace edgeshade::web
