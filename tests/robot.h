/* robot.h - the whole question of a robot beside one run of a simulator: a
   stone is lowered onto a made wall, and is asked whether it may be let go
   there. The simulator is Box2D 3 with -DBENCH_BOX2D, or none.

   SPDX-License-Identifier: MIT */

#ifndef ROBOT_H
#define ROBOT_H

#include "questions.h"

#ifdef BENCH_BOX2D
#include <box2d/box2d.h>
#endif

#define ROBOT_PLACES 8   /* most places on a wall                           */
#define ROBOT_CHANCE 0.5 /* of staying, from which a stone is let go        */
#define RUN_SECONDS 10   /* of simulated time, at most                      */
#define RUN_MOVES 0.1    /* bricks that a block moves, from which it moved  */
/* Box2D expects sizes of about a metre: a brick is one long. Accelerations
   grow alike, so that times stay as they are. */
#define RUN_SCALE (1 / LENGTH)

/* Steps of one placement, in the order in which they are asked. */
enum { POSE, TOUCH, BEARS, TRY, STAYS, STEPS };
static const char *const step_name[STEPS] = {"pose", "touch", "bears", "try",
                                             "stays"};

#ifdef BENCH_BOX2D

/* A block as a hull of at most 8 vertices about its centre. */
static inline b2BodyId run_body(b2WorldId world, const kern_block *b)
{
    b2BodyDef def = b2DefaultBodyDef();
    b2ShapeDef shape = b2DefaultShapeDef();
    b2Vec2 v[B2_MAX_POLYGON_VERTICES];
    b2Hull hull;
    b2Polygon polygon;
    b2BodyId body;
    int i;
    for (i = 0; i < b->vertices && i < B2_MAX_POLYGON_VERTICES; i++) {
        v[i].x = (float)((b->vertex[i].x - b->centre.x) * RUN_SCALE);
        v[i].y = (float)((b->vertex[i].y - b->centre.y) * RUN_SCALE);
    }
    hull = b2ComputeHull(v, i);
    polygon = b2MakePolygon(&hull, 0);
    def.type = b->fixed ? b2_staticBody : b2_dynamicBody;
    def.position.x = (float)(b->centre.x * RUN_SCALE);
    def.position.y = (float)(b->centre.y * RUN_SCALE);
    shape.material.friction = (float)MU;
    shape.density = b->fixed ? 0 : (float)(b->mass / fabs(b->area));
    body = b2CreateBody(world, &def);
    b2CreatePolygonShape(body, &shape, &polygon);
    return body;
}

/* One run at 60 Hz with 4 sub-steps, from the poses of the plan with the stone
   until all sleep. Returns 1 if no block moved, and 0 if one did. */
static inline int run_stays(const kern_plan *plan, const kern_block *stone)
{
    const int n = plan->task.s.blocks;
    b2BodyId *body = room_for((size_t)n + 1, sizeof *body);
    b2WorldDef def = b2DefaultWorldDef();
    b2WorldId world;
    int i, step, stays = 1;
    def.gravity.x = 0;
    def.gravity.y = (float)(-9.81 * RUN_SCALE);
    world = b2CreateWorld(&def);
    for (i = 0; i <= n; i++)
        body[i] = run_body(world, i < n ? &plan->block[i] : stone);
    for (step = 0; step < 60 * RUN_SECONDS; step++) {
        b2World_Step(world, 1.0f / 60, 4);
        if (b2World_GetAwakeBodyCount(world) == 0)
            break;
    }
    for (i = 0; i <= n; i++) {
        const kern_block *b = i < n ? &plan->block[i] : stone;
        const double x = b2Body_GetPosition(body[i]).x / RUN_SCALE;
        const double y = b2Body_GetPosition(body[i]).y / RUN_SCALE;
        if (!(hypot(x - b->centre.x, y - b->centre.y) <= RUN_MOVES * LENGTH))
            stays = 0;
    }
    b2DestroyWorld(world);
    free(body);
    return stays;
}

#endif
#endif
