#include "tests/support/child_process.hpp"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace edgeshade::test {
namespace {

/// A file without a name, closed in other child processes.
int unnamedFile() {
    std::FILE* file = std::tmpfile();
    if (!file) throw std::runtime_error("no temporary file can be made");
    const int descriptor = ::fcntl(::fileno(file), F_DUPFD_CLOEXEC, 3);
    std::fclose(file);
    return descriptor;
}

std::string contentOf(int descriptor) {
    std::string content;
    char block[4096];
    ::lseek(descriptor, 0, SEEK_SET);
    for (ssize_t size; (size = ::read(descriptor, block, sizeof block)) > 0;)
        content.append(block, static_cast<std::size_t>(size));
    return content;
}

/// Pointers to the words of a command line, and null. They stay the caller's.
std::vector<char*> pointersTo(const std::string& program,
                              const std::vector<std::string>& arguments) {
    std::vector<char*> words = {const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    return words;
}

} // namespace

ChildProcess::ChildProcess(const std::string& program, const std::vector<std::string>& arguments,
                           const Environment& environment)
    : out_(unnamedFile()), err_(unnamedFile()) {
    std::vector<char*> argv = pointersTo(program, arguments);
    start(environment, [&] { ::execv(program.c_str(), argv.data()); });
}

ChildProcess::ChildProcess(Main main, const std::vector<std::string>& arguments,
                           const Environment& environment)
    : out_(unnamedFile()), err_(unnamedFile()) {
    const std::string program = "program";
    std::vector<char*> argv = pointersTo(program, arguments);
    std::fflush(nullptr); // or the child would print what this process has not yet printed
    // An exception ends the child, which must not go on with this process's tests.
    start(environment, [&]() noexcept {
        const int status = main(static_cast<int>(arguments.size() + 1), argv.data());
        std::cout.flush();
        std::fflush(nullptr);
#ifdef __SANITIZE_ADDRESS__
        std::exit(status); // looks for leaks
#else
        ::_exit(status); // leaves out what the libraries of this process clear away
#endif
    });
}

template <class Use>
void ChildProcess::start(const Environment& environment, Use use) {
    process_ = ::fork();
    if (process_ < 0) throw std::runtime_error("no process can be started");
    if (process_ > 0) return;
    for (const auto& [name, value] : environment)
        ::setenv(name.c_str(), value.c_str(), 1);
    ::signal(SIGINT, SIG_DFL); // processes started in a shell's background ignore it
    ::dup2(out_, STDOUT_FILENO);
    ::dup2(err_, STDERR_FILENO);
    use();
    ::_exit(127);
}

ChildProcess::~ChildProcess() {
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    ::close(out_);
    ::close(err_);
}

void ChildProcess::send(int signal) const {
    if (process_ > 0) ::kill(process_, signal);
}

ProcessResult ChildProcess::wait(double timeoutSeconds) {
#ifdef __SANITIZE_ADDRESS__
    timeoutSeconds *= 10.0; // its checks take time
#endif
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    ProcessResult result;
    int ended = 0;
    rusage usage{};
    while (::wait4(process_, &ended, WNOHANG, &usage) == 0) {
        result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (result.seconds > timeoutSeconds) {
            result.timedOut = true;
            ::kill(process_, SIGKILL);
            ::wait4(process_, &ended, 0, &usage);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    process_ = -1;
    result.peakBytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
    if (WIFEXITED(ended)) result.status = WEXITSTATUS(ended);
    if (WIFSIGNALED(ended)) result.signal = WTERMSIG(ended);
    result.out = contentOf(out_);
    result.err = contentOf(err_);
    return result;
}

} // namespace edgeshade::test
