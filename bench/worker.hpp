// SPDX-License-Identifier: GPL-3.0-or-later
//
// A process of its own for each case, so that its memory is its own; it keeps its state between
// measurements, so that those of several cases can take turns.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>

namespace plenum::bench {

/// The process and its two pipes; messages are bytes.
class WorkerProcess {
 public:
  using Serve = std::function<void(const void* request, void* reply)>;

  /// Starts a process that calls prepare() and then what it returned for each request. Must be
  /// called before this process has had several threads.
  WorkerProcess(std::string name, const std::function<Serve()>& prepare, std::size_t requestBytes,
                std::size_t replyBytes);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// Throws RunError with the worker's message, or with what ended it.
  void ask(const void* request, void* reply);

 private:
  [[noreturn]] void fail(const std::string& message);

  std::string name_;
  std::size_t requestBytes_, replyBytes_;
  pid_t process_ = -1;
  int requests_ = -1, replies_ = -1;
  std::string failure_;  // of the first request that failed
};

/// A worker that turns each Request into a Reply.
template <class Request, class Reply>
class Worker {
  static_assert(std::is_trivially_copyable_v<Request> && std::is_trivially_copyable_v<Reply>);

 public:
  using Serve = std::function<Reply(const Request&)>;

  Worker(std::string name, const std::function<Serve()>& prepare)
      : process_(
            std::move(name),
            [&]() -> WorkerProcess::Serve {
              return [serve = prepare()](const void* request, void* reply) {
                *static_cast<Reply*>(reply) = serve(*static_cast<const Request*>(request));
              };
            },
            sizeof(Request), sizeof(Reply)) {}

  Reply ask(const Request& request) {
    Reply reply;
    process_.ask(&request, &reply);
    return reply;
  }

 private:
  WorkerProcess process_;
};

}  // namespace plenum::bench
