#pragma once

namespace bench {

/// Each prints its rows of the table; those whose packages were missing when the program was
/// built are left out, or have no figure of that peer.

void printMethodRows();   ///< one pendulum: per step, and to an accuracy
void printBatchRows();    ///< many weights side by side
void printContactRows();  ///< a ball that bounces, Galperin's billiard
void printMemoryRows();
/// @param isThorough  10,000 weights as well, and 10 s of every crowd: takes minutes
void printCrowdRows(bool isThorough);
void printHeapRows();
void printStartRows();  ///< the program itself

}  // namespace bench
