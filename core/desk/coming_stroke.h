// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/desk/label_desk.h"

namespace nadir {

/// The document as it would be if a stroke that the hand is drawing were finished now, for the eye only: each frame paints no
/// more than the places that are new. Without a stroke it is the desk's own document.
class ComingStroke {
 public:
  /// Catches up with a desk. @returns what is different since the last call; everything at first, and where the document
  /// itself was opened anew or is too far on. O(objects + tiles) while a stroke grows.
  LabelChanges follow(const LabelDesk& desk);
  /// As of the last follow(); null before. Never changes.
  [[nodiscard]] const std::shared_ptr<const LabelDocument>& document() const { return document_; }

 private:
  /// What has been painted of a stroke.
  struct Painted {
    Ring places;
    double radius_m = 0.0;
    PaintValue value = kNoPaint;
  };
  [[nodiscard]] bool goes_on(const Painted& wanted) const;
  void paint(const Painted& wanted, std::size_t from);

  std::shared_ptr<const LabelDocument> document_;
  std::int64_t revision_ = 0;  ///< Of the desk's document below the stroke.
  Painted painted_;
  LabelChanges of_stroke_;  ///< All of it, for when it goes.
  LabelChanges new_;
};

}  // namespace nadir
