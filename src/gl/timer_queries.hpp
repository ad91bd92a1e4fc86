#pragma once

#include "src/gl/objects.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace edgeshade::gl {

/// The entry points of GL_EXT_disjoint_timer_query: how long the GPU takes for commands.
class TimerQueries {
  public:
    /// Nothing where the context has no such extension, or counts no bits of time. `lookUp` maps a
    /// name to an entry point or null.
    static std::optional<TimerQueries> find(const std::string& extensions,
                                            void* (*lookUp)(const char*));

    Name make() const;
    void destroy(Name query) const;
    void begin(Name query) const; ///< one at a time
    void end() const;
    bool isReady(Name query) const;
    std::uint64_t nanoseconds(Name query) const; ///< waits until it is ready

    /// Whether the GPU was disturbed since the last call, by a change of its clock, say, so that
    /// queries of that time mean nothing.
    bool wasDisturbed() const;

  private:
    using Names = void (*)(int, unsigned*);
    using ConstNames = void (*)(int, const unsigned*);
    using Begin = void (*)(unsigned, unsigned);
    using End = void (*)(unsigned);
    using Get32 = void (*)(unsigned, unsigned, unsigned*);
    using Get64 = void (*)(unsigned, unsigned, std::uint64_t*);
    using GetParameter = void (*)(unsigned, unsigned, int*);

    Names make_ = nullptr;
    ConstNames destroy_ = nullptr;
    Begin begin_ = nullptr;
    End end_ = nullptr;
    Get32 get32_ = nullptr;
    Get64 get64_ = nullptr;
};

} // namespace edgeshade::gl
