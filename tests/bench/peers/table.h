#pragma once

#include <string>

namespace bench {

/// One line of the table: what was measured of us and of the best peer, and whether that is
/// what was aimed at.
struct Row {
  std::string work = {};
  std::string ours = {};
  std::string peer = {};   ///< the best one's figure and name; empty: no peer
  std::string ratio = {};  ///< peer / ours: above 1 is in our favor
  std::string aim = {};
  bool isReached = false;
};

/// Prints who measured, when and with what, and the table's head, in Markdown.
void printHeading();

/// Prints one line of the table at once: later rows may take long.
void print(const Row& row);

/// Prints what was left out, and the packages it needs; nothing if nothing was.
void printMissing();

/// `printf` into a string.
[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...);

/// A time [s] in the unit that suits it: "48 ns", "1.3 ms".
std::string duration(double seconds);

/// "3.4×", with as many digits as matter.
std::string times(double ratio);

}  // namespace bench
