// SPDX-License-Identifier: Apache-2.0
#include "core/session/folder_reader.h"

#include <utility>

namespace nadir {

FolderReader::~FolderReader() {
  if (reading_) reading_->request_stop();
}

void FolderReader::begin() {
  if (reading_) {
    reading_->request_stop();
    leaving_.push_back(std::move(*reading_));
    reading_.reset();
  }
  if (folder_.empty()) return;
  reading_.emplace(
      [folder = folder_](const WorkContext& context,
                         const auto& /*publish*/) -> Result<std::shared_ptr<const FolderListing>> {
        auto listing = list_folder(folder, context);
        if (!listing) return forward_error(listing);
        return std::make_shared<const FolderListing>(std::move(*listing));
      });
}

void FolderReader::take_over() {
  std::erase_if(leaving_, [](const Reading& reading) { return reading.is_done(); });
  if (!reading_ || !reading_->is_done()) return;
  auto outcome = std::move(*reading_->outcome());
  reading_.reset();
  listing_ = outcome ? std::move(*outcome) : nullptr;
  fault_ = outcome ? std::string() : outcome.error().message;
}

void FolderReader::look(const std::filesystem::path& folder) {
  take_over();
  if (folder == folder_) return;
  folder_ = folder;
  listing_.reset();
  fault_.clear();
  begin();
}

}  // namespace nadir
