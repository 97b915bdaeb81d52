#pragma once

#include <cstdio>

namespace core {

/// Whether a person reads what is written there, and not a file or another program.
bool isTerminal(std::FILE* stream);

/// The number under which the system knows a stream; from now on bytes pass as they are.
int descriptorOf(std::FILE* stream);

/// Lets writing to a pipe whose reader has gone fail, where it would end the program.
void outliveClosedPipes();

}  // namespace core
