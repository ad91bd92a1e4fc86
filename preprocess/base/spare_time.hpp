#pragma once

namespace edgeshade {

/// From now on everything else goes before the thread that calls it, and before those that it
/// begins, where the system can tell them apart.
void takeSpareTimeAlone();

} // namespace edgeshade
