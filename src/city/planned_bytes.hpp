#pragma once

#include "src/city/plan.hpp"

namespace edgeshade::city {

/// A planned source's bytes. Throws InputError naming the file: it can't be read, or its bytes
/// aren't those that were planned.
Bytes plannedBytes(const Plan& plan, const PlannedSource& planned);

} // namespace edgeshade::city
