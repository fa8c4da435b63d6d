/* png.h - reads the mask that a PNG in base64 holds, as LabelMe writes it into
   JSON: which pixels are not black.

   All types of pixels are read, but for interlaced images. The sum behind the
   data is checked.

   SPDX-License-Identifier: MIT */

#ifndef PNG_H
#define PNG_H

#include "shapes.h"

enum {
    PNG_PIXELS = 50000000, /* at most                                        */
    PNG_RATIO = 1032,      /* bytes that a byte inflates to, at most         */
    PNG_CODES = 320,       /* lengths of both alphabets                      */
    PNG_BITS = 15
};

/* Bytes that are inflated. */
struct png_stream {
    const unsigned char *in;
    unsigned char *out;
    int length, at; /* of the input                                      */
    int room, made; /* of the output                                     */
    unsigned bits;  /* that were taken from the input and not used       */
    int held;       /* how many                                          */
    int bad;        /* nonzero: it ends too early, or is none            */
};

/* An alphabet of Huffman codes: how many of each length, and their symbols in
   the order of the codes. */
struct png_codes {
    int count[PNG_BITS + 1];
    int symbol[PNG_CODES];
};

static int png_bits(struct png_stream *z, int n)
{
    int value;
    while (z->held < n) {
        if (z->at >= z->length) {
            z->bad = 1;
            return 0;
        }
        z->bits |= (unsigned)z->in[z->at++] << z->held;
        z->held += 8;
    }
    value = (int)(z->bits & ((1u << n) - 1));
    z->bits >>= n;
    z->held -= n;
    return value;
}

static void png_put(struct png_stream *z, int byte)
{
    if (z->made < z->room)
        z->out[z->made++] = (unsigned char)byte;
    else
        z->bad = 1;
}

/* Makes the alphabet of n symbols whose codes have these lengths. Returns 0 where
   there are more codes than fit. */
static int png_alphabet(struct png_codes *c, const unsigned char *length, int n)
{
    int place[PNG_BITS + 1], left = 1;
    memset(c, 0, sizeof *c);
    for (int i = 0; i < n; i++)
        c->count[length[i]]++;
    c->count[0] = 0;
    place[0] = 0;
    for (int k = 1; k <= PNG_BITS; k++) {
        left = 2 * left - c->count[k];
        place[k] = place[k - 1] + c->count[k - 1];
        if (left < 0)
            return 0;
    }
    for (int i = 0; i < n; i++)
        if (length[i] > 0)
            c->symbol[place[length[i]]++] = i;
    return 1;
}

static int png_symbol(struct png_stream *z, const struct png_codes *c)
{
    int code = 0, first = 0, index = 0;
    for (int k = 1; k <= PNG_BITS && !z->bad; k++) {
        code |= png_bits(z, 1);
        if (code - first < c->count[k])
            return c->symbol[index + code - first];
        index += c->count[k];
        first = 2 * (first + c->count[k]);
        code *= 2;
    }
    z->bad = 1;
    return 0;
}

/* Copies what was made before, where a symbol says so. */
static void png_copy(struct png_stream *z, int symbol,
                     const struct png_codes *far_codes)
{
    static const int least[29] = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                  15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                  67, 83, 99, 115, 131, 163, 195, 227, 258};
    int length, back, extra, way;
    symbol -= 257;
    if (symbol > 28) {
        z->bad = 1;
        return;
    }
    extra = symbol < 8 || symbol == 28 ? 0 : symbol / 4 - 1;
    length = least[symbol] + png_bits(z, extra);
    way = png_symbol(z, far_codes);
    if (way > 29) {
        z->bad = 1;
        return;
    }
    extra = way < 4 ? 0 : way / 2 - 1;
    back = way < 4 ? way + 1 : ((2 + way % 2) << extra) + 1;
    back += png_bits(z, extra);
    z->bad |= back > z->made;
    for (int i = 0; i < length && !z->bad; i++)
        png_put(z, z->out[z->made - back]);
}

/* Reads the two alphabets of a block. */
static void png_alphabets(struct png_stream *z, struct png_codes *codes,
                          struct png_codes *far_codes)
{
    static const int order[19] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                  11, 4,  12, 3, 13, 2, 14, 1, 15};
    unsigned char length[PNG_CODES] = {0};
    const int codes_in = 257 + png_bits(z, 5), far_in = 1 + png_bits(z, 5);
    const int lengths = 4 + png_bits(z, 4);
    int n = 0;
    for (int i = 0; i < lengths; i++)
        length[order[i]] = (unsigned char)png_bits(z, 3);
    z->bad |= !png_alphabet(codes, length, 19);
    memset(length, 0, sizeof length);
    while (n < codes_in + far_in && !z->bad) {
        int symbol = png_symbol(z, codes), times = 1, value = symbol;
        if (symbol == 16) {
            z->bad |= n == 0;
            value = n > 0 ? length[n - 1] : 0;
            times = 3 + png_bits(z, 2);
        } else if (symbol > 16) {
            value = 0;
            times = symbol == 17 ? 3 + png_bits(z, 3) : 11 + png_bits(z, 7);
        }
        z->bad |= n + times > codes_in + far_in;
        while (times-- > 0 && !z->bad)
            length[n++] = (unsigned char)value;
    }
    z->bad |= !png_alphabet(codes, length, codes_in);
    z->bad |= !png_alphabet(far_codes, length + codes_in, far_in);
}

/* Makes the alphabets that blocks have which bring none. */
static void png_fixed(struct png_codes *codes, struct png_codes *far_codes)
{
    unsigned char length[PNG_CODES];
    for (int i = 0; i < 288; i++)
        length[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
    png_alphabet(codes, length, 288);
    memset(length, 5, 30);
    png_alphabet(far_codes, length, 30);
}

/* Copies a block that is not compressed. */
static void png_stored(struct png_stream *z)
{
    int length;
    z->bits = 0;
    z->held = 0;
    length = png_bits(z, 8);
    length |= png_bits(z, 8) << 8;
    z->bad |= (png_bits(z, 8) ^ (length & 0xff)) != 0xff;
    z->bad |= (png_bits(z, 8) ^ (length >> 8)) != 0xff;
    while (length-- > 0 && !z->bad)
        png_put(z, png_bits(z, 8));
}

/* Inflates all blocks, and compares their sum with that behind them. */
static void png_inflate(struct png_stream *z)
{
    struct png_codes codes, far_codes;
    unsigned low = 1, high = 0, sum = 0;
    int last = 0;
    png_bits(z, 16);
    while (!last && !z->bad) {
        int kind, symbol = 0;
        last = png_bits(z, 1);
        kind = png_bits(z, 2);
        z->bad |= kind == 3;
        if (kind == 0)
            png_stored(z);
        else if (kind == 1)
            png_fixed(&codes, &far_codes);
        else if (kind == 2)
            png_alphabets(z, &codes, &far_codes);
        while (kind > 0 && symbol != 256 && !z->bad) {
            symbol = png_symbol(z, &codes);
            if (symbol < 256)
                png_put(z, symbol);
            else if (symbol > 256)
                png_copy(z, symbol, &far_codes);
        }
    }
    z->held -= z->held % 8;
    z->bits = 0;
    z->at -= z->held / 8;
    z->held = 0;
    for (int i = 0; i < 4; i++)
        sum = sum << 8 | (unsigned)png_bits(z, 8);
    for (int i = 0; i < z->made; i++) {
        low = (low + z->out[i]) % 65521;
        high = (high + low) % 65521;
    }
    z->bad |= sum != (high << 16 | low);
}

/* ---- The image ------------------------------------------------------------ */

struct png_image {
    int width, height, bits, type; /* bits of a sample; type as in PNG       */
    int samples;                   /* of a pixel                             */
    int row;                       /* bytes of a row                         */
};

static int png_base64(int c)
{
    return c >= 'A' && c <= 'Z' ? c - 'A'
         : c >= 'a' && c <= 'z' ? c - 'a' + 26
         : c >= '0' && c <= '9' ? c - '0' + 52
         : c == '+' || c == '-' ? 62
         : c == '/' || c == '_' ? 63
                                : -1;
}

/* Writes the bytes that the n characters of a JSON string mean. Returns how
   many. */
static int png_bytes(const char *word, int n, unsigned char *out)
{
    unsigned bits = 0;
    int held = 0, made = 0;
    for (int i = 0; i < n; i++) {
        int value;
        if (word[i] == '\\') { /* a line's end, or a slash */
            i += i + 1 < n && word[i + 1] != '/';
            continue;
        }
        value = png_base64(word[i]);
        if (value < 0)
            continue;
        bits = (bits << 6 | (unsigned)value) & 0xffff;
        held += 6;
        if (held >= 8) {
            held -= 8;
            out[made++] = (unsigned char)(bits >> held);
        }
    }
    return made;
}

static unsigned png_word(const unsigned char *p)
{
    return (unsigned)p[0] << 24 | (unsigned)p[1] << 16 | (unsigned)p[2] << 8
         | p[3];
}

/* Reads the head. Returns 0 where it is none of an image that is read here. */
static int png_head(const unsigned char *file, int n, struct png_image *image)
{
    static const int samples[7] = {1, 0, 3, 1, 2, 0, 4};
    static const unsigned char mark[8] = {0x89, 'P', 'N', 'G', 13, 10, 26, 10};
    unsigned wide, tall;
    if (n < 57 || memcmp(file, mark, 8) != 0
        || memcmp(file + 12, "IHDR", 4) != 0)
        return 0;
    wide = png_word(file + 16);
    tall = png_word(file + 20);
    image->bits = file[24];
    image->type = file[25];
    if (wide < 1 || tall < 1 || wide > PNG_PIXELS / tall || image->type > 6
        || samples[image->type] == 0 || file[28] != 0 || image->bits < 1
        || image->bits > 16 || (image->bits & (image->bits - 1)))
        return 0;
    image->width = (int)wide;
    image->height = (int)tall;
    image->samples = samples[image->type];
    image->row =
        (int)(((size_t)wide * (size_t)image->samples * (size_t)image->bits + 7)
              / 8);
    return 1;
}

/* Moves the data of all chunks together, to the beginning of the file. Returns
   their length; -1: a chunk is longer than the file. */
static int png_chunks(unsigned char *file, int n)
{
    int at = 33, data = 0;
    while (n - at >= 12) {
        const unsigned length = png_word(file + at);
        if (length > (unsigned)(n - at - 12))
            return -1;
        if (memcmp(file + at + 4, "IDAT", 4) == 0) {
            for (unsigned i = 0; i < length; i++)
                file[data + (int)i] = file[at + 8 + (int)i];
            data += (int)length;
        }
        at += (int)length + 12;
    }
    return data;
}

static int png_nearest(int left, int up, int corner)
{
    const int p = left + up - corner;
    const int a = p > left ? p - left : left - p;
    const int b = p > up ? p - up : up - p;
    const int c = p > corner ? p - corner : corner - p;
    return a <= b && a <= c ? left : b <= c ? up : corner;
}

/* Undoes the filters of all rows, each behind the number of its filter. */
static void png_unfilter(const struct png_image *image, unsigned char *data)
{
    const int step = (image->samples * image->bits + 7) / 8;
    for (int y = 0; y < image->height; y++) {
        unsigned char *here = data + (size_t)y * (size_t)(image->row + 1) + 1;
        const unsigned char *above = y > 0 ? here - image->row - 1 : NULL;
        const int filter = here[-1] % 5;
        for (int i = 0; i < image->row; i++) {
            const int left = i >= step ? here[i - step] : 0;
            const int up = above ? above[i] : 0;
            const int corner = above && i >= step ? above[i - step] : 0;
            const int by[5] = {0, left, up, (left + up) / 2,
                               png_nearest(left, up, corner)};
            here[i] = (unsigned char)(here[i] + by[filter]);
        }
    }
}

/* Returns 1 if a pixel is not black. Of samples with an alpha the last is it. */
static int png_is_set(const struct png_image *image, const unsigned char *row,
                      int x)
{
    const int colours = image->samples - (image->samples % 2 == 0);
    for (int k = 0; k < colours; k++) {
        const int bit = (x * image->samples + k) * image->bits;
        const int first = row[bit / 8];
        if (image->bits < 8
                ? first >> (8 - image->bits - bit % 8)
                      & ((1 << image->bits) - 1)
                : first | (image->bits == 16 ? row[bit / 8 + 1] : 0))
            return 1;
    }
    return 0;
}

/* Reads the mask in the n characters of a word: one byte a pixel, 1 or 0, row by
   row, which the caller frees. NULL: they are no PNG that is read here, or memory
   is lacking (s->lost). */
static char *png_mask(struct shapes *s, const char *word, int n, int *width,
                      int *height)
{
    unsigned char *file = shapes_array(s, n, 1), *data = NULL;
    struct png_image image = {0};
    struct png_stream z = {0};
    char *mask = NULL;
    const int bytes = file ? png_bytes(word, n, file) : 0;
    if (file && png_head(file, bytes, &image))
        z.length = png_chunks(file, bytes);
    if (z.length > 0)
        z.room = image.height * (image.row + 1);
    if (z.room > 0 && z.room / PNG_RATIO <= z.length) {
        data = shapes_array(s, z.room, 1);
    }
    z.in = file;
    z.out = data;
    if (data)
        png_inflate(&z);
    if (data && !z.bad && z.made == z.room)
        mask = shapes_array(s, image.width * image.height, 1);
    if (mask)
        png_unfilter(&image, data);
    for (int y = 0; mask && y < image.height; y++)
        for (int x = 0; x < image.width; x++)
            mask[(size_t)y * (size_t)image.width + (size_t)x] = (char)
                png_is_set(&image,
                           data + (size_t)y * (size_t)(image.row + 1) + 1, x);
    free(file);
    free(data);
    *width = image.width;
    *height = image.height;
    return mask;
}

#endif /* PNG_H */
