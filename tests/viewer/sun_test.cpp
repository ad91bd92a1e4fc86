// A sun by place and time in the viewer's state.

#include "preprocess/base/error.hpp"
#include "src/viewer/commands.hpp"
#include "src/viewer/day_clock.hpp"
#include "src/viewer/sun_day.hpp"
#include "src/viewer/sun_drawing.hpp"
#include "src/viewer/sun_following.hpp"

#include <gtest/gtest.h>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;
using namespace std::chrono_literals;

SunState sunAt(const char* time, double north = 0.0) {
    return {{48.14, 11.57}, sun::localTimeFromText(time), north};
}

const glm::dvec4 lampPlace(1, 2, 3, 1);

/// A lamp, preceded by the sun by place and time.
ViewState placed(const char* time = "2026-06-21T14:30+02:00") {
    ViewState before;
    before.lights = {{lampPlace}};
    ViewState next = before;
    next.sun = sunAt(time);
    return withSun(before, next);
}

} // namespace

TEST(SunState, ChangesKeepWhatTheyDoNotName) {
    ViewState state;
    state.lights = {{lampPlace}};
    state = changed(state, Json::parse(R"({"sun": {"place": [-33.87, 151.21],
        "time": "2024-02-29T12:00:30+11:00"}, "day_playing": true})"));
    ASSERT_TRUE(state.sun);
    EXPECT_EQ(state.sun->north, 0.0);
    EXPECT_TRUE(state.dayPlays);
    state = changed(state, Json::parse(R"({"sun": {"north": -30}})"));
    EXPECT_EQ(toJson(state)["sun"], Json::parse(R"({"place": [-33.87, 151.21],
        "time": "2024-02-29T12:00:30+11:00", "north": -30.0})"));
    EXPECT_EQ(changed(state, toJson(state)).sun, state.sun);
    EXPECT_FALSE(changed(state, {{"sun", nullptr}}).sun);
}

TEST(SunState, WhatIsWrongIsNamed) {
    ViewState state;
    state.lights = {{lampPlace}};
    for (const auto& [changes, words] :
         {std::pair(R"({"sun": 3})", "sun is 3"),
          {R"({"sun": {"place": [48, 11]}})", "a sun with a 'place' and a 'time'"},
          {R"({"sun": {"time": "2026-06-21T14:30+02:00"}})", "'place'"},
          {R"({"sun": {"place": [91, 0], "time": "2026-06-21T14:30Z"}})", "sun.place: 91"},
          {R"({"sun": {"place": [0, "east"], "time": "2026-06-21T14:30Z"}})", "sun.place[1]"},
          {R"({"sun": {"place": [0, 0], "time": "2023-02-29T12:00Z"}})", "sun.time: '2023-02-29"},
          {R"({"sun": {"place": [0, 0], "time": 12}})", "sun.time is 12"},
          {R"({"sun": {"north": 361}})", "sun.north"},
          {R"({"sun": {"south": 0}})", "sun.south"},
          {R"({"day_playing": 1})", "day_playing"}})
        try {
            changed(state, Json::parse(changes));
            ADD_FAILURE() << changes;
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), ExitStatus::usage);
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        }
}

TEST(SunFollowing, ItStandsBeforeTheLampsAndIsChosen) {
    const ViewState state = placed();
    ASSERT_EQ(state.lights.size(), 2u);
    EXPECT_EQ(state.lights[0].position, glm::dvec4(state.sun->direction(), 0.0));
    EXPECT_EQ(state.lights[1].position, lampPlace);
    EXPECT_EQ(state.chosenLight, 0u);
}

TEST(SunFollowing, ASunThatIsFirstAlreadyBecomesIt) {
    ViewState before;
    before.lights = {{{0, 1, 0, 0}}, {lampPlace}};
    before.lights[0].color = glm::vec3(1.0f, 0.5f, 0.25f);
    ViewState next = before;
    next.sun = sunAt("2026-06-21T14:30+02:00", 20.0);
    const ViewState state = withSun(before, next);
    ASSERT_EQ(state.lights.size(), 2u);
    EXPECT_EQ(state.lights[0].position, glm::dvec4(next.sun->direction(), 0.0));
    EXPECT_EQ(state.lights[0].color, before.lights[0].color);
}

TEST(SunFollowing, TimeMovesIt) {
    const ViewState before = placed();
    ViewState next = before;
    next.sun = sunAt("2026-06-21T18:00+02:00");
    const ViewState state = withSun(before, next);
    ASSERT_EQ(state.lights.size(), 2u);
    EXPECT_NE(state.lights[0].position, before.lights[0].position);
    EXPECT_EQ(state.lights[0].position, glm::dvec4(next.sun->direction(), 0.0));
}

TEST(SunFollowing, WhoMovesItTakesItFromItsPlace) {
    const ViewState before = placed();
    ViewState moved = before;
    moved.dayPlays = true;
    moved.lights[0].position = {0, 1, 0, 0};
    ViewState state = withSun(before, moved);
    EXPECT_FALSE(state.sun);
    EXPECT_FALSE(state.dayPlays);
    EXPECT_EQ(state.lights[0].position, moved.lights[0].position);

    ViewState removed = before;
    removed.lights.erase(removed.lights.begin());
    EXPECT_FALSE(withSun(before, removed).sun);

    ViewState other = before;
    other.lights[1].position = {4, 5, 6, 1};
    EXPECT_TRUE(withSun(before, other).sun);
}

TEST(SunFollowing, AFullHouseOfLampsGivesOneUp) {
    ViewState before;
    before.lights.assign(mostLights, {lampPlace});
    ViewState next = before;
    next.sun = sunAt("2026-06-21T14:30+02:00");
    const ViewState state = withSun(before, next);
    EXPECT_EQ(state.lights.size(), mostLights);
    EXPECT_EQ(state.lights[0].position.w, 0.0);
}

TEST(SunFollowing, NightIsDown) {
    EXPECT_FALSE(sunIsDown(placed()));
    EXPECT_TRUE(sunIsDown(placed("2026-06-21T01:00+02:00")));
    ViewState none;
    none.lights = {{{0, -1, 0, 0}}};
    EXPECT_FALSE(sunIsDown(none)) << "a typed sun may shine from below";
}

TEST(SunFollowing, KeysMoveItThroughTheDayAndTheYear) {
    const ViewState state = placed();
    const auto timeAfter = [&](Command command) {
        return sun::textOf(after(command, state, {}).sun->time);
    };
    EXPECT_EQ(timeAfter(Command::later), "2026-06-21T14:40+02:00");
    EXPECT_EQ(timeAfter(Command::earlier), "2026-06-21T14:20+02:00");
    EXPECT_EQ(timeAfter(Command::dayLater), "2026-06-22T14:30+02:00");
    EXPECT_EQ(timeAfter(Command::dayEarlier), "2026-06-20T14:30+02:00");
    EXPECT_TRUE(after(Command::toggleDay, state, {}).dayPlays);
    ViewState none;
    none.lights = {{lampPlace}};
    for (const Command command : {Command::toggleDay, Command::later, Command::dayEarlier}) {
        EXPECT_FALSE(after(command, none, {}).sun);
        EXPECT_FALSE(after(command, none, {}).dayPlays);
    }
    EXPECT_FALSE(after(Command::reset, state, {}).sun);
}

TEST(SunFollowing, TimesStayWithinTheYearsThatThereAre) {
    const auto textAfter = [](const char* time, std::chrono::seconds by) {
        return sun::textOf(movedBy(sunAt(time), by).time);
    };
    EXPECT_EQ(textAfter("2100-12-31T23:55-05:00", 10min), "2100-12-31T23:59:59-05:00");
    EXPECT_EQ(textAfter("1900-01-01T00:05+09:00", -24h), "1900-01-01T00:00+09:00");
}

TEST(DayClock, GoesRoundWithinTheDayAtAnHourASecond) {
    ViewState state = placed("2026-06-21T22:00+02:00");
    DayClock clock;
    EXPECT_FALSE(clock.advance(10.0, state)) << "it doesn't play";
    state.dayPlays = true;
    EXPECT_FALSE(clock.advance(20.0, state)) << "nothing has passed yet";
    state.sun = clock.advance(21.5, state);
    ASSERT_TRUE(state.sun);
    EXPECT_EQ(sun::textOf(state.sun->time), "2026-06-21T23:30+02:00");
    state.sun = clock.advance(22.5, state);
    EXPECT_EQ(sun::textOf(state.sun->time), "2026-06-21T00:30+02:00");
    // Short frames lose nothing to rounding to whole seconds.
    for (int i = 1; i <= 1000; ++i)
        if (const auto moved = clock.advance(22.5 + i / 1000.0 + 1e-9, state)) state.sun = moved;
    EXPECT_EQ(sun::textOf(state.sun->time), "2026-06-21T01:30+02:00");
}

TEST(SunDays, HaveTheSunsWayWithItsHours) {
    SunDays days;
    const SunDay& day = days.of(sunAt("2026-06-21T14:30+02:00"));
    ASSERT_EQ(day.arcs.size(), 1u);
    int hours = 0;
    for (const ArcPoint& point : day.arcs[0]) {
        EXPECT_NEAR(glm::length(point.direction), 1.0, 1e-12);
        EXPECT_GT(point.direction.y, -0.001);
        hours += point.fullHour;
    }
    EXPECT_EQ(hours, 16) << "6 to 21 o'clock";
    EXPECT_EQ(sun::textOf(*day.rise).substr(0, 13), "2026-06-21T05");
    EXPECT_EQ(sun::textOf(*day.set).substr(0, 13), "2026-06-21T21");
    const Json json = toJson(sunAt("2026-06-21T14:30+02:00").position(), day);
    EXPECT_EQ(json["up"], true);
    EXPECT_TRUE(json["rise"].is_string());
    // Another hour has the same day, another date hasn't.
    EXPECT_EQ(&days.of(sunAt("2026-06-21T20:00+02:00")), &day);
    const auto noonOf = [](const SunDay& of) {
        double highest = 0.0;
        for (const ArcPoint& point : of.arcs.at(0))
            highest = std::max(highest, point.direction.y);
        return highest;
    };
    const double june = noonOf(day);
    EXPECT_GT(june, noonOf(days.of(sunAt("2026-12-21T20:00+01:00"))) + 0.5);
}

TEST(SunDays, ThePolarDayHasNeitherRiseNorSet) {
    SunDays days;
    SunState tromso = sunAt("2026-06-21T12:00+02:00");
    tromso.place = {69.65, 18.96};
    EXPECT_EQ(days.of(tromso).arcs.size(), 1u);
    EXPECT_FALSE(days.of(tromso).rise);
    EXPECT_FALSE(days.of(tromso).set);
    tromso.time = sun::localTimeFromText("2026-12-21T12:00+01:00");
    EXPECT_TRUE(days.of(tromso).arcs.empty());
    EXPECT_TRUE(toJson(tromso.position(), days.of(tromso))["rise"].is_null());
}

TEST(SunDays, AreDrawnWhereTheyAreBeforeTheEye) {
    SunDays days;
    ViewState state = placed();
    state.camera = {{0, 3, 12}, {0, 0, 0}, 45.0};
    Stage stage;
    stage.bounds.add({-1, -1, -1});
    stage.bounds.add({1, 1, 1});
    stage.width = 200;
    stage.height = 100;
    const SunDay& day = days.of(*state.sun);
    const auto drawn = sunTriangles(day, state, stage);
    EXPECT_GT(drawn.size(), sunTriangles(SunDay(), state, stage).size());
    EXPECT_EQ(drawn.size() % 3, 0u);
    // With the eye in the middle of the sphere half of it is behind the eye.
    state.camera = {{0, 0, 0}, {0, 0, -1}, 45.0};
    EXPECT_LT(sunTriangles(day, state, stage).size(), drawn.size());
}

} // namespace edgeshade::viewer
