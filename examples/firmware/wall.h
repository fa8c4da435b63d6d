/* wall.h: a dry-stacked wall of 30 irregular stones, as polygons in flash [m].

   Five courses on level ground; beds are uneven and head joints 12 mm open.
   The candidate lies on the bed that rises from (0.65, 1.272) to (1.55, 1.275);
   it is written where it lies at the place 0. */

#ifndef WALL_H
#define WALL_H

#include "../../kern.h"

#define WALL_STONES 30
#define DENSITY 2400.0f /* [kg/m^2] a metre deep */

static const kern_vec ground[4] = {{-1, -0.5f}, {4, -0.5f}, {4, 0}, {-1, 0}};

static const kern_vec stone0[] = {
    {0.02f, 0}, {0.344f, 0}, {0.337f, 0.2604f}, {-0.008f, 0.2557f}};
static const kern_vec stone1[] = {
    {0.356f, 0}, {0.764f, 0}, {0.768f, 0.2664f}, {0.349f, 0.2606f}};
static const kern_vec stone2[] = {{0.776f, 0},
                                  {1.157f, 0},
                                  {1.159f, 0.2674f},
                                  {0.81f, 0.267f},
                                  {0.78f, 0.2666f}};
static const kern_vec stone3[] = {
    {1.169f, 0}, {1.565f, 0}, {1.546f, 0.2679f}, {1.171f, 0.2674f}};
static const kern_vec stone4[] = {{1.577f, 0},       {2.023f, 0},
                                  {2.001f, 0.2549f}, {1.9f, 0.256f},
                                  {1.64f, 0.268f},   {1.558f, 0.2679f}};
static const kern_vec stone5[] = {{2.035f, 0},
                                  {2.383f, 0},
                                  {2.405f, 0.2551f},
                                  {2.18f, 0.253f},
                                  {2.013f, 0.2548f}};
static const kern_vec stone6[] = {
    {0.121f, 0.2574f}, {0.475f, 0.2624f}, {0.491f, 0.5168f}, {0.131f, 0.5138f}};
static const kern_vec stone7[] = {
    {0.487f, 0.2625f}, {0.798f, 0.2668f}, {0.826f, 0.5196f}, {0.503f, 0.5169f}};
static const kern_vec stone8[] = {
    {0.81f, 0.267f}, {1.143f, 0.2674f}, {1.148f, 0.5222f}, {0.838f, 0.5197f}};
static const kern_vec stone9[] = {
    {1.155f, 0.2674f}, {1.522f, 0.2679f}, {1.501f, 0.5198f}, {1.44f, 0.519f},
    {1.39f, 0.51f},    {1.36f, 0.524f},   {1.16f, 0.5223f}};
static const kern_vec stone10[] = {{1.534f, 0.2679f}, {1.64f, 0.268f},
                                   {1.885f, 0.2567f}, {1.885f, 0.5243f},
                                   {1.81f, 0.524f},   {1.513f, 0.52f}};
static const kern_vec stone11[] = {{1.897f, 0.2561f}, {1.9f, 0.256f},
                                   {2.18f, 0.253f},   {2.253f, 0.2537f},
                                   {2.255f, 0.5257f}, {1.897f, 0.5243f}};
static const kern_vec stone12[] = {{-0.001f, 0.5127f},
                                   {0.438f, 0.5163f},
                                   {0.464f, 0.7582f},
                                   {0.013f, 0.7669f}};
static const kern_vec stone13[] = {{0.45f, 0.5164f},
                                   {0.815f, 0.5195f},
                                   {0.822f, 0.7538f},
                                   {0.58f, 0.756f},
                                   {0.476f, 0.758f}};
static const kern_vec stone14[] = {{0.827f, 0.5196f},
                                   {1.162f, 0.5223f},
                                   {1.171f, 0.7535f},
                                   {1.02f, 0.752f},
                                   {0.834f, 0.7537f}};
static const kern_vec stone15[] = {
    {1.174f, 0.5224f}, {1.36f, 0.524f},   {1.39f, 0.51f},  {1.44f, 0.519f},
    {1.611f, 0.5213f}, {1.594f, 0.7514f}, {1.52f, 0.757f}, {1.183f, 0.7536f}};
static const kern_vec stone16[] = {{1.623f, 0.5215f},
                                   {1.81f, 0.524f},
                                   {2.01f, 0.5248f},
                                   {2.022f, 0.7582f},
                                   {1.606f, 0.7511f}};
static const kern_vec stone17[] = {
    {2.022f, 0.5248f}, {2.39f, 0.5262f}, {2.398f, 0.7646f}, {2.034f, 0.7584f}};
static const kern_vec stone18[] = {{0.126f, 0.7647f},
                                   {0.47f, 0.7581f},
                                   {0.468f, 1.0092f},
                                   {0.19f, 1.009f},
                                   {0.126f, 1.0118f}};
static const kern_vec stone19[] = {{0.482f, 0.7579f},
                                   {0.58f, 0.756f},
                                   {0.804f, 0.754f},
                                   {0.79f, 1.0094f},
                                   {0.48f, 1.0092f}};
static const kern_vec stone20[] = {{0.816f, 0.7539f},
                                   {1.02f, 0.752f},
                                   {1.19f, 0.7537f},
                                   {1.173f, 1.0097f},
                                   {0.802f, 1.0094f}};
static const kern_vec stone21[] = {{1.202f, 0.7538f},
                                   {1.52f, 0.757f},
                                   {1.593f, 0.7515f},
                                   {1.575f, 1.0099f},
                                   {1.185f, 1.0097f}};
static const kern_vec stone22[] = {{1.605f, 0.7511f},
                                   {1.95f, 0.757f},
                                   {1.94f, 1.0117f},
                                   {1.67f, 1.01f},
                                   {1.587f, 1.0099f}};
static const kern_vec stone23[] = {{1.962f, 0.7572f}, {2.259f, 0.7622f},
                                   {2.249f, 1.0127f}, {2.2f, 1.012f},
                                   {1.99f, 1.012f},   {1.952f, 1.0118f}};
static const kern_vec stone24[] = {{-0.007f, 1.0176f},
                                   {0.19f, 1.009f},
                                   {0.453f, 1.0092f},
                                   {0.424f, 1.2771f},
                                   {0.019f, 1.2861f}};
static const kern_vec stone25[] = {{0.465f, 1.0092f},
                                   {0.817f, 1.0094f},
                                   {0.795f, 1.2725f},
                                   {0.65f, 1.272f},
                                   {0.436f, 1.2768f}};
static const kern_vec stone26[] = {
    {0.829f, 1.0094f}, {1.203f, 1.0097f}, {1.207f, 1.2739f}, {0.807f, 1.2725f}};
static const kern_vec stone27[] = {{1.215f, 1.0097f},
                                   {1.535f, 1.0099f},
                                   {1.563f, 1.2751f},
                                   {1.55f, 1.275f},
                                   {1.219f, 1.2739f}};
static const kern_vec stone28[] = {{1.547f, 1.0099f}, {1.67f, 1.01f},
                                   {1.99f, 1.012f},   {2.02f, 1.012f},
                                   {1.993f, 1.2777f}, {1.575f, 1.2752f}};
static const kern_vec stone29[] = {{2.032f, 1.012f}, {2.2f, 1.012f},
                                   {2.403f, 1.015f}, {2.385f, 1.275f},
                                   {2.21f, 1.279f},  {2.005f, 1.2778f}};

#define STONE(i)                                            \
    {                                                       \
        stone##i, (int)(sizeof stone##i / sizeof *stone##i) \
    }
static const struct wall_stone {
    const kern_vec *vertex;
    int vertices;
} wall[WALL_STONES] = {
    STONE(0),  STONE(1),  STONE(2),  STONE(3),  STONE(4),  STONE(5),
    STONE(6),  STONE(7),  STONE(8),  STONE(9),  STONE(10), STONE(11),
    STONE(12), STONE(13), STONE(14), STONE(15), STONE(16), STONE(17),
    STONE(18), STONE(19), STONE(20), STONE(21), STONE(22), STONE(23),
    STONE(24), STONE(25), STONE(26), STONE(27), STONE(28), STONE(29),
};
#undef STONE

#define CANDIDATE_VERTICES 5
#define CANDIDATE_SLOPE (0.003f / 0.9f)
static const kern_vec candidate[CANDIDATE_VERTICES] = {{0.67f, 1.27207f},
                                                       {1.07f, 1.2734f},
                                                       {1.13f, 1.4f},
                                                       {1.01f, 1.56f},
                                                       {0.64f, 1.49f}};

#endif
