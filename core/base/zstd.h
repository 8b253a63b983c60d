// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace nadir {

/// One zstd frame that says how long its content is, with a checksum, so that flipped bits are found.
[[nodiscard]] std::vector<std::uint8_t> zstd_packed(std::span<const std::uint8_t> content);

/// Bytes of the content, as a frame says; nothing where it says nothing or is none.
[[nodiscard]] std::optional<std::uint64_t> zstd_content_bytes(std::span<const std::uint8_t> frame);

/// The content of a frame from anybody. @param most_bytes  Compared with what the frame says before anything is allocated.
/// @returns nothing where it is longer, where that is no frame, and where it is damaged.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> zstd_unpacked(
    std::span<const std::uint8_t> frame, std::uint64_t most_bytes);

}  // namespace nadir
