#pragma once

#include "src/gl/program.hpp"
#include "tests/engine/masks_in_a_host.hpp"

namespace edgeshade::test {

/// A renderer of somebody else, who asks a light's map in a shader of his own: white where it
/// reaches, black where not; white where nothing is.
class HostPicture {
  public:
    /// `version3`: in GLSL ES 3.00; else in 1.00, by derivatives or by normals that it passes.
    struct Language {
        bool version3 = false, derivatives = true;
    };

    HostPicture(const ShadowMasks& masks, ShadowMasks::LookupId lookup, const MaskLight& light,
                const MaskView& view, Language language);
    ~HostPicture();
    HostPicture(const HostPicture&) = delete;
    HostPicture& operator=(const HostPicture&) = delete;

    /// Draws a mesh into what is bound. `casts`: as it was added.
    void draw(const Geometry& geometry, const Matrix16& worldFromObject, bool casts);

  private:
    gl::ProgramObject program_;
    MaskView view_;
};

} // namespace edgeshade::test
