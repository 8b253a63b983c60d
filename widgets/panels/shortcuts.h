// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/commands.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// The command that a chord means; null where it means none. A chord means the same everywhere.
[[nodiscard]] const Command* command_of(const kit::Chord& chord);

/// Whether a key that is held down does the command again and again: steps, zoom, undo.
[[nodiscard]] bool repeats_while_held(const Command& command);

/// The command whose keys went down in this frame; null for none. Not while a text is typed, but for chords that no text
/// takes; what lies over the window leaves only chords that show or close something.
[[nodiscard]] const Command* pressed_command(const kit::Ui& ui, bool is_overlay_open);

}  // namespace nadir
