#pragma once

#include "preprocess/base/error.hpp"

#include <new>
#include <string>

namespace edgeshade::web {

/// Runs an action and returns "" or the sentence of its failure: exceptions do not cross into
/// JavaScript.
template <class Action>
std::string sentenceOfFailure(Action action) {
    try {
        action();
        return {};
    } catch (const std::bad_alloc&) {
        return "That needs more memory than the browser gives a page.";
    } catch (const std::exception& error) {
        return error.what();
    }
}

} // namespace edgeshade::web
