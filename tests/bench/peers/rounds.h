#pragma once

#include <functional>
#include <string>
#include <vector>

namespace bench {

/// Work that is timed beside other work.
struct Contender {
  std::string name;
  std::function<void()> work;
};

struct Timing {
  double time;   ///< median processor time of the work once [s]
  double ratio;  ///< median over the rounds of this time / the first contender's
};

/// Times all contenders by Google Benchmark, one after the other, and that again for as many
/// rounds: what slows the machine down for a while slows all of them, and the ratios stay.
///
/// @return  in the order of the contenders
std::vector<Timing> timed(const std::vector<Contender>& contenders, int rounds = 7);

/// The same for work that takes long: each contender once a round.
std::vector<Timing> timedOnce(const std::vector<Contender>& contenders, int rounds);

/// @pre not empty
double median(std::vector<double> values);

}  // namespace bench
