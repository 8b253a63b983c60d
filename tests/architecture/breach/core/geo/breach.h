// SPDX-License-Identifier: Apache-2.0
#pragma once
// A tree that breaks the dependency rule: geo must not know the localiser.
#include "core/mcl/localiser.h"
