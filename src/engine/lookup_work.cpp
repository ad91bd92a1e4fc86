#include "src/engine/lookup_work.hpp"

#include "preprocess/base/stopwatch.hpp"

namespace edgeshade {
namespace {

PrimitiveMapSettings settingsOf(const LookupSettings& from) {
    PrimitiveMapSettings settings;
    settings.size = from.size;
    settings.mostBytes = from.mostBytes;
    settings.othersReceive = true; // the host's own surfaces receive too
    return settings;
}

} // namespace

bool LookupWork::Data::step() {
    if (!task.why.empty()) {
        built.why = task.why;
        return false;
    }
    if (placed.size() < task.casters.size()) {
        const LookupTask::Caster& caster = task.casters[placed.size()];
        auto& of = edges[caster.shadow.get()];
        if (!of) of = std::make_shared<const CasterEdges>(casterEdgesOf(*caster.shadow));
        placed.push_back({of, caster.worldFromBatch, true});
        return true;
    }
    if (!fitting) fitting.emplace(task.light, placed, settingsOf(task.settings));
    if (fitting->step()) return true;
    built.why = refusalOf({fitting->map().has_value(), fitting->tooFar(), fitting->tooLong(),
                           task.settings.mostBytes});
    if (built.why.empty()) built.map = packedPrimitiveMap(*fitting->map());
    fitting.reset();
    return false;
}

bool LookupWork::advance(double milliseconds) {
    Stopwatch watch;
    double worked = 0.0;
    while (!data_->done && worked < milliseconds) {
        data_->done = !data_->step();
        worked += 1e3 * watch.lap();
    }
    data_->built.milliseconds += worked;
    return data_->done;
}

void LookupWork::finish() {
    Stopwatch watch;
    while (!data_->done) {
        data_->done = !data_->step();
        if (data_->fitting) data_->fitting->buildAllParts();
    }
    data_->built.milliseconds += 1e3 * watch.lap();
}

LookupWork workOn(LookupTask task, std::vector<HeldCaster> held) {
    auto data = std::make_shared<LookupWork::Data>();
    data->task = std::move(task);
    data->held = std::move(held);
    return LookupWork(std::move(data));
}

} // namespace edgeshade
