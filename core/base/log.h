// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace nadir {

enum class LogLevel { kWarning, kError };

/// Takes one message: a sentence in one line, without a full stop or a level before it. May be called from any thread, and
/// from several at once.
using LogSink = std::function<void(LogLevel level, const std::string& line)>;

/// For what cannot be returned as a Result, because a library says it in the middle of its work. The line breaks of the
/// message become spaces, and very long messages are cut. Any thread.
void write_log(LogLevel level, std::string_view message);

/// Says where write_log() leads from now on, in the whole process: the window shows a list, tests collect. This is the one
/// thing here that the process shares, for libraries report to the process and know nothing of who called them.
/// @param sink  Empty: lines "warning: ..." and "error: ..." on standard error, as from the start.
/// @returns the sink before. Another thread may still be in it, so a sink owns, or shares, all that it uses.
LogSink set_log_sink(LogSink sink);

}  // namespace nadir
