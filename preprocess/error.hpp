#pragma once

#include <stdexcept>
#include <string>

namespace edgeshade {

/// The exit statuses of the program (contract of the command line).
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

/// An Error about what a user handed in.
class InputError : public Error {
  public:
    explicit InputError(const std::string& sentence) : Error(ExitStatus::input, sentence) {}
};

/// An InputError about a limit that the user may raise, where what passes it may be sound.
class LimitError : public InputError {
  public:
    explicit LimitError(const std::string& sentence) : InputError(sentence) {}
};

/// A library's message without the full stop and the line ends that it may have, to end a sentence
/// of ours with.
std::string clauseOf(std::string message);

} // namespace edgeshade
