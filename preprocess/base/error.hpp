#pragma once

#include <stdexcept>
#include <string>

namespace edgeshade {

/// Exit statuses of the program (part of the command line's contract).
enum class ExitStatus {
    done = 0,
    usage = 1,       ///< wrong usage
    input = 2,       ///< input unreadable or invalid
    unavailable = 3, ///< not possible here: no such GL feature, not built in
    output = 4,      ///< output can't be written
};

/// The one exception type that crosses the library's public surface.
///
/// what() is a full sentence that names the file, the field and the value.
class Error : public std::runtime_error {
  public:
    Error(ExitStatus status, const std::string& sentence)
        : std::runtime_error(sentence), status_(status) {}

    ExitStatus status() const { return status_; }

  private:
    ExitStatus status_;
};

/// An Error about the user's input.
class InputError : public Error {
  public:
    explicit InputError(const std::string& sentence) : Error(ExitStatus::input, sentence) {}
};

/// An InputError about a limit that the user may raise: input beyond it may be sound.
class LimitError : public InputError {
  public:
    explicit LimitError(const std::string& sentence) : InputError(sentence) {}
};

/// A library's message without its full stop and line ends, for the end of one of our sentences.
std::string clauseOf(std::string message);

} // namespace edgeshade
