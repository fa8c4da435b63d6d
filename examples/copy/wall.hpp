/* wall.hpp - kern.h for C++17, with memory of its own.

       kern::Wall wall;
       wall.ground({{-5, -1}, {5, -1}, {5, 0}, {-5, 0}});
       wall.add({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 2400, "first");
       kern_margin m = wall.measure();

   A Wall owns vertices, contacts and work memory, and grows. A copy is
   independent: give one to each thread. Bad input throws kern::error, which
   names the blocks; no exception passes through kern.h, and a wall is as it was
   before what threw, std::bad_alloc included. Define
   KERN_IMPLEMENTATION in one other file, or before this one is included.

   SPDX-License-Identifier: MIT */

#pragma once

#include "../../kern.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace kern
{

using Outline = std::vector<kern_vec>;

struct error : std::runtime_error {
    int status; /* a kern_status */
    kern_fault fault;

    error(int s, const kern_fault &f, const std::string &what)
        : std::runtime_error(what), status(s), fault(f)
    {
    }
};

/* A place for one more stone. */
struct Place {
    kern_place rank{};       /* for kern_place_compare(), x and turn         */
    Outline outline;         /* of the stone there                           */
    int status = KERN_FALLS; /* KERN_STANDS, KERN_FALLS, or why it is refused */

    bool stands() const { return status == KERN_STANDS; }
};

class Wall
{
  public:
    /* Options and gravity count for stones that are added later. */
    explicit Wall(const kern_options &options = kern_defaults(),
                  kern_vec gravity = {0, kern_real(-9.81)})
    {
        reserve(8, KERN_CONTACTS(8));
        plan_.task.options = options;
        plan_.task.s.gravity = gravity;
    }

    Wall(const Wall &other)
        : stones_(other.stones_), alone_(other.alone_),
          measured_(other.measured_)
    {
        reserve(other.plan_.block_room, other.plan_.contact_room);
        check(kern_plan_copy(&plan_, &other.plan_));
        for (std::size_t i = 0; i < stones_.size(); i++)
            block_[i].vertex = stones_[i].outline.data();
    }

    /* Leaves an empty wall with the same options, which may be used. */
    Wall(Wall &&other)
        : Wall(other.plan_.task.options, other.plan_.task.s.gravity)
    {
        swap(other);
    }

    Wall &operator=(Wall other) noexcept
    {
        swap(other);
        return *this;
    }

    ~Wall() = default;

    void swap(Wall &other) noexcept
    {
        stones_.swap(other.stones_);
        block_.swap(other.block_);
        contact_.swap(other.contact_);
        motion_.swap(other.motion_);
        force_.swap(other.force_);
        real_.swap(other.real_);
        index_.swap(other.index_);
        std::swap(work_, other.work_);
        std::swap(plan_, other.plan_);
        std::swap(alone_, other.alone_);
        std::swap(measured_, other.measured_);
        plan_.task.work = &work_; /* the arrays moved, these did not */
        other.plan_.task.work = &other.work_;
    }

    /* Add ground, or a stone. Return its index. */
    int ground(Outline outline, std::string name = {})
    {
        return append({std::move(outline), 0, true, std::move(name)});
    }
    int add(Outline outline, kern_real density, std::string name = {})
    {
        return append({std::move(outline), density, false, std::move(name)});
    }

    void remove(int i)
    {
        check(kern_plan_remove(&plan_, i));
        stones_.erase(stones_.begin() + i); /* outlines keep their vertices */
        measured_ = false;
    }

    int blocks() const { return plan_.task.s.blocks; }
    const Outline &outline(int i) const { return stone(i).outline; }
    const std::string &name(int i) const { return stone(i).name; }
    const kern_plan &plan() const { return plan_; }

    /* The margin; 0 where it falls. */
    kern_margin measure()
    {
        if (!measured_) {
            alone_ = kern_margin{};
            const int status = kern_measure(&plan_.task, &alone_, nullptr);
            if (status != KERN_NO_FREE) // bare ground: its margin counts as 0
                check(status);
        }
        measured_ = true;
        return alone_;
    }

    /* Where a stone comes to rest that is let down at x, turned by an angle;
       nothing where it falls past the wall, or does not stop rolling. */
    std::optional<Outline> rest(const Outline &shape, kern_real x,
                                kern_real turn = 0)
    {
        const kern_block stone = made(shape, 1);
        Outline out(shape.size());
        kern_pose pose;
        const kern_vec by = {std::cos(turn), std::sin(turn)};
        const int status = kern_rest(&plan_.task, &stone, x, by, out.data(),
                                     &pose);
        if (status == KERN_NO_SUPPORT || status == KERN_NO_REST)
            return std::nullopt;
        check(status);
        return out;
    }

    /* What the wall is with one more stone: first whether it stands, then its
       margin and the chance that the stone stays. */
    Place attempt(Outline outline, kern_real density)
    {
        const kern_block stone = made(outline, density);
        Place p;
        kern_margin m{};
        measure();
        p.status = roomy(
            [&] { return kern_plan_bears(&plan_, &stone, 0, nullptr); });
        if (p.status == KERN_STANDS)
            p.status = roomy(
                [&] { return kern_plan_try(&plan_, &stone, &m, nullptr); });
        if (p.status == KERN_STANDS
            && roomy([&] {
                   return kern_plan_stays(&plan_, &stone, &p.rank.stays);
               }) != KERN_STANDS)
            p.rank.stays = 0;
        p.rank.margin = m.margin;
        p.outline = std::move(outline);
        return p;
    }

    /* The chance that the last stone stays where it was added. */
    kern_real stays()
    {
        kern_real chance = 0;
        check(kern_plan_stays(&plan_, nullptr, &chance));
        return chance;
    }

    /* The stone's own margin and the least load factor of the wall with it: 0
       where a limit ends it. places() asks where the other numbers tie. */
    void complete(Place &p, kern_real density)
    {
        const kern_block stone = made(p.outline, density);
        kern_collapse all;
        kern_real side[2] = {0, 0};
        std::vector<kern_real> own(std::size_t(blocks()) + 1);
        check(roomy([&] { return kern_plan_add(&plan_, &stone); }));
        if (kern_profile(&plan_.task, KERN_SHRINK, own.data(), &all) >= 0)
            p.rank.own = own.back();
        if (kern_load_factor(&plan_.task, 0, KERN_LEFT, &side[0], nullptr)
                == KERN_STANDS
            && kern_load_factor(&plan_.task, 0, KERN_RIGHT, &side[1], nullptr)
                   == KERN_STANDS)
            p.rank.load = std::min(side[0], side[1]);
        check(kern_plan_remove(&plan_, blocks() - 1));
    }

    /* Places where the wall stands with a stone let down at so many x from
       `low` to `high`, in each of some turns: the best first. */
    std::vector<Place> places(const Outline &shape, kern_real density,
                              kern_real low, kern_real high, int count,
                              const std::vector<kern_real> &turns = {0})
    {
        std::vector<Place> found;
        for (kern_real turn : turns)
            for (int i = 0; i < count; i++) {
                const kern_real x = low
                                  + (high - low)
                                        * (kern_real(i) + kern_real(.5))
                                        / kern_real(count);
                std::optional<Outline> at = rest(shape, x, turn);
                Place p;
                if (at)
                    p = attempt(std::move(*at), density);
                p.rank.x = x;
                p.rank.turn = turn;
                if (p.stands())
                    found.push_back(std::move(p));
            }
        for (Place &p : found)
            if (std::any_of(found.begin(), found.end(), [&](const Place &q) {
                    return &p != &q && ties(p, q);
                }))
                complete(p, density);
        std::sort(
            found.begin(), found.end(),
            [this](const Place &a, const Place &b) { return better(a, b); });
        return found;
    }

    /* Whether a is the better of two places on this wall. */
    bool better(const Place &a, const Place &b)
    {
        if (!a.stands() || !b.stands())
            return a.stands();
        return kern_place_compare(&a.rank, &b.rank, measure().margin) > 0;
    }

  private:
    struct Stone {
        Outline outline;
        kern_real density;
        bool fixed;
        std::string name;
    };

    /* Whether stays and margin do not tell which of two places is better. */
    bool ties(const Place &a, const Place &b)
    {
        kern_place p = a.rank, q = b.rank;
        p.own = p.load = p.x = p.turn = 0;
        q.own = q.load = q.x = q.turn = 0;
        return kern_place_compare(&p, &q, measure().margin) == 0;
    }

    /* Asks again in larger arrays while these are too short. */
    template <class Ask> int roomy(Ask ask)
    {
        int status;
        if (blocks() + 1 >= plan_.block_room)
            reserve(2 * plan_.block_room, 2 * plan_.contact_room);
        while ((status = ask()) == KERN_NO_SPACE)
            reserve(plan_.block_room, 2 * plan_.contact_room);
        return status;
    }

    const Stone &stone(int i) const { return stones_.at(std::size_t(i)); }

    std::string called(int i) const
    {
        if (i >= 0 && std::size_t(i) < stones_.size() && !name(i).empty())
            return name(i);
        return i >= 0 && i < blocks() ? "block " + std::to_string(i)
                                      : "the new stone";
    }

    /* Throws where a status or a count is below 0. */
    void check(int status) const
    {
        const kern_fault &f = work_.fault;
        if (status >= 0)
            return;
        std::string what = kern_status_text(status);
        if (f.block >= 0)
            what += ": " + called(f.block);
        if (f.other >= 0)
            what += " and " + called(f.other);
        throw error(status, f, what);
    }

    kern_block made(const Outline &v, kern_real density, bool fixed = false)
    {
        kern_block b;
        const int n = int(v.size());
        const int status = fixed
                             ? kern_ground_init(&b, v.data(), n, &work_.fault)
                             : kern_block_init(&b, v.data(), n, density,
                                               &work_.fault);
        if (status < 0)
            work_.fault.block = blocks();
        check(status);
        return b;
    }

    /* Adds a stone after the others, in larger arrays if these are short. Its
       name is known while the plan refuses it. */
    int append(Stone s)
    {
        stones_.push_back(std::move(s)); /* its vertices do not move */
        try {
            const Stone &last = stones_.back();
            const kern_block b = made(last.outline, last.density, last.fixed);
            check(roomy([&] { return kern_plan_add(&plan_, &b); }));
        } catch (...) {
            stones_.pop_back();
            throw;
        }
        measured_ = false;
        return blocks() - 1;
    }

    /* Moves the plan to larger arrays. The wall is as it was if there is no
       memory. */
    void reserve(int blocks, int contacts)
    {
        const std::size_t n = std::size_t(blocks), c = std::size_t(contacts);
        std::vector<kern_block> block(n);
        std::vector<kern_contact> contact(c);
        std::vector<kern_motion> motion(n);
        std::vector<kern_force> force(c);
        std::vector<kern_real> real(std::size_t(KERN_REALS(blocks, contacts)));
        std::vector<int> index(std::size_t(KERN_INTS(blocks, contacts)));
        kern_work work = kern_work_of(real.data(), int(real.size()),
                                      index.data(), int(index.size()));
        kern_plan plan = kern_plan_of(
            block.data(), blocks, contact.data(), contacts,
            kern_known_of(motion.data(), force.data()), &work);
        if (plan_.block)
            check(kern_plan_copy(&plan, &plan_));
        plan.task.work = &work_;
        block_.swap(block);
        contact_.swap(contact);
        motion_.swap(motion);
        force_.swap(force);
        real_.swap(real);
        index_.swap(index);
        work_ = work;
        plan_ = plan;
    }

    std::vector<Stone> stones_;
    std::vector<kern_block> block_;
    std::vector<kern_contact> contact_;
    std::vector<kern_motion> motion_;
    std::vector<kern_force> force_;
    std::vector<kern_real> real_;
    std::vector<int> index_;
    kern_work work_{};
    kern_plan plan_{};
    kern_margin alone_{};
    bool measured_ = false; /* alone_ is that of the wall as it is */
};

} /* namespace kern */
