#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// What a process takes of its system: what would grow if something were never given back.
struct ProcessFigures {
  double residentMiB = 0;  ///< memory that is in use now, as the system sees it
  double heapMiB = 0;      ///< memory that was asked for and not given back yet
  int handles = 0;         ///< open files and the like
  int threads = 0;
};

/// Of this process, now.
ProcessFigures figuresNow();

/// What became of a program that was run to its end.
struct Ended {
  int status = -1;         ///< −1: it did not end by itself
  double peakMiB = 0;      ///< the most memory it had in use
  double seconds = 0;      ///< from start to end
  std::int64_t lines = 0;  ///< that it wrote to standard output
};

/// Runs a program, and reads its standard output to the end.
/// @param command  the program's path and its arguments
Ended runToEnd(const std::vector<std::string>& command);
