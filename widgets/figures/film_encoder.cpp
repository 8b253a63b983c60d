// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/film_encoder.h"

#include <dlfcn.h>

namespace nadir {

Result<std::unique_ptr<FilmEncoder>> load_film_encoder(const std::string& library) {
  const auto refused = [&library]() -> tl::unexpected<Error> {
    // It names the library itself.
    const char* const reason = ::dlerror();  // NOLINT(concurrency-mt-unsafe): of this thread
    return fail(ErrorCode::kUnsupported, "films cannot be encoded: {}",
                reason != nullptr ? reason : library + ": is no library of this Nadir");
  };
  // It stays until the program ends: what it brings along has threads and exit handlers of its own.
  void* const loaded = ::dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE);
  if (loaded == nullptr) return refused();
  void* const maker = ::dlsym(loaded, "nadir_make_film_encoder");
  if (maker == nullptr) return refused();
  return std::unique_ptr<FilmEncoder>(reinterpret_cast<FilmEncoder* (*)()>(maker)());
}

}  // namespace nadir
