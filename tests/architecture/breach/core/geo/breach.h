// SPDX-License-Identifier: Apache-2.0
#pragma once
// A tree that breaks two rules: geo must not know the localiser, and headers of core must be light.
#include <opencv2/core.hpp>

#include "core/mcl/localiser.h"
