// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/base/result.h"

/// libFuzzer calls this once an input, replay_main.cpp once a file of the corpus.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace nadir {

/// Stops the program, which is how a fuzzer learns that a claim does not hold.
inline void fuzz_check(bool holds, const char* claim) {
  if (holds) return;
  (void)std::fprintf(stderr, "does not hold: %s\n", claim);
  std::abort();
}

/// Every fault is a sentence that names the file.
template <typename T>
void fuzz_check_error(const Result<T>& result, std::string_view name) {
  if (result) return;
  fuzz_check(result.error().message.find(name) != std::string::npos, "an error names its file");
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace nadir
