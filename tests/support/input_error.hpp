#pragma once

#include "preprocess/base/error.hpp"

#include <gtest/gtest.h>
#include <initializer_list>
#include <string>

namespace edgeshade::test {

/// Expects an InputError whose sentence contains every one of `words`.
template <class Action>
void expectInputError(Action action, std::initializer_list<const char*> words) {
    try {
        action();
        ADD_FAILURE() << "nothing was refused";
    } catch (const InputError& error) {
        for (const char* word : words)
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
                << "'" << word << "' is missing from: " << error.what();
    } catch (const std::exception& error) {
        ADD_FAILURE() << "not an InputError: " << error.what();
    }
}

} // namespace edgeshade::test
