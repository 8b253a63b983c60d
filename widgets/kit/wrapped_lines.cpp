// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/wrapped_lines.h"

#include <algorithm>

namespace nadir::kit {
namespace {

constexpr std::size_t kLongestUnit = 4;

bool begins_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }
bool is_digit(char sign) { return sign >= '0' && sign <= '9'; }

/// Bytes of the first `count` characters.
std::size_t byte_count_of(std::string_view text, std::size_t count) {
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    if (begins_character(text[at]) && count-- == 0) break;
  }
  return at;
}

/// What is too long for a line, in pieces: after a slash in the second half of the line, else anywhere.
void append_pieces(std::string_view word, std::size_t most, std::vector<std::string>& pieces) {
  while (character_count(word) > most) {
    std::size_t end = byte_count_of(word, most);
    const std::size_t slash = word.find_last_of("/\\", end - 1);
    if (slash != std::string_view::npos && slash + 1 >= end / 2) end = slash + 1;
    pieces.emplace_back(word.substr(0, end));
    word.remove_prefix(end);
  }
  if (!word.empty()) pieces.emplace_back(word);
}

struct Word {
  std::string text;
  bool follows_space = true;  ///< False: the rest of one that was too long.
};

/// What a line may begin with.
std::vector<Word> unbroken_words(std::string_view line, std::size_t most) {
  std::vector<Word> words;
  std::size_t at = 0;
  while ((at = line.find_first_not_of(' ', at)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find(' ', at), line.size());
    const std::string_view word = line.substr(at, end - at);
    at = end;
    if (!words.empty() && is_digit(words.back().text.back()) && !is_digit(word.front()) &&
        character_count(word) <= kLongestUnit &&
        character_count(words.back().text) + 1 + character_count(word) <= most) {
      (words.back().text += ' ') += word;
      continue;
    }
    std::vector<std::string> pieces;
    append_pieces(word, most, pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i) words.push_back({pieces[i], i == 0});
  }
  return words;
}

std::vector<std::string> filled(const std::vector<Word>& words, std::size_t most) {
  std::vector<std::string> lines;
  for (const Word& word : words) {
    const std::size_t space = word.follows_space ? 1 : 0;
    if (!lines.empty() &&
        character_count(lines.back()) + space + character_count(word.text) <= most) {
      if (word.follows_space) lines.back() += ' ';
      lines.back() += word.text;
    } else {
      lines.push_back(word.text);
    }
  }
  return lines;
}

}  // namespace

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

std::vector<std::string> wrapped_lines(std::string_view words, std::size_t most) {
  most = std::max<std::size_t>(most, 1);
  std::vector<std::string> lines;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find('\n'), words.size());
    const std::string_view line = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    if (character_count(line) <= most) {
      lines.emplace_back(line);
      continue;
    }
    const std::vector<Word> part = unbroken_words(line, most);
    std::vector<std::string> best = filled(part, most);
    // As narrow as the same number of lines allows.
    for (std::size_t width = most; best.size() > 1 && width > 1; --width) {
      std::vector<std::string> narrower = filled(part, width - 1);
      const bool is_in_width =
          std::all_of(narrower.begin(), narrower.end(),
                      [width](const std::string& one) { return character_count(one) < width; });
      if (narrower.size() > best.size() || !is_in_width) break;
      best = std::move(narrower);
    }
    lines.insert(lines.end(), best.begin(), best.end());
  }
  return lines;
}

}  // namespace nadir::kit
