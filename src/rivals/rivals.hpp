#pragma once

namespace edgeshade {

class Rivals;

/// All methods for comparison: published opposite-vertex records (Milet 2020), brute-force volumes
/// and planar shadows (Sambeek 2007), and shadow maps that are paraboloids, warped or filtered.
const Rivals& allRivals();

} // namespace edgeshade
