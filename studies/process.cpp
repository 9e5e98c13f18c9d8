// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/process.hpp"

#include "particles/errors.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/perf_event.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>

namespace plenum::study {

namespace {

/// Both ends close when this goes.
struct Pipe {
  int read = -1, write = -1;

  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw RunError(fmt::format("no pipe to a program: {}", std::strerror(errno)));
    read = ends[0];
    write = ends[1];
  }
  ~Pipe() {
    closeEnd(read);
    closeEnd(write);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  static void closeEnd(int& end) {
    if (end >= 0) close(end);
    end = -1;
  }
};

/// Counts the instructions of a process that has not begun its program yet, and of its threads.
class InstructionCounter {
 public:
  explicit InstructionCounter(pid_t process) {
    perf_event_attr asked{};
    asked.size = sizeof asked;
    asked.type = PERF_TYPE_HARDWARE;
    asked.config = PERF_COUNT_HW_INSTRUCTIONS;
    asked.disabled = 1;
    asked.enable_on_exec = 1;
    asked.inherit = 1;
    asked.exclude_kernel = 1;
    asked.exclude_hv = 1;
    file_ = static_cast<int>(
        syscall(SYS_perf_event_open, &asked, process, -1, -1, PERF_FLAG_FD_CLOEXEC));
  }
  ~InstructionCounter() { Pipe::closeEnd(file_); }
  InstructionCounter(const InstructionCounter&) = delete;
  InstructionCounter& operator=(const InstructionCounter&) = delete;

  /// None where the machine has no counter, or lets nobody read it.
  std::optional<double> count() const {
    std::uint64_t n = 0;
    if (file_ < 0 || ::read(file_, &n, sizeof n) != sizeof n || n == 0) return std::nullopt;
    return static_cast<double>(n);
  }

 private:
  int file_ = -1;
};

/// In the new process, where other threads' locks may be held: nothing that takes one.
[[noreturn]] void become(char* const* command, pid_t parent, int start, int errors) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  char go = 0;
  if (read(start, &go, 1) != 1) _exit(127);
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  execv(command[0], command);
  const char* why = std::strerror(errno);
  if (write(STDERR_FILENO, why, std::strlen(why)) < 0) _exit(126);
  _exit(127);
}

std::string readAll(int file) {
  std::string text;
  std::array<char, 4096> part;
  for (;;) {
    const ssize_t n = read(file, part.data(), part.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(n));
  }
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

}  // namespace

ProcessEnd runProcess(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  Pipe start, errors;
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0)
    throw RunError(fmt::format("{}: no process: {}", command[0], std::strerror(errno)));
  if (process == 0) become(words.data(), parent, start.read, errors.write);
  Pipe::closeEnd(errors.write);
  const InstructionCounter counter(process);
  const auto begin = std::chrono::steady_clock::now();
  const char go = 1;
  if (write(start.write, &go, 1) != 1)
    throw RunError(fmt::format("{}: cannot be started: {}", command[0], std::strerror(errno)));
  ProcessEnd end;
  end.errors = readAll(errors.read);
  int how = 0;
  rusage used{};
  while (wait4(process, &how, 0, &used) < 0)
    if (errno != EINTR)
      throw RunError(fmt::format("{}: lost: {}", command[0], std::strerror(errno)));
  end.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  end.cpuSeconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  end.peakBytes = 1024.0 * static_cast<double>(used.ru_maxrss);
  end.instructions = counter.count();
  if (WIFSIGNALED(how)) end.signal = WTERMSIG(how);
  if (WIFEXITED(how)) end.exitCode = WEXITSTATUS(how);
  return end;
}

void inParallel(std::size_t n, int jobs, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex guard;
  const auto serve = [&] {
    for (std::size_t k = next++; k < n; k = next++) {
      try {
        work(k);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (!failure) failure = std::current_exception();
        next = n;
      }
    }
  };
  std::vector<std::jthread> threads;
  const auto nThreads = std::min<std::size_t>(n, static_cast<std::size_t>(std::max(1, jobs)));
  for (std::size_t t = 0; t < nThreads; ++t) threads.emplace_back(serve);
  threads.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace plenum::study
