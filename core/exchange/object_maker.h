// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "core/exchange/label_import.h"
#include "core/exchange/source_features.h"

namespace nadir {

/// Makes objects of features. Private to this module.

/// Takes a layer's places onto a plane; nothing where one has no place there.
using EnuFromLayer = std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d&)>;

/// Objects for a document, one feature after the other.
class ObjectMaker {
 public:
  /// @param faults  That the reader has met.
  ObjectMaker(const LabelDocument& document, Tally faults);

  void add(const SourceFeature& feature, const ImportRules& rules, const EnuFromLayer& to_enu);
  [[nodiscard]] ImportedLabels finish() &&;

 private:
  void add_lines(LabelObject object, SourceForm form, const ImportRules::Drawn& drawn);
  void add_object(LabelObject object, const ImportRules::Drawn& drawn);
  [[nodiscard]] std::int64_t next_order(ClassId id);

  const LabelDocument& document_;
  Tally faults_;
  ObjectId next_id_;
  std::map<int, std::int64_t> next_orders_;  ///< By level.
  ImportedLabels made_;
  std::size_t unknown_ = 0, outside_ = 0;
};

}  // namespace nadir
