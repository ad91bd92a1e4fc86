#include "web/page_map_worker.hpp"

#include "web/map_transfer.hpp"
#include "web/page_bytes.hpp"

#include <utility>

namespace edgeshade::web {

void PageMapWorker::ask(const PrimitiveMapTask& task) {
    built_.reset();
    const Bytes bytes = toTransfer(task);
    maps_.call<void>("ask", viewOf(bytes));
}

void PageMapWorker::giveUp() {
    built_.reset();
    maps_.call<void>("giveUp");
}

std::optional<BuiltPrimitiveMap> PageMapWorker::take() {
    return std::exchange(built_, std::nullopt);
}

void PageMapWorker::done(std::span<const std::uint8_t> bytes) {
    built_ = builtFromTransfer(bytes);
}

} // namespace edgeshade::web
