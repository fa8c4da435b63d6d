/* words.h - characters of UTF-8, for what reads text with a C library or
   without one.

   SPDX-License-Identifier: MIT */

#ifndef WORDS_H
#define WORDS_H

/* Returns the length of the UTF-8 character at s, 0 where there is none. Longer
   forms than needed, surrogates and what lies beyond Unicode are none. */
static inline int text_utf8(const char *s)
{
    const unsigned char *u = (const unsigned char *)s;
    int n = u[0] < 0x80 ? 1
          : u[0] < 0xc2 ? 0
          : u[0] < 0xe0 ? 2
          : u[0] < 0xf0 ? 3
          : u[0] < 0xf5 ? 4
                        : 0;
    for (int i = 1; i < n; i++)
        if ((u[i] & 0xc0) != 0x80)
            return 0;
    if ((u[0] == 0xe0 && u[1] < 0xa0) || (u[0] == 0xed && u[1] > 0x9f)
        || (u[0] == 0xf0 && u[1] < 0x90) || (u[0] == 0xf4 && u[1] > 0x8f))
        return 0;
    return n;
}

#endif /* WORDS_H */
