// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/commands.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// The command that a chord means; null where it means none. Commands on labels, which have keys of their own, are left out.
[[nodiscard]] const Command* command_of(const kit::Chord& chord);

/// Whether a key that is held down does the command again and again: steps, zoom, undo.
[[nodiscard]] bool repeats_while_held(const Command& command);

/// The command whose keys went down in this frame; null for none. Not while a text is typed, but for chords that no text
/// takes; what lies over the window leaves only chords that show or close something.
/// @param draws_labels  Then commands on labels come first, and keys that go along a flight mean nothing ([ and ] are the
/// brush's); else keys of labels mean nothing.
[[nodiscard]] const Command* pressed_command(const kit::Ui& ui,
                                             bool is_overlay_open,
                                             bool draws_labels = false);

}  // namespace nadir
