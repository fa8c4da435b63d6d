/* image.h - reads the annotations of a photograph (JSON) as shapes:

       LabelMe  polygons, rectangles, circles, masks (PNG); shapes with one label
                and one group_id are parts of one stone
       COCO     annotations of one image: polygons, several are parts of one
                stone; masks (RLE, as numbers or as a word), whose outlines are
                traced, and whose holes are named
       VIA      regions of one image: polygons, rectangles, circles, ellipses

   Labels are those of the shapes, the names of categories, the first attribute
   of a region. All else is skipped and listed. A file of several images needs
   the number or the name of one.

   SPDX-License-Identifier: MIT */

#ifndef IMAGE_H
#define IMAGE_H

#include "lines.h"
#include "png.h"
#include "shapes.h"
#include "tokens.h"

enum {
    IMAGE_PIXELS = 50000000, /* of a mask, at most                         */
    IMAGE_ELLIPSE = 64       /* chords                                     */
};

struct image {
    struct shapes *s;
    struct tokens t;
    int *slot, slots;  /* groups by label and number: the first token + 1 */
    int *group, *name; /* of that slot; the label                      */
};

static int image_label(struct image *m, int i)
{
    return i >= 0 && m->t.one[i].type != TOKENS_OBJECT
                && m->t.one[i].type != TOKENS_LIST
             ? tokens_text(&m->t, i)
             : shapes_word(m->s, "stone", 5);
}

static void image_skip(struct image *m, const char *kind, int label, int i)
{
    shapes_skipped(m->s, kind, label, m->t.one[i].line);
}

/* Ends a path, closed, of a group or alone (-1). */
static void image_path(struct image *m, int first, const char *kind, int label,
                       int i, int group)
{
    struct shapes *s = m->s;
    const int word = shapes_word(s, kind, (int)strlen(kind));
    const int made = shapes_path(s, first, 1, word, label, m->t.one[i].line);
    if (made >= 0)
        s->path[made].group = group;
    else if (!s->lost)
        image_skip(m, "outline without area", label, i);
}

/* Adds the points of a list of pairs. Returns 0 where it is none. */
static int image_pairs(struct image *m, int list)
{
    const struct tokens *t = &m->t;
    if (!tokens_is(t, list, TOKENS_LIST))
        return 0;
    for (int i = list + 1; i < t->one[list].next; i = t->one[i].next) {
        double x, y;
        if (!tokens_is(t, i, TOKENS_LIST) || t->one[i].next != i + 3
            || !tokens_number(t, i + 1, &x) || !tokens_number(t, i + 2, &y))
            return 0;
        shapes_point(m->s, x, y, 0);
    }
    return 1;
}

/* Adds the points of a list x1, y1, x2, y2, ... Returns 0 where it is none. */
static int image_flat(struct image *m, int list)
{
    const struct tokens *t = &m->t;
    const int n = t->one[list].next - list - 1;
    if (!tokens_is(t, list, TOKENS_LIST) || n % 2)
        return 0;
    for (int i = list + 1; i < t->one[list].next; i += 2) {
        double x, y;
        if (!tokens_number(t, i, &x) || !tokens_number(t, i + 1, &y))
            return 0;
        shapes_point(m->s, x, y, 0);
    }
    return 1;
}

static void image_box(struct shapes *s, double x, double y, double w, double h)
{
    shapes_point(s, x, y, 0);
    shapes_point(s, x + w, y, 0);
    shapes_point(s, x + w, y + h, 0);
    shapes_point(s, x, y + h, 0);
}

/* ---- Masks ---------------------------------------------------------------- */

struct image_mask {
    char *pixel; /* 1: of the mask, 2: its upper edge was traced           */
    int width, height;
    int left, right, top, bottom; /* box of the mask, without its ends      */
    double x, y;                  /* its corner in the image                */
};

static void image_set(struct image_mask *k, int x, int y)
{
    k->pixel[(size_t)y * (size_t)k->width + (size_t)x] = 1;
    k->left = x < k->left ? x : k->left;
    k->right = x >= k->right ? x + 1 : k->right;
    k->top = y < k->top ? y : k->top;
    k->bottom = y >= k->bottom ? y + 1 : k->bottom;
}

static int image_is_set(const struct image_mask *k, int x, int y)
{
    return x >= 0 && y >= 0 && x < k->width && y < k->height
        && (k->pixel[(size_t)y * (size_t)k->width + (size_t)x] & 1);
}

/* Reads the next length of a compressed mask: five bits a character. Returns
   0 at its end. */
static int image_run(const char *word, int n, int *at, long long *out)
{
    long long value = 0;
    int shift = 0, c;
    do {
        if (*at >= n || shift > 30)
            return 0;
        c = (unsigned char)word[(*at)++];
        if (c == '\\' && *at < n) /* JSON writes it twice */
            (*at)++;
        c -= 48;
        value |= (long long)(c & 0x1f) << shift;
        shift += 5;
    } while (c & 0x20);
    if (c & 0x10)
        value -= 1LL << shift;
    *out = value;
    return 1;
}

/* Fills a mask from the lengths of its runs, column by column: 0s first. Returns
   0 where one is no length; *sum is the sum of all. */
static int image_runs(const struct image *m, int counts, struct image_mask *k,
                      long long *sum)
{
    const struct tokens *t = &m->t;
    const struct tokens_one *one = t->one + counts;
    const long long most = (long long)k->width * k->height;
    long long run = 0, before[2] = {0, 0};
    const int coded = one->type == TOKENS_STRING;
    int place = 0, i = counts + 1, n = 0;
    for (;; n++) {
        if (coded) {
            if (!image_run(t->data + one->at, one->length, &place, &run))
                return n > 0;
            if (n > 2)
                run += before[n % 2];
            before[n % 2] = run;
        } else {
            double value = 0;
            if (i >= one->next)
                return n > 0;
            if (!tokens_number(t, i++, &value) || !(value >= 0)
                || !(value <= (double)most))
                return 0;
            run = (long long)value;
        }
        if (run < 0 || run > most)
            return 0;
        for (long long p = *sum; n % 2 && p < *sum + run && p < most; p++)
            image_set(k, (int)(p / k->height), (int)(p % k->height));
        *sum += run;
    }
}

/* Traces one outline from the upper edge of a pixel: the mask is to the right of
   the way. */
static void image_trace(struct shapes *s, struct image_mask *k, int x, int y)
{
    static const int dx[4] = {1, 0, -1, 0}, dy[4] = {0, 1, 0, -1};
    static const int left[4][2] = {{0, -1}, {0, 0}, {-1, 0}, {-1, -1}};
    static const int right[4][2] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
    const int start_x = x, start_y = y;
    int way = 0;
    do {
        if (way == 0)
            k->pixel[(size_t)y * (size_t)k->width + (size_t)x] |= 2;
        x += dx[way];
        y += dy[way];
        if (!image_is_set(k, x + right[way][0], y + right[way][1]))
            way = (way + 1) % 4;
        else if (image_is_set(k, x + left[way][0], y + left[way][1]))
            way = (way + 3) % 4;
        else
            continue;
        shapes_point(s, k->x + x, k->y + y, 0);
    } while (!s->lost && !(x == start_x && y == start_y && way == 0));
}

/* Traces all outlines of a mask, parts of one group; those of holes run the other
   way. Lists specks below a hundredth of the largest. */
static void image_outlines(struct image *m, struct image_mask *k, int label,
                           int i, int group)
{
    struct shapes *s = m->s;
    const int first = s->paths;
    double largest = 0;
    for (int y = k->top; y < k->bottom; y++)
        for (int x = k->left; x < k->right && !s->lost; x++) {
            const int from = s->points;
            double area;
            if (!image_is_set(k, x, y) || image_is_set(k, x, y - 1)
                || (k->pixel[(size_t)y * (size_t)k->width + (size_t)x] & 2))
                continue;
            image_trace(s, k, x, y);
            area = lines_area(s->point + from, s->points - from);
            if (area < 0) {
                s->points = from;
                if (-area > largest / 100)
                    image_skip(m, "hole", label, i);
                continue;
            }
            image_path(m, from, "mask", label, i, group);
            largest = area > largest ? area : largest;
        }
    for (int p = first; p < s->paths; p++) {
        const struct shapes_path *path = s->path + p;
        if (lines_area(s->point + path->first, path->points) < largest / 100)
            shapes_leave(s, s->path + p, "speck of a mask");
    }
}

/* Lists the mask of an annotation whose runs add up to another sum than its
   pixels. */
static void image_skip_runs(struct image *m, int i, int label, long long sum,
                            int pixels)
{
    const int id = tokens_get(&m->t, i, "id");
    struct shapes_text t = {NULL, 0, 0, 0};
    shapes_put(&t, "mask");
    if (id >= 0) {
        shapes_put(&t, " ");
        shapes_put_shown(&t, shapes_at(m->s, tokens_text(&m->t, id)));
    }
    shapes_put(&t, " of ");
    shapes_put_number(&t, (double)sum, 15);
    shapes_put(&t, " pixels, not ");
    shapes_put_int(&t, pixels);
    if (!t.lost)
        image_skip(m, t.at, label, i);
    m->s->lost |= t.lost;
    free(t.at);
}

static void image_mask(struct image *m, int object, int label, int i)
{
    const struct tokens *t = &m->t;
    const int size = tokens_get(t, object, "size");
    const int counts = tokens_get(t, object, "counts");
    struct image_mask k = {NULL, 0, 0, 0, 0, 0, 0, 0, 0};
    double height = 0, width = 0;
    long long sum = 0;
    if (tokens_is(t, size, TOKENS_LIST) && t->one[size].next == size + 3
        && tokens_number(t, size + 1, &height)
        && tokens_number(t, size + 2, &width) && height >= 1 && width >= 1
        && height * width <= IMAGE_PIXELS && counts >= 0
        && (t->one[counts].type == TOKENS_LIST
            || t->one[counts].type == TOKENS_STRING)) {
        k.height = (int)height;
        k.left = k.width = (int)width;
        k.top = k.height;
        k.pixel = shapes_array(m->s, k.height * k.width, 1);
    }
    if (!k.pixel || !image_runs(m, counts, &k, &sum))
        image_skip(m, "mask that is none", label, i);
    else if (sum != (long long)k.height * k.width)
        image_skip_runs(m, i, label, sum, k.height * k.width);
    else if (k.right <= k.left)
        image_skip(m, "mask without a pixel", label, i);
    else
        image_outlines(m, &k, label, i, m->s->groups++);
    free(k.pixel);
}

/* ---- LabelMe -------------------------------------------------------------- */

/* Returns the group of shapes with this label and number, -1 without a
   number. */
static int image_group(struct image *m, int label, int number)
{
    const struct tokens *t = &m->t;
    const char *name = shapes_at(m->s, label);
    unsigned hash = 2166136261u;
    int i;
    if (number < 0 || tokens_same(t, number, "null") || m->s->lost)
        return -1;
    for (const char *c = name; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 16777619u;
    for (int k = 0; k < t->one[number].length; k++)
        hash = (hash ^ (unsigned char)t->data[t->one[number].at + k])
             * 16777619u;
    for (i = (int)(hash & (unsigned)(m->slots - 1)); m->slot[i];
         i = (i + 1) & (m->slots - 1)) {
        const struct tokens_one *a = t->one + m->slot[i] - 1;
        const struct tokens_one *b = t->one + number;
        if (a->length == b->length
            && memcmp(t->data + a->at, t->data + b->at, (size_t)a->length) == 0
            && strcmp(shapes_at(m->s, m->name[i]), name) == 0)
            return m->group[i];
    }
    m->slot[i] = number + 1;
    m->name[i] = label;
    m->group[i] = m->s->groups++;
    return m->group[i];
}

/* Makes a shape that is known by two points: a circle by its centre and a
   point of it, a rectangle by two corners, or by four. Returns 0 where there are
   others. */
static int image_special(struct image *m, int first, int circle)
{
    struct shapes *s = m->s;
    const struct shapes_point *p = s->point + first;
    struct shapes_point a, b;
    if (s->points - first != 2)
        return !circle && s->points - first == 4;
    a = p[0];
    b = p[1];
    s->points = first;
    if (circle)
        shapes_arc(s, a.x, a.y, shapes_distance(a, b), 0, 360);
    else
        image_box(s, a.x, a.y, b.x - a.x, b.y - a.y);
    return 1;
}

/* Makes a shape that is a PNG whose upper left pixel is the first point. */
static void image_png(struct image *m, int i, int label)
{
    struct tokens *t = &m->t;
    const int group = image_group(m, label, tokens_get(t, i, "group_id"));
    const int word = tokens_get(t, i, "mask"),
              points = tokens_get(t, i, "points");
    struct image_mask k = {NULL, 0, 0, 0, 0, 0, 0, 0, 0};
    const int corner = tokens_is(t, points, TOKENS_LIST) ? points + 1 : -1;
    if (corner < 0 || !tokens_is(t, corner, TOKENS_LIST)
        || t->one[corner].next != corner + 3
        || !tokens_number(t, corner + 1, &k.x)
        || !tokens_number(t, corner + 2, &k.y)) {
        image_skip(m, "shape without its points", label, i);
        return;
    }
    if (tokens_is(t, word, TOKENS_STRING))
        k.pixel = png_mask(m->s, t->data + t->one[word].at, t->one[word].length,
                           &k.width, &k.height);
    k.right = k.width;
    k.bottom = k.height;
    if (k.pixel)
        image_outlines(m, &k, label, i, group < 0 ? m->s->groups++ : group);
    else
        image_skip(m,
                   word < 0 ? "mask without its PNG"
                            : "mask that is no PNG without interlace",
                   label, i);
    free(k.pixel);
}

static void image_shape(struct image *m, int i)
{
    struct tokens *t = &m->t;
    const int first = m->s->points, type = tokens_get(t, i, "shape_type");
    const int points = tokens_get(t, i, "points");
    const int known = type >= 0 && !tokens_same(t, type, "null");
    const int circle = known && tokens_same(t, type, "circle");
    int label, kind;
    if (!tokens_is(t, i, TOKENS_OBJECT)) {
        image_skip(m, "shape that is none", shapes_word(m->s, "", 0), i);
        return;
    }
    label = image_label(m, tokens_get(t, i, "label"));
    kind = known ? tokens_text(t, type) : shapes_word(m->s, "polygon", 7);
    if (known && tokens_same(t, type, "mask")) {
        image_png(m, i, label);
        return;
    }
    if (!circle && known && !tokens_same(t, type, "polygon")
        && !tokens_same(t, type, "rectangle")) {
        shapes_listed_as(m->s, kind, label, t->one[i].line);
        return;
    }
    if (!image_pairs(m, points)
        || ((circle || tokens_same(t, type, "rectangle"))
            && !image_special(m, first, circle))) {
        m->s->points = first;
        image_skip(m, "shape without its points", label, i);
        return;
    }
    image_path(m, first, "polygon", label, i,
               image_group(m, label, tokens_get(t, i, "group_id")));
}

static int image_labelme(struct image *m, int shapes)
{
    struct tokens *t = &m->t;
    if (!tokens_number(t, tokens_get(t, 0, "imageHeight"), &m->s->height))
        m->s->height = -1;
    for (m->slots = 64; m->slots < t->count && m->slots < INT_MAX / 4;)
        m->slots *= 2;
    m->slot = shapes_array(m->s, m->slots, sizeof *m->slot);
    m->group = shapes_array(m->s, m->slots, sizeof *m->group);
    m->name = shapes_array(m->s, m->slots, sizeof *m->name);
    for (int i = shapes + 1; i < t->one[shapes].next; i = t->one[i].next)
        image_shape(m, i);
    return 0;
}

/* ---- COCO ----------------------------------------------------------------- */

/* Returns 1 if two tokens are the same number or text. */
static int image_alike(const struct image *m, int a, int b)
{
    const struct tokens_one *p = m->t.one + a, *q = m->t.one + b;
    return a >= 0 && b >= 0 && p->length == q->length
        && memcmp(m->t.data + p->at, m->t.data + q->at, (size_t)p->length) == 0;
}

/* Says that one of several images must be named. */
static int image_several(struct image *m, int count, int one)
{
    struct shapes_text *t = shapes_fault(m->s, 0);
    if (m->s->asked->image) {
        shapes_put(t, "no image is '");
        shapes_put_shown(t, m->s->asked->image);
        shapes_put(t, "'");
    } else {
        if (count > 1)
            shapes_put_int(t, count);
        shapes_put(t, count > 1 ? " images: one must be named"
                                : "several images: one must be named");
    }
    if (one >= 0) {
        shapes_put(t, ", for example --image ");
        shapes_put_shown(t, shapes_at(m->s, tokens_text(&m->t, one)));
    }
    return -1;
}

/* Finds the image that is asked for among the rows of a list, by its number or
   name; without a question the only one. -1: there is none. */
static int image_row(const struct image *m, int list, int *count)
{
    const struct tokens *t = &m->t;
    int found = -1;
    *count = 0;
    for (int i = list + 1;
         tokens_is(t, list, TOKENS_LIST) && i < t->one[list].next;
         i = t->one[i].next) {
        const char *asked = m->s->asked->image;
        (*count)++;
        if (asked ? tokens_same(t, tokens_get(t, i, "id"), asked)
                        || tokens_same(t, tokens_get(t, i, "file_name"), asked)
                  : found < 0)
            found = i;
    }
    return m->s->asked->image || *count == 1 ? found : -1;
}

/* Returns the number of the image whose annotations count, -1 where all of
   them do, and -2 with a message. */
static int image_chosen(struct image *m, int annotations)
{
    const struct tokens *t = &m->t;
    const int images = tokens_get(t, 0, "images");
    int count, row = image_row(m, images, &count), one = -1, several = 0;
    if (row >= 0) {
        if (!tokens_number(t, tokens_get(t, row, "height"), &m->s->height))
            m->s->height = -1;
        return count > 1 ? tokens_get(t, row, "id") : -1;
    }
    for (int i = annotations + 1; i < t->one[annotations].next;
         i = t->one[i].next) {
        const int id = tokens_get(t, i, "image_id");
        if (id < 0)
            continue;
        if (m->s->asked->image && tokens_same(t, id, m->s->asked->image))
            return id;
        several += one < 0 || !image_alike(m, id, one);
        one = one < 0 ? id : one;
    }
    if (m->s->asked->image || several > 1) {
        image_several(m, count, one);
        return -2;
    }
    return one;
}

/* Returns the label of an annotation: the name of its category. */
static int image_category(struct image *m, int i)
{
    const struct tokens *t = &m->t;
    const int list = tokens_get(t, 0, "categories");
    const int id = tokens_get(t, i, "category_id");
    for (int k = list + 1;
         tokens_is(t, list, TOKENS_LIST) && k < t->one[list].next;
         k = t->one[k].next)
        if (image_alike(m, id, tokens_get(t, k, "id")))
            return image_label(m, tokens_get(t, k, "name"));
    return shapes_word(m->s, "stone", 5);
}

static void image_annotation(struct image *m, int i)
{
    const struct tokens *t = &m->t;
    const int label = image_category(m, i);
    const int parts = tokens_get(t, i, "segmentation");
    const int crowd = tokens_get(t, i, "iscrowd");
    const int flat = parts >= 0 && tokens_is(t, parts + 1, TOKENS_NUMBER);
    int group = -1;
    if (crowd >= 0
        && (tokens_same(t, crowd, "1") || tokens_same(t, crowd, "true"))) {
        image_skip(m, "crowd", label, i);
        return;
    }
    if (tokens_is(t, parts, TOKENS_OBJECT)) {
        image_mask(m, parts, label, i);
        return;
    }
    if (!tokens_is(t, parts, TOKENS_LIST) || t->one[parts].next == parts + 1) {
        image_skip(m, "annotation without an outline", label, i);
        return;
    }
    if (!flat && t->one[parts + 1].next < t->one[parts].next)
        group = m->s->groups++;
    for (int k = flat ? parts : parts + 1; k < t->one[parts].next;
         k = t->one[k].next) {
        const int first = m->s->points;
        if (image_flat(m, k))
            image_path(m, first, "polygon", label, i, group);
        else {
            m->s->points = first;
            image_skip(m, "outline that is no list of coordinates", label, i);
        }
    }
}

static int image_coco(struct image *m, int annotations)
{
    const struct tokens *t = &m->t;
    const int chosen = image_chosen(m, annotations);
    if (chosen == -2)
        return -1;
    for (int i = annotations + 1; i < t->one[annotations].next;
         i = t->one[i].next) {
        const int id = tokens_get(t, i, "image_id");
        if (!tokens_is(t, i, TOKENS_OBJECT))
            image_skip(m, "annotation that is none", shapes_word(m->s, "", 0),
                       i);
        else if (chosen < 0 || id < 0 || image_alike(m, id, chosen))
            image_annotation(m, i);
    }
    return 0;
}

/* ---- VIA ------------------------------------------------------------------ */

/* Adds the points of the lists all_points_x and all_points_y. */
static int image_lists(struct image *m, int attributes)
{
    const struct tokens *t = &m->t;
    const int x = tokens_get(t, attributes, "all_points_x");
    const int y = tokens_get(t, attributes, "all_points_y");
    int n;
    if (!tokens_is(t, x, TOKENS_LIST) || !tokens_is(t, y, TOKENS_LIST))
        return 0;
    n = t->one[x].next - x - 1;
    if (t->one[y].next - y - 1 != n)
        return 0;
    for (int k = 1; k <= n; k++) {
        double px, py;
        if (!tokens_number(t, x + k, &px) || !tokens_number(t, y + k, &py))
            return 0;
        shapes_point(m->s, px, py, 0);
    }
    return 1;
}

/* Reads the numbers of some keys. Returns 0 where one is missing. */
static int image_numbers(const struct image *m, int object, int n,
                         const char *const *key, double *out)
{
    for (int k = 0; k < n; k++)
        if (!tokens_number(&m->t, tokens_get(&m->t, object, key[k]), out + k))
            return 0;
    return 1;
}

/* Adds the points of a rectangle, a circle or an ellipse. Returns 0 where
   numbers are missing. */
static int image_round(struct image *m, int attributes, int name)
{
    static const char *const box[] = {"x", "y", "width", "height"};
    static const char *const circle[] = {"cx", "cy", "r"};
    static const char *const ellipse[] = {"cx", "cy", "rx", "ry"};
    double v[4];
    if (tokens_same(&m->t, name, "rect")) {
        if (!image_numbers(m, attributes, 4, box, v))
            return 0;
        image_box(m->s, v[0], v[1], v[2], v[3]);
        return 1;
    }
    if (image_numbers(m, attributes, 3, circle, v)) {
        shapes_arc(m->s, v[0], v[1], v[2], 0, 360);
        return 1;
    }
    if (!image_numbers(m, attributes, 4, ellipse, v))
        return 0;
    for (int k = 0; k < IMAGE_ELLIPSE; k++) {
        double c, q;
        shapes_turn(360.0 * k / IMAGE_ELLIPSE, &c, &q);
        shapes_point(m->s, v[0] + c * v[2], v[1] + q * v[3], 0);
    }
    return 1;
}

static void image_region(struct image *m, int i)
{
    struct tokens *t = &m->t;
    const int shape = tokens_get(t, i, "shape_attributes");
    const int named = tokens_get(t, i, "region_attributes");
    const int name = tokens_get(t, shape, "name");
    const int first = m->s->points;
    const int lists = tokens_same(t, name, "polygon");
    int label, made = 0;
    if (named >= 0 && t->one[named].next > named + 2)
        label = image_label(m, named + 2);
    else
        label = shapes_word(m->s, "stone", 5);
    if (lists)
        made = image_lists(m, shape);
    else if (tokens_same(t, name, "rect") || tokens_same(t, name, "circle")
             || tokens_same(t, name, "ellipse"))
        made = image_round(m, shape, name);
    else if (name >= 0) {
        shapes_listed_as(m->s, tokens_text(t, name), label, t->one[i].line);
        return;
    }
    if (made)
        image_path(m, first, "polygon", label, i, -1);
    else {
        m->s->points = first;
        image_skip(m, "region without its points", label, i);
    }
}

/* Reads a page whose images are the values of an object; `regions` is a
   list, or an object whose values count. */
static int image_via(struct image *m, int pages)
{
    struct tokens *t = &m->t;
    int count = 0, found = -1, one = -1;
    for (int i = pages + 1; i < t->one[pages].next; i = t->one[i + 1].next) {
        const int name = tokens_get(t, i + 1, "filename");
        const char *asked = m->s->asked->image;
        if (tokens_get(t, i + 1, "regions") < 0)
            continue;
        count++;
        one = one < 0 ? (name >= 0 ? name : i) : one;
        if (asked ? tokens_same(t, i, asked) || tokens_same(t, name, asked)
                  : found < 0)
            found = tokens_get(t, i + 1, "regions");
    }
    if (found < 0 || (!m->s->asked->image && count > 1))
        return image_several(m, count, one);
    for (int i = found + 1; i < t->one[found].next; i = t->one[i].next) {
        if (t->one[found].type == TOKENS_OBJECT)
            i++;
        image_region(m, i);
    }
    return 0;
}

/* Returns 1 if a value of an object has regions, as VIA's have. */
static int image_is_via(const struct tokens *t, int object)
{
    if (!tokens_is(t, object, TOKENS_OBJECT))
        return 0;
    for (int i = object + 1; i < t->one[object].next; i = t->one[i + 1].next)
        if (tokens_get(t, i + 1, "regions") >= 0)
            return 1;
    return 0;
}

/* ---- The file ------------------------------------------------------------- */

static int image_find(struct image *m)
{
    const struct tokens *t = &m->t;
    const int shapes = tokens_get(t, 0, "shapes");
    const int annotations = tokens_get(t, 0, "annotations");
    const int pages = tokens_get(t, 0, "_via_img_metadata");
    if (tokens_is(t, shapes, TOKENS_LIST))
        return image_labelme(m, shapes);
    if (tokens_is(t, annotations, TOKENS_LIST))
        return image_coco(m, annotations);
    if (image_is_via(t, pages))
        return image_via(m, pages);
    if (image_is_via(t, 0))
        return image_via(m, 0);
    return shapes_fail(m->s, 0,
                       "neither LabelMe (shapes), COCO (annotations) nor VIA "
                       "(regions)");
}

/* Reads the shapes of a photograph's annotations. Returns 0, or -1 with a
   message. */
static int image_read(struct shapes *s, const char *data, int length)
{
    struct image m;
    int bad;
    memset(&m, 0, sizeof m);
    m.s = s;
    s->photograph = s->down = 1;
    s->height = -1;
    s->unit = s->asked->pixel > 0 ? s->asked->pixel : 1;
    s->units = s->asked->pixel > 0 ? "m" : "px";
    bad = tokens_read(&m.t, s, data, length) || image_find(&m) ? -1 : 0;
    free(m.t.one);
    free(m.slot);
    free(m.group);
    free(m.name);
    return bad;
}

#endif /* IMAGE_H */
