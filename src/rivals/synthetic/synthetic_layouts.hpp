#pragma once

#include "src/gl/capabilities.hpp"
#include "src/rivals/published/volume_program.hpp"
#include "src/rivals/synthetic/synthetic_mesh.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace edgeshade::bench {

/// A synthetic mesh on the GPU in one layout.
class SyntheticSubject {
  public:
    virtual ~SyntheticSubject() = default;
    /// Draws the sides of the first `edgeCount` edges, degenerated in the vertex shader.
    virtual void draw(std::size_t edgeCount) = 0;
};

/// A layout to measure: its name, and a function that uploads a mesh whose edges each have
/// `oppositeCount` opposite vertices.
struct SyntheticLayout {
    std::string name;
    std::function<std::unique_ptr<SyntheticSubject>(const SyntheticMesh&, int oppositeCount)>
        upload;
};

/// All layouts that the GL has, best first. `method`: for the published ones.
std::vector<SyntheticLayout> syntheticLayouts(MultiplicityMethod method,
                                              const gl::Capabilities& capabilities);

} // namespace edgeshade::bench
