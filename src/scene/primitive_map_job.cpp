#include "src/scene/primitive_map_job.hpp"

#include "preprocess/base/spare_time.hpp"
#include "preprocess/base/stopwatch.hpp"
#include "src/shadow/lights/light_extent.hpp"

#include <algorithm>

namespace edgeshade {

PrimitiveMapJob::PrimitiveMapJob(const LoadedScene& loaded, const PrimitiveMapTask& task,
                                 KeptEdges edges)
    : light_(task.light), castersReceive_(task.castersReceive), settings_(task.settings),
      materials_(&loaded.scene.materials), edges_(std::move(edges)) {
    built_.light = light_;
    built_.mostBytes = settings_.mostBytes;
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
    while (step())
        if (fitting_) fitting_->buildAllParts();
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
        if (of.animated || !castersReceive_) return true;
        built_.triangles.back() = sidedTriangles(
            *of.batch, *materials_, shapeOf(light_).in(glm::inverse(of.worldFromBatch)),
            light_.extent.has_value(), rangeInObject(light_, of.worldFromBatch));
        for (const SidedTriangles& part : built_.triangles.back())
            settings_.mostBytes -= std::min(settings_.mostBytes, part.bytes());
    } else if (!fitting_) {
        std::vector<PlacedCasters> casters = solid_;
        casters.insert(casters.end(), cutouts_.begin(), cutouts_.end());
        if (!castersReceive_) restrictToSeeThrough();
        fitting_.emplace(light_, std::move(casters), settings_);
    } else if (!fitting_->step()) {
        built_.tooFar = fitting_->tooFar();
        built_.tooLong = fitting_->tooLong();
        built_.map = std::move(fitting_->map());
        return false;
    }
    return true;
}

void PrimitiveMapJob::restrictToSeeThrough() {
    for (const Placed& of : placed_) {
        const Geometry& geometry = *of.batch->geometry;
        const auto cornerAt = [&](std::uint32_t index) {
            const glm::dvec4 corner(geometry.positions[geometry.indices[index]], 1.0);
            return glm::dvec3(of.worldFromBatch * corner);
        };
        for (const SurfaceGroup& group : geometry.groups) {
            if (!(*materials_)[group.material].isSeeThrough()) continue;
            if (of.animated) return;
            for (std::uint32_t i = 0; i < group.indexCount; i += 3) {
                const std::uint32_t first = group.firstIndex + i;
                seeThrough_.push_back({cornerAt(first), cornerAt(first + 1), cornerAt(first + 2)});
            }
        }
    }
    settings_.lookingUp = &seeThrough_;
}

} // namespace edgeshade
