#pragma once

#include "src/lab/compare.hpp"
#include "src/rivals/rivals.hpp"

#include <functional>
#include <string>

namespace edgeshade::test {

/// A contender with base shading, and with the settings that `choose` makes.
inline lab::Contender contender(const std::string& name,
                                const std::function<void(RenderSettings&)>& choose) {
    lab::Contender made;
    made.name = name;
    made.settings.shading = Shading::base;
    choose(made.settings);
    made.settings.rivals = &allRivals();
    return made;
}

} // namespace edgeshade::test
