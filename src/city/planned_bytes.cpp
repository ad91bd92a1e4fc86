#include "src/city/planned_bytes.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/sha256.hpp"

namespace edgeshade::city {

Bytes plannedBytes(const Plan& plan, const PlannedSource& planned) {
    Bytes bytes = bytesOf(plan.folder, planned.source, plan.reading);
    if (bytes.size() != planned.bytes || sha256(bytes) != planned.sha256)
        throw InputError("'" + (plan.folder / planned.source.file).string() +
                         "' has changed since the plan was made; run city plan again.");
    return bytes;
}

} // namespace edgeshade::city
