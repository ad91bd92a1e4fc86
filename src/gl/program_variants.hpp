#pragma once

#include "src/gl/program.hpp"

#include <initializer_list>
#include <map>
#include <utility>

namespace edgeshade::gl {

using Conditions = std::initializer_list<std::pair<const char*, bool>>;

/// Adds the names whose conditions hold, as #defines.
inline void addDefines(std::vector<std::string>& defines, Conditions conditions) {
    for (const auto& [name, holds] : conditions)
        if (holds) defines.emplace_back(name);
}

inline std::vector<std::string> definesOf(Conditions conditions) {
    std::vector<std::string> defines;
    addDefines(defines, conditions);
    return defines;
}

/// One shader's programs, each made when it is first needed. `Variant` has an order.
template <class Variant>
class ProgramVariants {
  public:
    /// The variant's program; make() makes it if it isn't there yet.
    template <class Make>
    const Program& get(const Variant& variant, const Make& make) {
        const auto found = programs_.find(variant);
        return found != programs_.end() ? found->second
                                        : programs_.emplace(variant, make()).first->second;
    }

    /// The program of a variant that is there, in use.
    const Program& use(const Variant& variant) const {
        const Program& program = programs_.at(variant);
        program.use();
        return program;
    }

    void forEachProgram(const ProgramVisitor& visit) const {
        for (const auto& [variant, program] : programs_)
            visit(program);
    }

  private:
    std::map<Variant, Program> programs_;
};

} // namespace edgeshade::gl
