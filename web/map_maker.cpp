#include "web/map_maker.hpp"

#include "src/scene/cut_loaded.hpp"
#include "web/map_transfer.hpp"
#include "web/page_bytes.hpp"
#include "web/scene_transfer.hpp"
#include "web/sentence.hpp"

#include <set>

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
        const PrimitiveMapTask task = taskFromTransfer(bytes.view());
        job_.reset(); // it refers to the scene before
        cutBy(task.section.value_or(Section()));
        job_ = std::make_unique<PrimitiveMapJob>(loaded_, task, edges_);
    });
}

/// Cuts the scene, and keeps the edges of casters that stay.
void MapMaker::cutBy(const Section& section) {
    const auto& cutFrom = loaded_.scene.cutFrom;
    if (section == (cutFrom ? cutFrom->section : Section())) return;
    cutScene(loaded_, section);
    const std::set<std::shared_ptr<const PlanePairShadow>> casters(loaded_.planePairs.begin(),
                                                                   loaded_.planePairs.end());
    std::erase_if(edges_, [&](const auto& of) { return !casters.contains(of.first); });
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
