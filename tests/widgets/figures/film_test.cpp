// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/film.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"
#include "widgets/figures/film_encoder.h"

namespace nadir {
namespace film_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Noise that moves, which no codec makes small.
class Noise : public Figure {
 public:
  explicit Noise(double length_s) : length_s_(length_s) {}
  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    Raster<Rgba> pixels(context.format().width, context.format().height);
    std::uint32_t state = 1U + static_cast<std::uint32_t>(1000.0 * time_s_);
    for (Rgba& pixel : pixels.values()) {
      state = state * 1664525U + 1013904223U;
      const auto grey = static_cast<std::uint8_t>(state >> 24U);
      pixel = {grey, grey, grey, 255};
    }
    canvas.image({0.0, 0.0, double(context.format().width), double(context.format().height)},
                 pixels);
    return {};
  }
  [[nodiscard]] std::optional<FigureTimes> times() const override {
    return FigureTimes{0.0, length_s_};
  }
  void show_at(double time_s) override { time_s_ = time_s; }

 private:
  double length_s_, time_s_ = 0.0;
};

FigureContext small_page() {
  PageFormat format;
  format.width = 320;
  format.height = 240;
  return FigureContext(format);
}

/// No file of this process may grow beyond so many bytes, while it lives: to a writer the same as a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST(Film, ThatDoesNotFitOnTheDiskIsAnErrorAndNoFile) {
  const ScratchFolder folder;
  const auto path = folder.path() / "film.mp4";
  Noise figure(2.0);
  FigureContext context = small_page();
  {
    const SmallDisk disk(50'000);
    const auto film = write_film(figure, context, {}, path, {});
    ASSERT_FALSE(film);
    EXPECT_EQ(film.error().code, ErrorCode::kIo);
    EXPECT_THAT(film.error().message,
                AllOf(HasSubstr("film.mp4: only "), HasSubstr(" of 51 frames could be written to"),
                      HasSubstr("is it full?")));
  }
  EXPECT_EQ(folder.entries(), 0);
  const auto film = write_film(figure, context, {}, path, {});
  ASSERT_TRUE(film) << film.error().message;
  EXPECT_EQ(film->frames, 51);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(Film, OfTooManyFramesIsRefusedBeforeTheFirst) {
  const ScratchFolder folder;
  Noise figure(4000.5);
  FigureContext context = small_page();
  const auto film =
      write_film(figure, context, {.fps = 25.0, .speed = 1.0}, folder.path() / "film.mp4", {});
  EXPECT_EQ(error_text(film), (folder.path() / "film.mp4").string() +
                                  ": 100013 frames are more than 100000; a lower --fps or a higher "
                                  "--speed makes fewer");
  EXPECT_EQ(error_code(film), ErrorCode::kInvalidOptions);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(FigureContext, DrawsAtTwiceTheSizeWhereOpenGlCan) {
  PageFormat format;
  format.width = 8192;
  format.height = 200;
  FigureContext context(format);
  EXPECT_EQ(context.supersampling, 2);
  format.width = 8193;
  context.set_format(format);
  EXPECT_EQ(context.supersampling, 1);
  format.width = 300;
  format.height = 16'000;
  context.set_format(format);
  EXPECT_EQ(context.supersampling, 1);
  EXPECT_EQ(context.format().height, 16'000);
}

/// Remembers the times that it was asked for.
class Witness : public Figure {
 public:
  explicit Witness(FigureTimes times) : times_(times) {}
  Result<void> draw(Canvas& /*canvas*/, FigureContext& /*context*/) override { return {}; }
  [[nodiscard]] std::optional<FigureTimes> times() const override { return times_; }
  void show_at(double time_s) override { shown_s.push_back(time_s); }
  std::vector<double> shown_s;

 private:
  FigureTimes times_;
};

TEST(Film, EndsAtItsEndAndNotByRoundingBehindIt) {
  const ScratchFolder folder;
  FigureContext context = small_page();
  Witness exact({0.0, 0.3});
  ASSERT_GT(3 * 0.1, 0.3);  // what is guarded against
  ASSERT_TRUE(write_film(exact, context, {.fps = 10.0}, folder.path() / "a.mp4", {}));
  EXPECT_THAT(exact.shown_s, ElementsAre(0.0, 0.1, 0.2, 0.3));
  // Times of day are known to 2.4e-7 s: the last frame is not lost for that.
  Witness early({0.0, 0.3 - 2.4e-7});
  ASSERT_TRUE(write_film(early, context, {.fps = 10.0}, folder.path() / "b.mp4", {}));
  EXPECT_THAT(early.shown_s, ElementsAre(0.0, 0.1, 0.2, 0.3 - 2.4e-7));
  Witness single({0.3 - 2.4e-7, 0.3 - 2.4e-7});
  ASSERT_TRUE(write_film(single, context, {.from_s = 0.3}, folder.path() / "c.mp4", {}));
  EXPECT_THAT(single.shown_s, ElementsAre(0.3 - 2.4e-7));
}

TEST(FilmEncoder, IsALibraryOfItsOwnAndSaysWhereItIsMissing) {
  EXPECT_TRUE(load_film_encoder());
  EXPECT_THAT(error_text(load_film_encoder("libnadir_no_film.so")),
              AllOf(HasSubstr("films cannot be encoded: libnadir_no_film.so: "),
                    HasSubstr("No such file")));
  EXPECT_THAT(error_text(load_film_encoder("libm.so.6")),  // there, but none of ours
              HasSubstr("nadir_make_film_encoder"));
}

}  // namespace film_test
}  // namespace nadir
