// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

/// The fields of an action in the order of its form, for what reads and writes its words.
// clang-format off
#define NADIR_ACTION_FIELDS(...)                                  \
  auto fields() { return std::tie(__VA_ARGS__); }                 \
  auto fields() const { return std::tie(__VA_ARGS__); }
// clang-format on
