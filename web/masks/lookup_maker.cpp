#include "web/masks/lookup_maker.hpp"

#include "web/page_bytes.hpp"
#include "web/sentence.hpp"

namespace edgeshade::web {

std::string LookupMaker::begin(std::uintptr_t address, std::size_t size) {
    return sentenceOfFailure([&] {
        const PageBytes bytes(address, size);
        bytes_ = {};
        failed_ = false;
        work_ = taskFromTransfer(bytes.view());
    });
}

bool LookupMaker::advance(double milliseconds) {
    bool done = false;
    failed_ = !sentenceOfFailure([&] { done = work_->advance(milliseconds); }).empty();
    return done || failed_;
}

emscripten::val LookupMaker::result() {
    if (!failed_) failed_ = !sentenceOfFailure([&] { bytes_ = resultToTransfer(*work_); }).empty();
    if (failed_) bytes_ = {};
    return viewOf(bytes_);
}

emscripten::val LookupMaker::texels() const {
    const std::vector<glm::vec4>& texels = work_->data()->built.map.texels;
    return emscripten::val(emscripten::typed_memory_view(
        4 * texels.size(), reinterpret_cast<const float*>(texels.data())));
}

} // namespace edgeshade::web
