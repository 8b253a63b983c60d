// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/settings.h"
#include "tests/fuzz/fuzz_check.h"

namespace {

using nadir::fuzz_check;
using nadir::fuzz_check_error;
using nadir::Settings;

constexpr const char* kName = "fuzzed.toml";
constexpr int kMaxDepth = 4;

/// Asks for every key in every type, as the readers of maps, flights and recipes do.
void ask_everything(const Settings& settings, int depth) {
  for (const std::string& key : settings.keys()) {
    const auto number = settings.number(key);
    fuzz_check_error(number, kName);
    if (number) fuzz_check(std::isfinite(*number), "a number is finite");
    const auto numbers = settings.numbers(key);
    fuzz_check_error(numbers, kName);
    if (numbers) {
      fuzz_check(
          std::all_of(numbers->begin(), numbers->end(), [](double v) { return std::isfinite(v); }),
          "a list of numbers is finite");
    }
    fuzz_check_error(settings.integer(key), kName);
    fuzz_check_error(settings.boolean(key), kName);
    fuzz_check_error(settings.text(key), kName);
    fuzz_check_error(settings.texts(key), kName);
    fuzz_check_error(settings.scalar_as_text(key), kName);
    fuzz_check_error(settings.number_or(key, 0.0), kName);
    fuzz_check_error(settings.text_or(key, ""), kName);

    const auto table = settings.table(key);
    fuzz_check_error(table, kName);
    if (table && depth < kMaxDepth) ask_everything(*table, depth + 1);
    const auto tables = settings.tables(key);
    fuzz_check_error(tables, kName);
    if (tables && depth < kMaxDepth) {
      for (const Settings& element : *tables) ask_everything(element, depth + 1);
    }
  }
  (void)nadir::nearest_word("particle-count", settings.keys());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = nadir::text_of(data, size);
  const auto settings = Settings::parse(text, kName);
  fuzz_check_error(settings, kName);
  if (settings) ask_everything(*settings, 0);

  const auto quoted = Settings::parse("x = " + nadir::toml_quoted(text), kName);
  fuzz_check(quoted.has_value(), "a quoted text can be read");
  fuzz_check(quoted->text("x").value() == text, "and is the same text");
  return 0;
}
