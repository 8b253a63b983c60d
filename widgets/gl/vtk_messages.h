// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace nadir {

/// From now on what VTK complains of goes to write_log(), in one line each, and nowhere else: VTK's own way is a window, or
/// standard error. Does its work once a process; the contexts and the render window call it.
void send_vtk_messages_to_log();

/// What a message of VTK says without the places of its source and without addresses: "ERROR: In /a/b.cxx, line 7\n
/// vtkFoo (0x55d0): no input\n\n" is "vtkFoo: no input".
[[nodiscard]] std::string plain_vtk_message(const std::string& message);

}  // namespace nadir
