// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>

#include "core/geo/world_file.h"
#include "core/map/image_date.h"
#include "tests/fuzz/fuzz_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using nadir::fuzz_check;
  constexpr const char* kName = "fuzzed.wld";
  const std::string_view text = nadir::text_of(data, size);
  const auto read = nadir::parse_world_file(text, kName);
  nadir::fuzz_check_error(read, kName);
  if (read) {
    fuzz_check(read->linear.allFinite() && read->offset.allFinite(), "a place is finite");
    fuzz_check(read->inverse().has_value(), "each place has a pixel");
    const auto again = nadir::parse_world_file(nadir::world_file_text(*read), kName);
    fuzz_check(!again || again->linear == read->linear, "what is written comes back");
  }
  for (const auto& day : {nadir::day_of(text), nadir::day_in_name(text)}) {
    fuzz_check(!day || day->size() == 10, "a day has ten letters");
  }
  return 0;
}
