#include "web/map_maker.hpp"

#include "web/map_transfer.hpp"
#include "web/page_bytes.hpp"
#include "web/scene_transfer.hpp"
#include "web/sentence.hpp"

namespace edgeshade::web {

std::string MapMaker::show(std::uintptr_t address, std::size_t size) {
    return sentenceOfFailure([&] {
        const PageBytes bytes(address, size);
        loaded_ = fromTransfer(bytes.view());
        loaded_.images.clear(); // the worker doesn't draw
        loaded_.document.reset();
    });
}

std::string MapMaker::begin(std::uintptr_t address, std::size_t size) {
    return sentenceOfFailure([&] {
        const PageBytes bytes(address, size);
        bytes_ = {};
        failed_ = false;
        job_ = std::make_unique<PrimitiveMapJob>(loaded_, taskFromTransfer(bytes.view()), edges_);
    });
}

bool MapMaker::advance(double milliseconds) {
    bool done = false;
    failed_ = !sentenceOfFailure([&] { done = job_->advance(milliseconds); }).empty();
    return done || failed_;
}

emscripten::val MapMaker::result() {
    if (!failed_)
        failed_ = !sentenceOfFailure([&] {
                       edges_ = job_->edges();
                       bytes_ = toTransfer(job_->built());
                   }).empty();
    job_.reset();
    if (failed_) bytes_ = {};
    return viewOf(bytes_);
}

} // namespace edgeshade::web
