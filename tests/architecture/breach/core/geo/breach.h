// SPDX-License-Identifier: Apache-2.0
#pragma once
// A tree that breaks three rules: geo must not know the localiser, headers of core must be light, and what is installed must
// not include what is not.
#include <opencv2/core.hpp>

#include "core/geo/number_lines.h"
#include "core/mcl/localiser.h"
