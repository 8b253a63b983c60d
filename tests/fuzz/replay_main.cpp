// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/fuzz/fuzz_check.h"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The file whole, and cut short at up to sixty-four places, for truncated files are what crashes
/// leave behind.
void replay(const fs::path& file) {
  constexpr std::size_t kCuts = 64;
  std::ifstream stream(file, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(stream)),
                                std::istreambuf_iterator<char>());
  const std::size_t step = std::max<std::size_t>(1, bytes.size() / kCuts);
  for (std::size_t size = 0; size < bytes.size(); size += step) {
    // A copy of its own, so that a sanitizer sees a read beyond the end.
    const std::vector<std::uint8_t> cut(bytes.begin(),
                                        bytes.begin() + static_cast<std::ptrdiff_t>(size));
    (void)LLVMFuzzerTestOneInput(cut.data(), cut.size());
  }
  const std::vector<std::uint8_t> whole(bytes.begin(), bytes.end());
  (void)LLVMFuzzerTestOneInput(whole.data(), whole.size());
}

}  // namespace

/// Stands in for libFuzzer where there is none: replays the files of the folders named on the
/// command line.
int main(int argc, char** argv) {
  try {
    std::size_t count = 0;
    for (int i = 1; i < argc; ++i) {
      for (const fs::path& file : files_in(argv[i])) {
        (void)std::printf("%s\n", file.filename().c_str());
        (void)std::fflush(stdout);
        replay(file);
        ++count;
      }
    }
    if (count == 0) {
      (void)std::fprintf(stderr, "there is no file to replay\n");
      return 1;
    }
    return 0;
  } catch (const std::exception& error) {
    (void)std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
