// Our core beside what a user might take instead, in one run: Boost.Odeint and GSL for methods,
// Box2D and Chipmunk for contacts. Prints the table of the README.
//
//     peers_bench [--thorough] [PART …]
//
// Parts: batches contacts crowds heap memory methods start; all of them unless some are named.
// --thorough: crowds of 10,000 weights as well, and 10 s of every crowd; takes minutes.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/bench/peers/rows.h"
#include "tests/bench/peers/table.h"

namespace {

struct Part {
  std::string name;
  void (*print)(bool isThorough);
};

const std::vector<Part> kParts{
    {"methods", [](bool) { bench::printMethodRows(); }},
    {"batches", [](bool) { bench::printBatchRows(); }},
    {"contacts", [](bool) { bench::printContactRows(); }},
    {"memory", [](bool) { bench::printMemoryRows(); }},
    {"crowds", bench::printCrowdRows},
    {"heap", [](bool) { bench::printHeapRows(); }},
#ifdef BENCH_PROGRAM
    {"start", [](bool) { bench::printStartRows(); }},
#endif
};

int fail(const std::string& name) {
  std::fprintf(stderr, "peers_bench: no part is called %s; there are", name.c_str());
  for (const Part& part : kParts) std::fprintf(stderr, " %s", part.name.c_str());
  std::fputs("\n", stderr);
  return EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> wanted(argv + 1, argv + argc);
  const bool isThorough = std::erase(wanted, "--thorough") > 0;
  for (const std::string& name : wanted)
    if (std::ranges::find(kParts, name, &Part::name) == kParts.end()) return fail(name);
  bench::printHeading();
  for (const Part& part : kParts)
    if (wanted.empty() || std::ranges::find(wanted, part.name) != wanted.end())
      part.print(isThorough);
  bench::printMissing();
  return EXIT_SUCCESS;
}
