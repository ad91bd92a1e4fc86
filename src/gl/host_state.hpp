#pragma once

#include "src/gl/host_functions.hpp"

#include <array>
#include <utility>
#include <vector>

namespace edgeshade::gl {

/// A vertex array object, where the context has them: attributes set while it is bound don't change
/// the host's.
class OwnArrays {
  public:
    explicit OwnArrays(const HostFunctions& functions);
    ~OwnArrays();
    OwnArrays(const OwnArrays&) = delete;
    OwnArrays& operator=(const OwnArrays&) = delete;

    unsigned name() const { return name_; } ///< 0: none

  private:
    HostFunctions functions_;
    unsigned name_ = 0;
};

/// Saves the host's GL state, sets the state that this program expects, and restores the host's on
/// destruction. The expected state is that of a fresh context, except where this program sets it
/// itself. Of textures, it saves the 2D bindings of the fragment stage's units. It doesn't save
/// what nothing here sets: current values of attributes, line width, hints, cube textures, uniform
/// buffers.
class HostState {
  public:
    HostState(const HostFunctions& functions, const OwnArrays& arrays);
    ~HostState();
    HostState(const HostState&) = delete;
    HostState& operator=(const HostState&) = delete;

    unsigned error() const { return error_; } ///< the host's first error; 0: none

  private:
    struct Attribute {
        int enabled = 0, size = 4, stride = 0, type = 0, normalized = 0, buffer = 0, divisor = 0;
        void* pointer = nullptr;
    };
    struct Unit {
        int texture = 0, sampler = 0;
    };
    struct StencilFace {
        int function, reference, readMask, fail, depthFail, pass, writeMask;
    };

    void saveArrays();
    void restoreArrays() const;
    StencilFace stencilOf(bool back) const;
    void restoreStencil(unsigned face, const StencilFace& stencil) const;

    HostFunctions functions_;
    unsigned error_ = 0;
    std::vector<std::pair<unsigned, bool>> switches_; ///< glEnable()
    std::vector<std::pair<unsigned, int>> storage_;   ///< glPixelStorei()
    std::vector<Unit> units_;
    std::vector<Attribute> attributes_; ///< without vertex array objects
    int activeTexture_ = 0, program_ = 0, arrayBuffer_ = 0, elementBuffer_ = 0, renderbuffer_ = 0;
    int framebuffer_ = 0, readFramebuffer_ = 0, vertexArray_ = 0;
    int packBuffer_ = 0, unpackBuffer_ = 0;
    int blendSource_ = 0, blendTarget_ = 0, blendSourceAlpha_ = 0, blendTargetAlpha_ = 0;
    int blendEquation_ = 0, blendEquationAlpha_ = 0;
    int cullFace_ = 0, frontFace_ = 0, depthFunction_ = 0, stencilClear_ = 0;
    StencilFace front_{}, back_{};
    std::array<int, 4> viewport_{}, scissor_{};
    std::array<unsigned char, 4> colorMask_{};
    unsigned char depthMask_ = 1;
    std::array<float, 4> clearColor_{};
    std::array<float, 2> depthRange_{};
    float depthClear_ = 1.0f, offsetFactor_ = 0.0f, offsetUnits_ = 0.0f;
};

/// Sets the state that drawing expects, whatever it was before. Leaves vertex arrays and bindings
/// alone, except for samplers and pixel buffers.
void setDrawingDefaults(const HostFunctions& functions);

} // namespace edgeshade::gl
