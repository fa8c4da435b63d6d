/* json.h - writes JSON to stdout, for the example programs.

   SPDX-License-Identifier: MIT */

#ifndef JSON_H
#define JSON_H

#include "text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The inside of a JSON string: the n bytes at s. What is not UTF-8 becomes
   U+FFFD. */
static inline void json_text_of(const char *s, int bytes)
{
    const char *end = s + bytes;
    while (s < end) {
        int n = text_utf8(s);
        unsigned char c = (unsigned char)*s;
        if (n == 0)
            printf("\\ufffd");
        else if (c == '"' || c == '\\')
            printf("\\%c", c);
        else if (c < 0x20 || c == 0x7f)
            printf("\\u%04x", (unsigned)c);
        else
            printf("%.*s", n, s);
        s += n > 0 ? n : 1;
    }
}

static inline void json_text(const char *s) { json_text_of(s, (int)strlen(s)); }

static inline void json_string(const char *key, const char *value)
{
    printf("\"%s\": \"", key);
    json_text(value);
    printf("\"");
}

enum { JSON_DIGITS = 40 };

/* A number of up to 17 digits, the fewest of three that read back to it; null
   where it is none. */
static inline void json_digits(double value, char out[JSON_DIGITS])
{
    strcpy(out, "null");
    for (int digits = 15; isfinite(value) && digits <= 17; digits++) {
        snprintf(out, JSON_DIGITS, "%.*g", digits, value);
        double back = strtod(out, NULL);
        if (!(back < value) && !(back > value))
            break;
    }
}

static inline void json_value(double value)
{
    char out[JSON_DIGITS];
    json_digits(value, out);
    printf("%s", out);
}

static inline void json_number(const char *key, double value)
{
    printf(", \"%s\": ", key);
    json_value(value);
}

#endif /* JSON_H */
