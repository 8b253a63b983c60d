// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

/// A precondition. Breaking it is a bug of ours, not bad input: throws std::logic_error, which each
/// command catches once.
#define NADIR_REQUIRE(condition)                                                    \
  do {                                                                              \
    if (!(condition)) {                                                             \
      throw std::logic_error(std::string(__FILE__ ":") + std::to_string(__LINE__) + \
                             ": broken precondition: " #condition);                 \
    }                                                                               \
  } while (false)
