// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <string>

#include "tests/fuzz/fuzz_check.h"
#include "widgets/canvas/png_file.h"

// The bytes are a figure, as somebody sends one to have it drawn again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using nadir::fuzz_check;
  constexpr const char* kName = "fuzzed.png";
  const auto texts = nadir::parse_png_texts(nadir::text_of(data, size), kName);
  nadir::fuzz_check_error(texts, kName);
  if (!texts) return 0;
  nadir::PngFacts facts;
  for (const auto& [keyword, text] : *texts) {
    fuzz_check(keyword.find('\0') == std::string::npos, "a keyword ends where it ends");
    fuzz_check(keyword.size() + text.size() < size, "a text comes from the file");
    if (!keyword.empty() && keyword.size() < 80) facts.texts[keyword] = text;
  }
  if (facts.texts.empty()) return 0;
  const std::string again = nadir::encode_png(nadir::Raster<nadir::Rgba>(1, 1), facts);
  const auto same = nadir::parse_png_texts(again, kName);
  fuzz_check(same.has_value() && *same == facts.texts, "a text is the same when it is kept");
  return 0;
}
