#pragma once

namespace app {

/// Shows on standard error how far some work is, in one line that is written over again, where
/// standard error is a terminal. The line is gone in the end.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// @param share  done of the work, 0 to 1
  void show(double share);

 private:
  bool m_isShown;
  int m_percent = -1;  // on the terminal now
};

}  // namespace app
