/* tokens.h - JSON as a list of tokens, for what reads annotations.

   A token of a container is followed by those inside it; `next` is the first one
   behind it. In an object a key is followed by its value. Containers lie at most
   TOKENS_DEEP in each other, and nothing calls itself.

   SPDX-License-Identifier: MIT */

#ifndef TOKENS_H
#define TOKENS_H

#include "shapes.h"

enum { TOKENS_DEEP = 100 };

enum tokens_type {
    TOKENS_OBJECT,
    TOKENS_LIST,
    TOKENS_STRING,
    TOKENS_NUMBER,
    TOKENS_WORD /* true, false, null */
};

struct tokens_one {
    enum tokens_type type;
    int at, length; /* in the file; of a string what is between its marks */
    int line, next;
};

struct tokens {
    struct shapes *s;
    const char *data;
    int length, at, line;
    struct tokens_one *one;
    int count, room;
    int open[TOKENS_DEEP], depth; /* containers around what is read */
};

static void tokens_blanks(struct tokens *t)
{
    for (; t->at < t->length; t->at++) {
        const char c = t->data[t->at];
        if (c == '\n')
            t->line++;
        else if (c != ' ' && c != '\t' && c != '\r')
            return;
    }
}

/* Returns the character that is next, 0 at the end. */
static char tokens_peek(struct tokens *t)
{
    tokens_blanks(t);
    return t->at < t->length ? t->data[t->at] : '\0';
}

static int tokens_fail(struct tokens *t, const char *what)
{
    int n = 0;
    while (t->at + n < t->length && n < 20) {
        const char c = t->data[t->at + n];
        if (n > 0
            && (c == ' ' || c == '\n' || c == ',' || c == ']' || c == '}'))
            break;
        n++;
    }
    if (t->at >= t->length) {
        struct shapes_text *m = shapes_fault(t->s, t->line);
        shapes_put(m, what);
        shapes_put(m, " is expected, but the file ends");
        return -1;
    }
    return shapes_expected(t->s, t->line, what, t->data + t->at, n);
}

static int tokens_add(struct tokens *t, enum tokens_type type, int at,
                      int length)
{
    struct tokens_one *one = shapes_grown(t->s, t->one, t->count, &t->room,
                                          sizeof *one);
    if (!one)
        return -1;
    t->one = one;
    one += t->count++;
    one->type = type;
    one->at = at;
    one->length = length;
    one->line = t->line;
    one->next = t->count;
    return 0;
}

static int tokens_string(struct tokens *t)
{
    const int from = ++t->at;
    while (t->at < t->length && t->data[t->at] != '"') {
        t->line += t->data[t->at] == '\n';
        t->at += t->data[t->at] == '\\' ? 2 : 1;
    }
    if (t->at >= t->length) {
        t->at = t->length;
        return tokens_fail(t, "the end of a string");
    }
    return tokens_add(t, TOKENS_STRING, from, t->at++ - from);
}

/* Reads a number, or true, false, null. */
static int tokens_word(struct tokens *t)
{
    static const char *const word[] = {"true", "false", "null"};
    int n = 0;
    double value;
    while (t->at + n < t->length) {
        const char c = t->data[t->at + n];
        if (!((c >= '0' && c <= '9') || ((c | 0x20) >= 'a' && (c | 0x20) <= 'z')
              || c == '+' || c == '-' || c == '.'))
            break;
        n++;
    }
    for (int k = 0; k < 3; k++)
        if (n == (int)strlen(word[k])
            && memcmp(t->data + t->at, word[k], (size_t)n) == 0) {
            t->at += n;
            return tokens_add(t, TOKENS_WORD, t->at - n, n);
        }
    if (!shapes_read_number(t->data + t->at, n, &value))
        return tokens_fail(t, "a value");
    t->at += n;
    return tokens_add(t, TOKENS_NUMBER, t->at - n, n);
}

/* Reads a value up to its end, or the beginning of a container. */
static int tokens_value(struct tokens *t)
{
    const char c = tokens_peek(t);
    if (c == '"')
        return tokens_string(t);
    if (c != '{' && c != '[')
        return tokens_word(t);
    if (t->depth == TOKENS_DEEP)
        return tokens_fail(t, "at most 100 lists in each other: a value");
    t->open[t->depth++] = t->count;
    t->at++;
    return tokens_add(t, c == '{' ? TOKENS_OBJECT : TOKENS_LIST, t->at - 1, 1);
}

static int tokens_key(struct tokens *t)
{
    if (tokens_peek(t) != '"')
        return tokens_fail(t, "a name in quotation marks");
    if (tokens_string(t))
        return -1;
    if (tokens_peek(t) != ':')
        return tokens_fail(t, "':'");
    t->at++;
    return 0;
}

/* Ends containers as far as they end here; then a comma, or the end of all. */
static int tokens_after(struct tokens *t)
{
    while (t->depth > 0) {
        struct tokens_one *in = t->one + t->open[t->depth - 1];
        const char end = in->type == TOKENS_OBJECT ? '}' : ']';
        const char c = tokens_peek(t);
        if (c == end) {
            t->at++;
            in->next = t->count;
            t->depth--;
        } else if (c == ',' && t->count > t->open[t->depth - 1] + 1) {
            t->at++;
            return in->type == TOKENS_OBJECT ? tokens_key(t) : 0;
        } else if (t->count == t->open[t->depth - 1] + 1)
            return in->type == TOKENS_OBJECT ? tokens_key(t) : 0;
        else
            return tokens_fail(t, end == '}' ? "',' or '}'" : "',' or ']'");
    }
    return 0;
}

/* Reads the whole file. Returns 0, or -1 with a message. */
static int tokens_read(struct tokens *t, struct shapes *s, const char *data,
                       int length)
{
    memset(t, 0, sizeof *t);
    t->s = s;
    t->data = data;
    t->length = length;
    t->line = 1;
    if (length >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0)
        t->at = 3;
    do
        if (tokens_value(t) || tokens_after(t) || s->lost)
            return -1;
    while (t->depth > 0);
    tokens_blanks(t);
    return t->at < length ? tokens_fail(t, "the end of the file") : 0;
}

/* ---- What they say -------------------------------------------------------- */

/* Returns the value of a key of an object, -1 where there is none. */
static int tokens_get(const struct tokens *t, int object, const char *key)
{
    const int n = (int)strlen(key);
    if (object < 0 || t->one[object].type != TOKENS_OBJECT)
        return -1;
    for (int i = object + 1; i < t->one[object].next; i = t->one[i + 1].next)
        if (t->one[i].length == n
            && memcmp(t->data + t->one[i].at, key, (size_t)n) == 0)
            return i + 1;
    return -1;
}

static int tokens_is(const struct tokens *t, int i, enum tokens_type type)
{
    return i >= 0 && t->one[i].type == type;
}

/* Reads the number that a token is. Returns 0 where it is none. */
static int tokens_number(const struct tokens *t, int i, double *out)
{
    return tokens_is(t, i, TOKENS_NUMBER)
        && shapes_read_number(t->data + t->one[i].at, t->one[i].length, out);
}

/* Returns 1 if a token is these characters. */
static int tokens_same(const struct tokens *t, int i, const char *word)
{
    return i >= 0 && t->one[i].length == (int)strlen(word)
        && memcmp(t->data + t->one[i].at, word, strlen(word)) == 0;
}

static int tokens_hex(const char *s, int n)
{
    int value = 0;
    for (int i = 0; i < n; i++) {
        const int c = s[i] | 0x20;
        if (c >= '0' && c <= '9')
            value = 16 * value + (c - '0');
        else if (c >= 'a' && c <= 'f')
            value = 16 * value + (c - 'a') + 10;
        else
            return -1;
    }
    return value;
}

static void tokens_put_utf8(struct shapes_text *out, int c)
{
    char u[4];
    int n = 0;
    if (c < 0x80)
        u[n++] = (char)c;
    else if (c < 0x800)
        u[n++] = (char)(0xc0 | c >> 6);
    else if (c < 0x10000)
        u[n++] = (char)(0xe0 | c >> 12);
    else
        u[n++] = (char)(0xf0 | c >> 18);
    if (c >= 0x10000)
        u[n++] = (char)(0x80 | (c >> 12 & 0x3f));
    if (c >= 0x800)
        u[n++] = (char)(0x80 | (c >> 6 & 0x3f));
    if (c >= 0x80)
        u[n++] = (char)(0x80 | (c & 0x3f));
    shapes_put_bytes(out, u, n);
}

/* Reads an escape behind its backslash, of n characters that are left: puts the
   character that it means. Returns how many characters it takes. */
static int tokens_escape(struct shapes_text *out, const char *s, int n)
{
    const int pair = n > 10 && s[5] == '\\' && s[6] == 'u';
    int c = n > 4 && *s == 'u' ? tokens_hex(s + 1, 4) : -1, low;
    if (c < 1) {
        shapes_put_bytes(out, *s == 'n' || *s == 't' ? " " : s, 1);
        return 1;
    }
    low = pair && c >= 0xd800 && c < 0xdc00 ? tokens_hex(s + 7, 4) : -1;
    if (low >= 0xdc00 && low < 0xe000) {
        tokens_put_utf8(out, 0x10000 + ((c - 0xd800) << 10) + (low - 0xdc00));
        return 11;
    }
    tokens_put_utf8(out, c >= 0xd800 && c < 0xe000 ? 0xfffd : c);
    return 5;
}

/* Returns the text of a token as a word, of a string without its escapes. */
static int tokens_text(struct tokens *t, int i)
{
    const char *from = t->data + t->one[i].at;
    const int n = t->one[i].length;
    struct shapes_text out = {NULL, 0, 0, 0};
    int word;
    shapes_put(&out, "");
    for (int k = 0; k < n;) {
        if (from[k] == '\\' && k + 1 < n)
            k += 1 + tokens_escape(&out, from + k + 1, n - k - 1);
        else
            shapes_put_bytes(&out, from + k++, 1);
    }
    t->s->lost |= out.lost;
    word = out.lost ? 0 : shapes_word(t->s, out.at, out.length);
    free(out.at);
    return word;
}

#endif /* TOKENS_H */
