#pragma once

namespace edgeshade {

class Rivals;

/// All methods that are there to be compared with: published opposite-vertex records (Milet 2020),
/// brute-force volumes and planar shadows (Sambeek 2007), and shadow maps that are paraboloids,
/// warped or filtered.
const Rivals& allRivals();

} // namespace edgeshade
