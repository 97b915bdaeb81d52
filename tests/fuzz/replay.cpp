// Gives files, and all files of folders, to a fuzz target one after another: what a fuzzer has
// found, without a fuzzer. Linked with the target, and takes the place of libFuzzer's main.
//
//     run_replay FILES|FOLDERS...      ends like a crash at the first fault
//     run_replay --show FILE           what the bytes mean

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

#include "tests/fuzz/target.h"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> filesIn(const fs::path& place) {
  if (!fs::is_directory(place)) return {place};
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(place))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

std::optional<std::vector<std::uint8_t>> bytesOf(const fs::path& file) {
  std::ifstream input(file, std::ios::binary);
  std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(input), {});
  if (!input) {
    std::fprintf(stderr, "%s: cannot be read\n", file.c_str());
    return std::nullopt;
  }
  return bytes;
}

bool replay(const fs::path& file) {
  const auto bytes = bytesOf(file);
  if (!bytes) return false;
  // Is read where it has ended the program.
  std::fprintf(stderr, "%s\n", file.c_str());
  LLVMFuzzerTestOneInput(bytes->data(), bytes->size());
  return true;
}

bool showMeaning(const fs::path& file) {
  const auto bytes = bytesOf(file);
  if (bytes) std::printf("%s\n", tests::meaningOf(*bytes).c_str());
  return bytes.has_value();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string_view(argv[1]) == "--show") return showMeaning(argv[2]) ? 0 : 1;
  int count = 0;
  for (int i = 1; i < argc; ++i)
    for (const fs::path& file : filesIn(argv[i])) {
      if (!replay(file)) return 1;
      ++count;
    }
  std::printf("%d files\n", count);
  return count > 0 ? 0 : 1;
}
