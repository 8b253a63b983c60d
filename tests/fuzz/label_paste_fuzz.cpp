// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "core/edit/edit_objects.h"
#include "tests/fuzz/fuzz_check.h"

namespace {

using nadir::fuzz_check;

nadir::LabelDocument blank() {
  return {*nadir::ProjectPlane::create({48.9877, 8.3877}), {1.0, {0.0, 0.0}, 100, 100}};
}

}  // namespace

/// What comes from the clipboard may be anything.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  nadir::LabelDocument document = blank();
  const auto edit = nadir::paste(document, nadir::text_of(data, size), {0.0, 0.0});
  if (!edit) {
    fuzz_check(!edit.error().message.empty(), "a refusal says why");
    return 0;
  }
  fuzz_check(document.check(*edit).has_value(), "what is pasted is sound");
  document.apply(*edit);
  std::vector<nadir::ObjectId> all;
  for (const auto& [id, placed] : document.objects()) all.push_back(id);
  if (all.empty()) return 0;
  nadir::LabelDocument other = blank();
  const auto text = nadir::objects_text(document, all);
  fuzz_check(text.has_value(), "what is there can be copied");
  const auto again = nadir::paste(other, *text, {0.0, 0.0});
  fuzz_check(again.has_value(), "what was copied can be pasted");
  other.apply(*again);
  fuzz_check(other.objects().size() == all.size(), "and is as much");
  return 0;
}
