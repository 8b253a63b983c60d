// SPDX-License-Identifier: Apache-2.0
// Which commands a few letters may mean.
#include <algorithm>
#include <cctype>
#include <optional>

#include "core/session/commands.h"

namespace nadir {
namespace {

/// How what was typed fits a text; the less the better.
enum Fit { kWhole, kBeginning, kWordBeginnings, kInitials, kPart, kLettersOfAWord };

std::string lowered(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return lower;
}

std::vector<std::string_view> words_in(std::string_view text) {
  constexpr std::string_view kBetween = " -:,()?";
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = text.find_first_not_of(kBetween);
    if (begin == std::string_view::npos) return words;
    text.remove_prefix(begin);
    const std::size_t end = std::min(text.find_first_of(kBetween), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

bool has_in_order(std::string_view word, std::string_view letters) {
  if (word.empty() || word.front() != letters.front()) return false;
  std::size_t at = 0;
  for (const char letter : letters) {
    at = word.find(letter, at);
    if (at == std::string_view::npos) return false;
    ++at;
  }
  return true;
}

/// "fitpar" of "fit" and "particles": beginnings of words run together, in their order; some may be passed over.
bool are_initials(std::string_view letters,
                  const std::vector<std::string_view>& words,
                  std::size_t from) {
  if (letters.empty()) return true;
  for (std::size_t i = from; i < words.size(); ++i) {
    const std::size_t most = std::min(letters.size(), words[i].size());
    for (std::size_t taken = 1; taken <= most; ++taken) {
      if (words[i][taken - 1] != letters[taken - 1]) break;
      if (are_initials(letters.substr(taken), words, i + 1)) return true;
    }
  }
  return false;
}

/// Of one word that was typed, over all words of a text.
std::optional<Fit> fit_of_word(std::string_view typed, const std::vector<std::string_view>& words) {
  constexpr std::size_t kLeastLetters = 3;  // fewer are in order in nearly everything
  std::optional<Fit> best;
  for (const std::string_view word : words) {
    std::optional<Fit> fit;
    if (word.substr(0, typed.size()) == typed) {
      fit = kWordBeginnings;
    } else if (word.find(typed) != std::string_view::npos) {
      fit = kPart;
    } else if (typed.size() >= kLeastLetters && has_in_order(word, typed)) {
      fit = kLettersOfAWord;
    }
    if (fit && (!best || *fit < *best)) best = fit;
  }
  return best;
}

/// Both in lower case, `typed` not empty.
std::optional<Fit> fit_of(std::string_view typed, std::string_view text) {
  if (text.size() > 3 && text.substr(text.size() - 3) == "...") text.remove_suffix(3);
  if (text == typed) return kWhole;
  if (text.substr(0, typed.size()) == typed) return kBeginning;
  const std::vector<std::string_view> words = words_in(text);
  Fit worst = kWordBeginnings;
  bool has_all = true;
  std::string letters;
  for (const std::string_view word : words_in(typed)) {
    letters += word;
    const auto fit = fit_of_word(word, words);
    has_all = has_all && fit;
    if (fit) worst = std::max(worst, *fit);
  }
  if (letters.empty()) return std::nullopt;
  if (has_all && worst == kWordBeginnings) return worst;
  if (are_initials(letters, words, 0)) return kInitials;
  return has_all ? std::optional(worst) : std::nullopt;
}

/// The less the better: by fit, then by where: in the title, among other words for it, in the words of scripts.
std::optional<int> misfit_of(const Command& command, std::string_view typed) {
  constexpr int kPerFit = 4;
  std::optional<int> best;
  const auto take = [&best](std::optional<Fit> fit, int place) {
    if (!fit) return;
    const int misfit = kPerFit * static_cast<int>(*fit) + place;
    best = std::min(best.value_or(misfit), misfit);
  };
  take(fit_of(typed, lowered(command.title)), 0);
  const std::string others = lowered(command.also);
  const std::vector<std::string_view> words = words_in(others);
  const bool is_one = std::find(words.begin(), words.end(), typed) != words.end();
  const auto also = fit_of(typed, others);
  if (also) take(is_one ? kBeginning : std::max(*also, kWordBeginnings), 1);
  take(fit_of(typed, lowered(command.text)), 2);
  const std::string shortcut = lowered(command.shortcut);
  if (shortcut == typed) take(kWhole, 3);
  if (shortcut.size() > typed.size() && typed.size() > 1 && shortcut.starts_with(typed)) {
    take(kWordBeginnings, 3);
  }
  return best;
}

}  // namespace

std::vector<const Command*> matching_commands(std::string_view typed,
                                              std::span<const std::string> recent) {
  while (!typed.empty() && typed.front() == ' ') typed.remove_prefix(1);
  while (!typed.empty() && (typed.back() == ' ' || typed.back() == '.')) typed.remove_suffix(1);
  struct Match {
    const Command* command = nullptr;
    int misfit = 0;
    std::ptrdiff_t age = 0;  ///< Place among the recent ones; behind them for all others.
  };
  std::vector<Match> matches;
  const std::string wanted = lowered(typed);
  for (const Command& command : session_commands()) {
    const auto misfit = wanted.empty() ? std::optional(0) : misfit_of(command, wanted);
    if (!misfit) continue;
    const auto age = std::find(recent.begin(), recent.end(), command.text) - recent.begin();
    matches.push_back(Match{&command, *misfit, age});
  }
  std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
    return a.misfit != b.misfit ? a.misfit < b.misfit : a.age < b.age;
  });
  std::vector<const Command*> commands;
  commands.reserve(matches.size());
  for (const Match& match : matches) commands.push_back(match.command);
  return commands;
}

}  // namespace nadir
