// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/stop_request.hpp"

#include <csignal>
#include <initializer_list>

namespace plenum {

namespace {

volatile std::sig_atomic_t caught = 0;

void note(int signal) { caught = signal; }

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);  // the second one is the system's
  sigaction(signal, &action, nullptr);
}

}  // namespace

StopRequest::StopRequest() {
  caught = 0;
  for (const int signal : {SIGINT, SIGTERM}) handle(signal, note);
}

StopRequest::~StopRequest() {
  for (const int signal : {SIGINT, SIGTERM}) handle(signal, SIG_DFL);
}

int StopRequest::signal() { return caught; }

}  // namespace plenum
