// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/worker.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <vector>

namespace plenum::bench {

namespace {

enum Status : char { done, failed };

/// Reads or writes, as `transfer` does, until all is through. False where the other end is closed.
template <class Transfer, class Byte>
bool transferAll(Transfer transfer, int file, Byte* at, std::size_t bytes) {
  while (bytes > 0) {
    const ssize_t n = transfer(file, at, bytes);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += n;
    bytes -= static_cast<std::size_t>(n);
  }
  return true;
}

bool readAll(int file, void* to, std::size_t bytes) {
  return transferAll(read, file, static_cast<char*>(to), bytes);
}

bool writeAll(int file, const void* from, std::size_t bytes) {
  return transferAll(write, file, static_cast<const char*>(from), bytes);
}

[[noreturn]] void work(const std::function<WorkerProcess::Serve()>& prepare, int requests,
                       int replies, std::size_t requestBytes, std::size_t replyBytes) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  try {
    const WorkerProcess::Serve serve = prepare();
    // Vectors of max_align_t would do as well: operator new aligns for every type in a message.
    std::vector<char> request(requestBytes), reply(replyBytes);
    while (readAll(requests, request.data(), requestBytes)) {
      serve(request.data(), reply.data());
      const char status = done;
      writeAll(replies, &status, 1);
      writeAll(replies, reply.data(), replyBytes);
    }
  } catch (const std::exception& error) {
    const char status = failed;
    const std::size_t length = std::strlen(error.what());
    writeAll(replies, &status, 1);
    writeAll(replies, &length, sizeof length);
    writeAll(replies, error.what(), length);
  }
  _exit(0);
}

}  // namespace

WorkerProcess::WorkerProcess(std::string name, const std::function<Serve()>& prepare,
                             std::size_t requestBytes, std::size_t replyBytes)
    : name_(std::move(name)), requestBytes_(requestBytes), replyBytes_(replyBytes) {
  std::signal(SIGPIPE, SIG_IGN);
  int toWorker[2], fromWorker[2];
  if (pipe(toWorker) != 0 || pipe(fromWorker) != 0)
    throw RunError(fmt::format("{}: no pipe: {}", name_, std::strerror(errno)));
  std::fflush(nullptr);
  process_ = fork();
  if (process_ < 0) throw RunError(fmt::format("{}: no process: {}", name_, std::strerror(errno)));
  if (process_ == 0) {
    close(toWorker[1]);
    close(fromWorker[0]);
    work(prepare, toWorker[0], fromWorker[1], requestBytes_, replyBytes_);
  }
  close(toWorker[0]);
  close(fromWorker[1]);
  requests_ = toWorker[1];
  replies_ = fromWorker[0];
}

WorkerProcess::~WorkerProcess() {
  close(requests_);
  close(replies_);
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
}

void WorkerProcess::fail(const std::string& message) {
  failure_ = fmt::format("{}: {}", name_, message);
  throw RunError(failure_);
}

void WorkerProcess::ask(const void* request, void* reply) {
  if (!failure_.empty()) throw RunError(failure_);
  // A worker that failed before it read this has left its message.
  writeAll(requests_, request, requestBytes_);
  char status = failed;
  std::size_t length = 0;
  if (readAll(replies_, &status, 1)) {
    if (status == done && readAll(replies_, reply, replyBytes_)) return;
    if (status == failed && readAll(replies_, &length, sizeof length)) {
      std::string message(length, ' ');
      if (readAll(replies_, message.data(), length)) fail(message);
    }
  }
  int how = 0;
  waitpid(process_, &how, 0);
  process_ = -1;
  fail(WIFSIGNALED(how)
           ? fmt::format("its process was ended by signal {} ({}){}", WTERMSIG(how),
                         strsignal(WTERMSIG(how)),
                         WTERMSIG(how) == SIGKILL
                             ? ": likely out of memory; ask for fewer particles with --largest"
                             : "")
           : "its process ended without a word");
}

}  // namespace plenum::bench
