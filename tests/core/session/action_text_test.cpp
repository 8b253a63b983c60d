// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <limits>
#include <set>

#include "core/session/action.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace action_text_test {

using testing::AllOf;
using testing::HasSubstr;

struct NoAction {
  static constexpr std::string_view kForm = "no-action";
};
static_assert(std::is_convertible_v<actions::Seek, Action>);
static_assert(!std::is_convertible_v<NoAction, Action>, "a form makes no action");

std::string again(const Action& action) {
  const auto parsed = parse_action(action_text(action));
  if (!parsed) return parsed.error().message;
  return *parsed == action ? "" : action_text(action) + " became " + action_text(*parsed);
}

template <std::size_t... I>
std::vector<Action> one_of_each(std::index_sequence<I...> /*all*/) {
  return {Action(std::variant_alternative_t<I, AnyAction>())...};
}

/// Every kind of action as it is made by default, which leaves optional arguments out and texts empty.
std::vector<Action> default_actions() {
  return one_of_each(std::make_index_sequence<std::variant_size_v<AnyAction>>());
}

TEST(ActionText, OfEveryActionGivesTheSameActionAgain) {
  for (const Action& action : default_actions()) EXPECT_EQ(again(action), "");
}

TEST(ActionText, HasEveryArgument) {
  using namespace actions;  // NOLINT(google-build-using-namespace)
  const std::vector<std::pair<Action, std::string>> known = {
      {OpenFile{"/tmp/a.nadir"}, "open /tmp/a.nadir"},
      {OpenFile{"/my runs/a b.nadir"}, "open \"/my runs/a b.nadir\""},
      {OpenDemo{}, "open-demo"},
      {CloseRun{2}, "close-run 2"},
      {Seek{12.5}, "seek 12.5"},
      {Seek{1.0 / 3.0}, "seek 0.3333333333333333"},
      {GoToMoment{12.5}, "moment 12.5"},
      {StepBy{-10}, "step -10"},
      {GoTo{Moment::kPreviousWorst}, "go previous-worst"},
      {Play{Switch::kOn}, "play on"},
      {SetSpeed{0.5}, "speed 0.5"},
      {SetLoop{}, "loop"},
      {SetLoop{1.0, 2.5}, "loop 1 2.5"},
      {LookAt{-3.5, 4.0, std::nullopt}, "look -3.5 4"},
      {LookAt{-3.5, 4.0, 80.0}, "look -3.5 4 80"},
      {Zoom{2.0, 3.0, 4.0}, "zoom 2 3 4"},
      {GoToPlace{"17S KT 1234 5678"}, "place \"17S KT 1234 5678\""},
      {SelectParticle{7}, "select-particle 7"},
      {SelectParticle{}, "select-particle"},
      {ShowLayer{Layer::kErrorSurface, Switch::kOff}, "layer error-surface off"},
      {SetLayerColour{Layer::kTruth, "#AABBCC"}, "layer-colour truth #AABBCC"},
      {MoveStrip{Strip::kNees, -1}, "strip-move nees -1"},
      {ShowOverlay{Overlay::kPalette}, "show palette"},
      {SetOption{"particles", "500"}, "option particles 500"},
      {SetOption{"particles", std::nullopt}, "option particles"},
      {Rerun{RerunFrom::kCursor}, "rerun cursor"},
      {CancelJob{3}, "cancel 3"},
      {ExportFigure{"my figures/a.svg", std::nullopt}, "export \"my figures/a.svg\""},
      {ExportFigure{"a.png", "compare"}, "export a.png compare"},
      {ExportFigure{"a.png", "compare", 2400}, "export a.png compare 2400"},
      {AddBookmark{}, "bookmark"},
      {AddBookmark{""}, "bookmark \"\""},
      {EditBookmark{2, "two\nlines"}, "bookmark-note 2 \"two\\nlines\""},
      {Copy{"say \"hello\""}, "copy \"say \\\"hello\\\"\""},
      {Copy{"back\\slash"}, "copy back\\slash"},
      {DismissNotice{}, "dismiss"},
      {OpenLabels{"/my maps/town"}, "label \"/my maps/town\""},
      {AddPlace{1.5, -2, 0.25, SelectHow::kAdd}, "point 1.5 -2 0.25 add"},
      {AddPlace{1.5, -2, {}, {}}, "point 1.5 -2"},
      {DrawLine{"road", 3.5, {{{0.0, 1.0}, {-2.5, 1e-7}}}}, "draw-line road 3.5 0,1 -2.5,1e-07"},
      {SelectLabels{{{3, 17}}}, "select-labels 3 17"},
      {SelectLabels{}, "select-labels"},
      {RecodeLabels{"road", "curb", {}}, "recode road curb"}};
  for (const auto& [action, words] : known) {
    EXPECT_EQ(action_text(action), words);
    EXPECT_EQ(again(action), "");
  }
}

TEST(ActionText, KeepsAnyTextWhole) {
  for (const std::string text :
       {"", " ", "\"", "\\", "a \\ b", "\n", "a\tb", "\\n", "ends in a backslash \\",
        "# no comment", "\"quoted\"", "ümläut ☃", "-5", "[x]", "{on|off}", "\x01", "two  blanks"}) {
    for (const Action& action :
         {Action(actions::Copy{text}), Action(actions::SetOption{text, text}),
          Action(actions::ExportFigure{text, text}), Action(actions::EditBookmark{1, text}),
          Action(actions::AddBookmark{text})}) {
      EXPECT_EQ(again(action), "") << text;
    }
  }
}

TEST(ActionText, KeepsEveryBitOfANumber) {
  for (const double value : {0.1, -1e-300, 1e300, 123456789.123456789, 5e-324}) {
    EXPECT_EQ(again(actions::Seek{value}), "");
  }
  EXPECT_EQ(again(actions::StepBy{std::numeric_limits<int>::min()}), "");
}

TEST(ParseAction, TakesTheRestOfALineAsTheLastText) {
  const auto place = parse_action("  place 32.4 N,  83.7 W  ");
  ASSERT_TRUE(place) << error_text(place);
  EXPECT_EQ(*place, Action(actions::GoToPlace{"32.4 N,  83.7 W"}));
  EXPECT_EQ(*parse_action("bookmark wrong turn here"),
            Action(actions::AddBookmark{"wrong turn here"}));
  EXPECT_EQ(*parse_action("open /my runs/a.nadir"), Action(actions::OpenFile{"/my runs/a.nadir"}));
}

TEST(ParseAction, TogglesASwitchThatIsNotNamed) {
  EXPECT_EQ(*parse_action("play"), Action(actions::Play{Switch::kToggle}));
  EXPECT_EQ(*parse_action("layer truth"),
            Action(actions::ShowLayer{Layer::kTruth, Switch::kToggle}));
  EXPECT_EQ(*parse_action("follow off"), Action(actions::Follow{Switch::kOff}));
}

struct Refusal {
  const char *text, *message;
};

class ParseActionRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(ParseActionRefusal, IsOneSentenceThatSaysTheForm) {
  EXPECT_EQ(error_text(parse_action(GetParam().text)), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    ParseActionRefusal,
    testing::Values(
        Refusal{"", "no action is named"},
        Refusal{"   ", "no action is named"},
        Refusal{"sek 1", "sek: no such action (did you mean seek?)"},
        Refusal{"xyzzy", "xyzzy: no such action"},
        Refusal{"seek", "seek: SECONDS is missing (seek SECONDS)"},
        Refusal{"seek abc", "seek abc: SECONDS is not a number (seek SECONDS)"},
        Refusal{"seek 1s", "seek 1s: SECONDS is not a number (seek SECONDS)"},
        Refusal{"seek nan", "seek nan: SECONDS is not a number (seek SECONDS)"},
        Refusal{"seek inf", "seek inf: SECONDS is not a number (seek SECONDS)"},
        Refusal{"seek 1 2", "seek: '2' is too much (seek SECONDS)"},
        Refusal{"step 1.5", "step 1.5: COUNT is not a whole number (step COUNT)"},
        Refusal{"step 99999999999", "step 99999999999: COUNT is not a whole number (step COUNT)"},
        Refusal{"quit now", "quit: 'now' is too much (quit)"},
        Refusal{"loop 1", "loop: TO is missing (loop [FROM TO])"},
        Refusal{"zoom 2 3", "zoom: NORTH is missing (zoom FACTOR [EAST NORTH])"},
        Refusal{"fit moon",
                "fit moon: 'moon' is none of flight, map, particles (fit "
                "{flight|map|particles})"},
        Refusal{"fit particle",
                "fit particle: 'particle' is none of flight, map, particles; did you "
                "mean particles? (fit {flight|map|particles})"},
        Refusal{"play maybe",
                "play maybe: 'maybe' is none of off, on, toggle (play {on|off|toggle})"},
        Refusal{"copy \"no end", "copy \"no end: the quotes of TEXT do not end (copy TEXT)"},
        Refusal{"copy \"a\"b", "copy b: TEXT goes on after its quotes (copy TEXT)"},
        Refusal{"bookmark-note 1", "bookmark-note: NOTE is missing (bookmark-note NUMBER NOTE)"},
        Refusal{"draw-area road 1,2 3",
                "draw-area 3: '3' is no place: write EAST,NORTH (draw-area CLASS EAST,NORTH...)"},
        Refusal{"draw-area road 1,nan",
                "draw-area 1,nan: '1,nan' is no place: write EAST,NORTH (draw-area CLASS "
                "EAST,NORTH...)"},
        Refusal{"select-labels 1 x",
                "select-labels x: 'x' is not a whole number (select-labels [OBJECT...])"},
        Refusal{"open", "open: PATH is missing (open PATH)"}));

TEST(ParseAction, NeverThrowsWhateverItIsGiven) {
  const std::string letters = "seek loop\"\\ 1.5-en[]{}|\n\t#";
  std::uint32_t state = 1;
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    for (int i = 0; i < round % 23; ++i) {
      state = state * 1664525U + 1013904223U;
      text += letters[(state >> 16U) % letters.size()];
    }
    const auto parsed = parse_action(text);
    if (parsed) {
      EXPECT_EQ(again(*parsed), "") << text;
    }
  }
}

TEST(ActionHelps, NameEveryActionOnceWithItsForm) {
  const auto helps = action_helps();
  ASSERT_EQ(helps.size(), std::variant_size_v<AnyAction>);
  std::set<std::string_view> names;
  for (const ActionHelp& help : helps) {
    EXPECT_TRUE(help.form.starts_with(help.name)) << help.form;
    EXPECT_FALSE(help.help.empty());
    EXPECT_NE(help.help.back(), '.') << help.help;
    names.insert(help.name);
  }
  EXPECT_EQ(names.size(), helps.size());
  EXPECT_EQ(action_name(actions::SetLayerOpacity{}), "layer-opacity");
}

TEST(ActionHelps, HaveAsManyArgumentsInTheFormAsTheActionHas) {
  for (const Action& action : default_actions()) {
    const std::size_t fields = std::visit(
        [](const auto& one) { return std::tuple_size_v<decltype(one.fields())>; }, action);
    const std::string_view form = action_helps()[action.index()].form;
    EXPECT_EQ(static_cast<std::size_t>(std::count(form.begin(), form.end(), ' ')), fields) << form;
  }
}

}  // namespace action_text_test
}  // namespace nadir
