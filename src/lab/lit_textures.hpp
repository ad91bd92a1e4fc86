#pragma once

#include "src/gl/objects.hpp"
#include "src/lab/oracle.hpp"
#include "src/render/frame/visibility_lookup.hpp"

#include <vector>

namespace edgeshade::lab {

/// Answers as textures that surfaces sample for the visibility of each light: one texture per
/// light, white where it reaches. Lights that reach no pixel share one.
class LitTextures {
  public:
    /// `answers`: rows top to bottom. Throws Error(unavailable) if the GL is out of memory.
    LitTextures(const std::vector<Answer>& answers, std::size_t lights, int width, int height);

    /// By light.
    const std::vector<VisibilityLookup>& lookups() const { return lookups_; }

  private:
    std::vector<gl::Texture> textures_;
    std::vector<VisibilityLookup> lookups_;
};

} // namespace edgeshade::lab
