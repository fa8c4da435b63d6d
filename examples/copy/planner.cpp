// c++ -std=c++17 -O2 -pthread -DKERN_IMPLEMENTATION planner.cpp && ./a.out
// The safest of 50 places for a stone, found by four threads.
//
// With CMake, where this repository is the folder `kern` of your project:
//   add_executable(planner planner.cpp)
//   target_compile_features(planner PRIVATE cxx_std_17)
//   target_compile_definitions(planner PRIVATE KERN_IMPLEMENTATION)
//   target_include_directories(planner PRIVATE kern/examples/copy)
#include "wall.hpp"

#include <cstdio>
#include <future>

int main()
{
    kern::Wall wall;
    wall.ground({{-5, -1}, {9, -1}, {9, 0}, {-5, 0}}, "ground");
    wall.add({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 2400, "left");
    wall.add({{2.5, 0}, {4.2, 0}, {4.2, 1.2}, {2.5, 1}}, 2400, "right");
    const kern::Outline stone{{-.6, -.35}, {.5, -.42}, {.68, .1}, {.2, .45}, {-.52, .35}};
    std::vector<std::future<std::vector<kern::Place>>> jobs;
    for (int t = 0; t < 4; t++) // each has a wall of its own
        jobs.push_back(std::async(std::launch::async, [wall, &stone, t]() mutable {
            return wall.places(stone, 2400, t, t + 1, 12, {-.3, 0, .3});
        }));
    kern::Place best;
    for (auto &job : jobs)
        for (kern::Place &place : job.get())
            if (wall.better(place, best)) best = std::move(place);
    std::printf("x %.3f: stays %.3f, margin %.3f\n", best.rank.x, best.rank.stays, best.rank.margin);
    try { wall.add(stone, 2400, "third"); }
    catch (const kern::error &e) { std::printf("%s\n", e.what()); }
}
