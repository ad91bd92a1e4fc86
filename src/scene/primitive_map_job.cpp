#include "src/scene/primitive_map_job.hpp"

#include "preprocess/base/stopwatch.hpp"

#include <algorithm>
#ifdef __linux__
#include <pthread.h>
#endif

namespace edgeshade {
namespace {

/// Lets everything else go first: drawing must not wait for what it will be spared.
[[maybe_unused]] void takeSpareTimeAlone() {
#ifdef __linux__
    const sched_param parameters{};
    pthread_setschedparam(pthread_self(), SCHED_IDLE, &parameters);
#endif
}

} // namespace

PrimitiveMapJob::PrimitiveMapJob(const LoadedScene& loaded, const PrimitiveMapTask& task,
                                 KeptEdges edges)
    : light_(task.light), settings_(task.settings), materials_(&loaded.scene.materials),
      smallest_(std::max(4, task.settings.size / 8)), edges_(std::move(edges)) {
    built_.light = light_.position;
    built_.extent = light_.extent;
    for (std::size_t i = 0; i < loaded.scene.batches.size(); ++i) {
        const Batch& batch = loaded.scene.batches[i];
        placed_.push_back({&batch, loaded.planePairs[i], batch.worldFromBatch, batch.isAnimated()});
    }
}

void PrimitiveMapJob::start() {
#ifndef __EMSCRIPTEN__
    thread_ = std::jthread([this](const std::stop_token& stop) {
        takeSpareTimeAlone();
        Stopwatch watch;
        while (!stop.stop_requested() && step()) {
        }
        built_.milliseconds = 1e3 * watch.lap();
        done_ = true;
    });
#endif
}

void PrimitiveMapJob::cancel() {
#ifndef __EMSCRIPTEN__
    thread_ = {};
#endif
}

bool PrimitiveMapJob::advance([[maybe_unused]] double milliseconds) {
#ifdef __EMSCRIPTEN__
    Stopwatch watch;
    double worked = 0.0;
    while (!done_ && worked < milliseconds) {
        done_ = !step();
        worked += 1e3 * watch.lap();
    }
    built_.milliseconds += worked;
#endif
    return done_;
}

void PrimitiveMapJob::finish() {
    Stopwatch watch;
    while (step()) {
        if (!builder_ || nextPart_ > 0 || joined_) continue;
        builder_->buildAllParts();
        nextPart_ = builder_->partCount();
    }
    built_.milliseconds = 1e3 * watch.lap();
    done_ = true;
}

bool PrimitiveMapJob::step() {
    if (solid_.size() < placed_.size()) {
        const Placed& of = placed_[solid_.size()];
        auto& edges = edges_[of.shadow];
        if (!edges && !of.animated)
            edges = std::make_shared<const CasterEdges>(casterEdgesOf(*of.shadow));
        solid_.push_back({edges, of.worldFromBatch, !of.animated});
        if (!settings_.cutouts.empty() && !of.animated)
            cutouts_.push_back(
                {std::make_shared<const CasterEdges>(cutoutEdgesOf(*of.batch, *materials_)),
                 of.worldFromBatch, true});
    } else if (built_.triangles.size() < placed_.size()) {
        const Placed& of = placed_[built_.triangles.size()];
        built_.triangles.emplace_back();
        if (!of.animated)
            built_.triangles.back() = sidedTriangles(
                *of.batch, *materials_, shapeOf(light_).in(glm::inverse(of.worldFromBatch)),
                light_.extent.has_value());
    } else if (joined_) {
        return false;
    } else if (!builder_) {
        std::vector<PlacedCasters> casters = solid_;
        casters.insert(casters.end(), cutouts_.begin(), cutouts_.end());
        builder_ = std::make_unique<PrimitiveMapBuilder>(light_, casters, settings_);
        nextPart_ = 0;
        joined_ = built_.tooFar = builder_->isTooFar();
    } else if (nextPart_ < builder_->partCount()) {
        builder_->buildPart(nextPart_++);
    } else {
        built_.map = builder_->join();
        builder_.reset();
        settings_.size /= 2; // should it have been too large
        joined_ = built_.map || settings_.size < smallest_;
    }
    return true;
}

} // namespace edgeshade
