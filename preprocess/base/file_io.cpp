#include "preprocess/base/file_io.hpp"

#include "preprocess/base/error.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <random>
#include <string>
#include <unistd.h>

namespace edgeshade {
namespace {

/// Signals that people and systems send, and that end a program by default.
constexpr std::array heldSignals = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

/// The held signals that arrived. A signal handler can record them nowhere else.
volatile std::sig_atomic_t arrived[heldSignals.size()];

extern "C" void noteSignal(int signal) {
    for (std::size_t i = 0; i < heldSignals.size(); ++i)
        if (heldSignals[i] == signal) arrived[i] = 1;
}

/// Holds these signals back for its lifetime, whichever thread they reach. Blocking them in this
/// thread would deliver them to the others. Only one instance at a time.
class SignalsHeld {
  public:
    SignalsHeld() : only_(mutex()) {
        struct sigaction note = {};
        note.sa_handler = noteSignal;
        note.sa_flags = SA_RESTART;
        sigemptyset(&note.sa_mask);
        for (std::size_t i = 0; i < heldSignals.size(); ++i) {
            arrived[i] = 0;
            ::sigaction(heldSignals[i], nullptr, &before_[i]);
            if (before_[i].sa_handler != SIG_IGN) ::sigaction(heldSignals[i], &note, nullptr);
        }
    }
    ~SignalsHeld() {
        for (std::size_t i = 0; i < heldSignals.size(); ++i)
            ::sigaction(heldSignals[i], &before_[i], nullptr);
        for (std::size_t i = 0; i < heldSignals.size(); ++i)
            if (arrived[i]) std::raise(heldSignals[i]);
    }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

  private:
    static std::mutex& mutex() {
        static std::mutex one;
        return one;
    }

    std::lock_guard<std::mutex> only_;
    std::array<struct sigaction, heldSignals.size()> before_;
};

[[noreturn]] void failWrite(const std::filesystem::path& path, int error) {
    throw Error(ExitStatus::output,
                "'" + path.string() + "' can't be written: " + std::strerror(error) + ".");
}

/// Writes all of `bytes` to `descriptor`; returns 0 or the errno of the failure.
int writeAll(int descriptor, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

/// Resolves links, also those to a file that doesn't exist yet.
std::filesystem::path behindLinks(const std::filesystem::path& path) {
    constexpr int mostLinks = 40; // Linux's own limit
    std::filesystem::path target = path;
    for (int i = 0; i < mostLinks; ++i) {
        std::error_code noLink;
        const auto next = std::filesystem::read_symlink(target, noLink);
        if (noLink) return target;
        target = target.parent_path() / next;
    }
    failWrite(path, ELOOP);
}

/// Writes into a device or a pipe without replacing it. Returns 0 or the errno of the failure.
int writeInto(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return errno;
    const int failure = writeAll(descriptor, bytes);
    return ::close(descriptor) != 0 && failure == 0 ? errno : failure;
}

/// A name beside `path` that is unique among all processes, also on other machines that share the
/// folder. It isn't derived from `path`'s name, as the result could exceed the longest name
/// allowed.
std::filesystem::path nameBeside(const std::filesystem::path& path) {
    std::random_device random;
    char name[40];
    std::snprintf(name, sizeof name, ".edgeshade-%08x%08x.part", random(), random());
    return path.parent_path() / name;
}

/// Flushes to disk, so that a full disk is noticed before the old file is gone. Returns 0 or the
/// errno of the failure.
int flushToDisk(int descriptor) {
    const bool unable = ::fsync(descriptor) != 0;
    return unable && errno != EINVAL && errno != ENOTSUP ? errno : 0; // some systems have no fsync
}

/// Writes a new file beside `path` and renames it. Returns 0 or the errno of the failure.
int replaceFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    const SignalsHeld held;
    const std::filesystem::path part = nameBeside(path);
    const int descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                                  S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH);
    if (descriptor < 0) return errno;
    int failure = writeAll(descriptor, bytes);
    if (failure == 0) failure = flushToDisk(descriptor);
    if (::close(descriptor) != 0 && failure == 0) failure = errno;
    if (failure == 0 && ::rename(part.c_str(), path.c_str()) != 0) failure = errno;
    if (failure != 0) ::unlink(part.c_str());
    return failure;
}

} // namespace

Bytes readFile(const std::filesystem::path& path, std::uint64_t mostBytes) {
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        throw InputError("'" + path.string() + "' does not exist.");
    if (std::filesystem::is_directory(path, error))
        throw InputError("'" + path.string() + "' is a folder, not a file.");
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw InputError("'" + path.string() + "' can't be opened: " + std::strerror(errno) + ".");

    const auto requireWithin = [&](std::uint64_t size, const char* about) {
        if (size > mostBytes)
            throw LimitError("'" + path.string() + "' has " + about + std::to_string(size) +
                             " bytes, but the limit for a file is " + std::to_string(mostBytes) +
                             ".");
    };
    Bytes bytes;
    const auto size = std::filesystem::file_size(path, error);
    if (!error) {
        requireWithin(size, "");
        bytes.reserve(static_cast<std::size_t>(size));
    }
    char block[1 << 16];
    while (file.read(block, sizeof block) || file.gcount() > 0) {
        bytes.insert(bytes.end(), block, block + file.gcount());
        requireWithin(bytes.size(), "at least "); // a pipe doesn't report its size beforehand
    }
    if (file.bad())
        throw InputError("'" + path.string() + "' can't be read: " + std::strerror(errno) + ".");
    return bytes;
}

void writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (std::filesystem::is_directory(status))
        throw Error(ExitStatus::output, "'" + path.string() + "' is a folder, not a file.");
    const bool isReplaceable =
        !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
    const int failure =
        isReplaceable ? replaceFile(behindLinks(path), bytes) : writeInto(path, bytes);
    if (failure != 0) failWrite(path, failure);
}

void writeFile(const std::filesystem::path& path, std::string_view text) {
    writeFile(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

} // namespace edgeshade
