// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/run/evaluate_run.h"
#include "core/run/run_file.h"
#include "tests/fuzz/fuzz_check.h"

// The bytes are a run file, as somebody sends one: it is opened, listed, read step by step and
// evaluated.
namespace {

namespace fs = std::filesystem;
using nadir::fuzz_check;
using nadir::fuzz_check_error;

/// One file a process, in memory where the system has a folder for that.
fs::path fuzzed_file() {
  const std::string name = "nadir-run-fuzz-" + std::to_string(::getpid());
  return (fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) / name;
}

void check_step(const nadir::RunReader& run, int number, const std::string& name) {
  const auto step = run.step(number);
  fuzz_check_error(step, name);
  if (!step) return;
  fuzz_check(step->step == number, "the step asked for");
  if (step->particles) {
    double sum = 0.0;
    for (const double weight : step->particles->weight) sum += weight;
    fuzz_check(step->particles->empty() || std::abs(sum - 1.0) < 1e-6, "weights sum to one");
    fuzz_check(step->particles->x_in_enu_m.size() == step->particles->size(), "arrays are as long");
  }
  if (step->topview) {
    const auto& begin = step->topview->class_begin;
    for (std::size_t id = 0; id + 1 < begin.size(); ++id) {
      fuzz_check(begin.at(id) <= begin.at(id + 1), "classes are grouped");
    }
    fuzz_check(begin.back() == step->topview->cells.size(), "every cell has a class");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fs::path path = fuzzed_file();
  const std::string name = path.string();
  std::ofstream(path, std::ios::binary) << nadir::text_of(data, size);
  {
    const auto run = nadir::RunReader::open(path);
    fuzz_check_error(run, name);
    if (run) {
      fuzz_check(run->step_count() >= 0, "a number of steps");
      const auto steps = run->steps();
      fuzz_check_error(steps, name);
      int left = 20;
      for (std::size_t i = 0; steps && i < steps->size() && left > 0; ++i, --left) {
        fuzz_check(i == 0 || (*steps)[i - 1].time_s <= (*steps)[i].time_s, "in order of time");
        check_step(*run, (*steps)[i].step, name);
      }
      fuzz_check_error(nadir::evaluate_run(*run, path), name);
      fuzz_check_error(nadir::evaluate_run(*run, path, nadir::Alignment::kSim2), name);
    }
  }
  std::error_code ignored;
  fs::remove(path, ignored);
  fs::remove(name + "-journal", ignored);
  return 0;
}
