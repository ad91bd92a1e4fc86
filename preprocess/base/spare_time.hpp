#pragma once

namespace edgeshade {

/// Gives the calling thread, and threads it starts, the lowest priority, where the system has
/// priorities by thread.
void takeSpareTimeAlone();

} // namespace edgeshade
