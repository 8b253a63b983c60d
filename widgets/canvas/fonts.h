// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "widgets/canvas/canvas.h"

namespace nadir {

/// The family that a face is drawn with where it is installed.
[[nodiscard]] const char* font_family(FontFace face);

/// Asks fontconfig, which puts another family in the place of one that is missing and says nothing, and which Cairo draws
/// with strokes of its own where there is no font at all.
/// @returns a sentence for each family that is missing, with the one drawn in its place and the Debian package that has it:
/// then layouts and bytes differ from those of other machines.
/// @errors kUnsupported: no font at all.
[[nodiscard]] Result<std::vector<std::string>> check_fonts();

}  // namespace nadir
