#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

/// What a fuzz target does with bytes; ends the program where something is wrong. The name is
/// libFuzzer's.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace tests {

/// What those bytes stand for, for a person to read.
std::string meaningOf(std::span<const std::uint8_t> bytes);

/// Ends the program as a crash would, unless the fault is empty.
void endAt(const std::string& fault);

}  // namespace tests
