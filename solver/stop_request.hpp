// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace plenum {

/// Takes SIGINT and SIGTERM as the wish to stop, for as long as it lives: the run writes a
/// checkpoint and ends at the next step that allows it. A second signal of the same kind ends the
/// program at once. One at a time.
class StopRequest {
 public:
  StopRequest();
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  /// The signal that came, or 0.
  static int signal();
};

}  // namespace plenum
