#pragma once

#include <optional>
#include <string>

namespace edgeshade::gl {

/// Whether the context was lost: its driver was reset, or its device is gone. Some drivers report
/// this only here and record no error.
class ResetStatus {
  public:
    /// Core from ES 3.2 on, otherwise GL_KHR_robustness or GL_EXT_robustness; null if the context
    /// has none of them. `lookUp` maps a name to an entry point or null.
    static std::optional<ResetStatus>
    find(const std::string& version, const std::string& extensions, void* (*lookUp)(const char*));

    bool wasReset() const { return get_() != 0; }

  private:
    using Get = unsigned (*)();
    Get get_ = nullptr;
};

} // namespace edgeshade::gl
