#pragma once

#include "src/gl/objects.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace edgeshade::gl {

/// Entry points of GL_EXT_disjoint_timer_query, which measures GPU time of commands.
class TimerQueries {
  public:
    /// Null if the context lacks the extension or has a timer of zero bits. `lookUp` maps a name to
    /// an entry point or null.
    static std::optional<TimerQueries> find(const std::string& extensions,
                                            void* (*lookUp)(const char*));

    Name make() const;
    void destroy(Name query) const;
    void begin(Name query) const; ///< one at a time
    void end() const;
    bool isReady(Name query) const;
    std::uint64_t nanoseconds(Name query) const; ///< waits for the result

    /// Whether the GPU was disturbed since the last call, for instance by a clock change; queries
    /// from that time are meaningless.
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
