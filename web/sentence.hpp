#pragma once

#include "preprocess/base/error.hpp"

#include <new>
#include <string>

namespace edgeshade::web {

/// Does something and returns "" or, where it failed, the sentence that says why: exceptions do not
/// cross into JavaScript.
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
