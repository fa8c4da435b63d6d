"""python3 tests/rooms.py            are the rooms of kern.h as tests/rooms.txt says?
python3 tests/rooms.py --table    prints that file anew

A struct of the implementation is touched in its own chapter alone: the first
that stands beside it. Further chapters are exceptions, for each of which the
line says a reason; a star: the chapter writes fields, too. Every field is
declared deprecated in a copy, and gcc says where one is used; constant in
another, and gcc says where one is written. A struct has 16 fields at the most;
those that have more are listed with their number.

No chapter calls a function of a later one, except a public function.
"""
import os
import re
import subprocess
import sys
import tempfile

MOST = 16  # fields
TABLE = 'tests/rooms.txt'
STRUCT = re.compile(r'^(?:typedef )?struct (kern_\w+) \{([^{}]*)\}', re.M)
CONSTANT = re.compile(r'#define (KERN_\w+) +(?!\(-1\))[-(\dK]')
RULER = re.compile(r'^/\* (?:----|====).*>>(\w+)')


def blank(text):
    """Comments become spaces: columns and lines stay."""
    return re.sub(r'/\*.*?\*/', lambda m: re.sub(r'[^\n]', ' ', m[0]), text,
                  flags=re.S)


def declarators(body):
    """The places where the fields of a struct end, outside of brackets."""
    depth = 0
    for i, c in enumerate(body):
        depth += (c in '[({') - (c in '])}')
        if c in ',;' and depth == 0:
            yield i


def marked(text):
    """The header with every field of the implementation deprecated, and the
    number of fields of each struct."""
    start = text.index('==== Part III')
    fields, out, at = {}, [], 0
    plain = blank(text)
    for m in STRUCT.finditer(plain, start):
        places = list(declarators(m[2]))
        fields[m[1]] = len(places)
        for i in places:
            out.append(plain[at:m.start(2) + i])
            out.append(' __attribute__((deprecated("%s")))' % m[1])
            at = m.start(2) + i
    out.append(plain[at:])
    return ''.join(out), fields


def chapters(text):
    """The chapter of each line."""
    found, tag = [], ''
    for line in text.split('\n'):
        m = RULER.match(line)
        tag = m[1] if m else tag
        found.append(tag)
    return found


def said(header, pattern):
    """The lines of a header of which gcc says what the pattern looks for, with
    what the pattern found."""
    with tempfile.NamedTemporaryFile('w', suffix='.h') as file:
        file.write(header)
        file.flush()
        words = subprocess.run(
            ['gcc', '-x', 'c', '-std=c99', '-fsyntax-only', '-I.',
             '-DKERN_STATIC', '-DKERN_IMPLEMENTATION', '-fmax-errors=0',
             '-fno-diagnostics-color', '-Wno-unused-function', file.name],
            capture_output=True, text=True, check=False,
            env=dict(os.environ, LC_ALL='C')).stderr
        return re.findall(r'^' + re.escape(file.name) + r':(\d+):.*' + pattern,
                          words, re.M)


def touched(text):
    """How often each chapter touches each struct."""
    copy, fields = marked(text)
    where = chapters(text)
    count = {name: {} for name in fields}
    for line, name in set(said(copy, r' is deprecated: (kern_\w+) ')):
        tag = where[int(line) - 1]
        count[name][tag] = count[name].get(tag, 0) + 1
    return count, fields


def written(text):
    """The chapters that write fields of each struct."""
    where = chapters(text)
    plain = blank(text)
    found = {}
    for m in STRUCT.finditer(plain, text.index('==== Part III')):
        fixed = re.sub(r'(\*\s*)(\w+)', r'\1const \2', m[2])
        fixed = re.sub(r'(^|;)(\s*)(?=\w[^;*]*;)', r'\1\2const ', fixed)
        copy = plain[:m.start(2)] + fixed + plain[m.end(2):]
        found[m[1]] = {where[int(line) - 1]
                       for line, _ in said(copy, r'(read-only)')}
    return found


def strays(text):
    """Constants of the implementation outside of their chapters."""
    start = text[:text.index('==== Part III')].count('\n')
    for tag, line in list(zip(chapters(text), text.split('\n')))[start:]:
        m = CONSTANT.match(line)
        if m and tag not in ('tune', 'tol'):
            yield '%s stands in >>%s' % (m[1], tag)


def forward(text):
    """Calls of private functions of later chapters."""
    tags = chapters(text)
    order = list(dict.fromkeys(tags))
    plain = blank(text)
    start = text.index('==== Part III')
    defined = {m[1]: order.index(tags[plain[:m.start(1)].count('\n')])
               for m in re.finditer(r'^static [^;{}=]*?\b(kern_\w+)\([^;{}]*\)'
                                    r' *\n\{', plain, re.M)}
    assert len(defined) > 100
    for m in re.finditer(r'\b(kern_\w+)\(', plain[start:]):
        tag = tags[plain[:start + m.start()].count('\n')]
        if defined.get(m[1], 0) > order.index(tag):
            yield '%s in >>%s is of the later >>%s' % (
                m[1], tag, order[defined[m[1]]])


def row(name, count, writers, fields, old):
    """The own chapter stays first; else it is the one that touches it most."""
    tags = sorted(count, key=lambda tag: (-count[tag], tag))
    own, _, reason = old.get(name, '').partition(' | ')
    own = own.split(' ')[0]
    if own in tags:
        tags.remove(own)
        tags.insert(0, own)
    rest = sorted(tag + '*' * (tag in writers) for tag in tags[1:])
    more = ' (%d fields)' % fields if fields > MOST else ''
    return ' '.join([tags[0]] + rest) + more + (' | ' + reason if rest else '')


def main():
    with open('kern.h', encoding='utf-8') as file:
        text = file.read()
    try:
        with open(TABLE, encoding='utf-8') as file:
            old = dict(line.rstrip('\n').split(': ', 1) for line in file)
    except FileNotFoundError:
        old = {}
    count, fields = touched(text)
    writers = written(text)
    assert len(count) > 10
    new = {name: row(name, count[name], writers[name], fields[name], old)
           for name in count}
    if sys.argv[1:] == ['--table']:
        print('\n'.join('%s: %s' % item for item in new.items()))
        return
    bad = list(strays(text)) + list(forward(text))
    for name, line in new.items():
        if line != old.get(name):
            bad.append('%s: %s\n    and not, as %s says,\n%s' % (
                name, line, TABLE, old.get(name, 'nothing')))
        elif line.endswith('| '):
            bad.append('%s is touched outside of its chapter for no reason'
                       % name)
    bad += ['%s of %s is no struct' % (name, TABLE)
            for name in old if name not in count]
    if bad:
        sys.exit('\n'.join(bad))
    print('%d structs, %d touched outside of their chapters, %d written' % (
        len(count), sum(len(tags) > 1 for tags in count.values()),
        sum('*' in line.partition(' | ')[0] for line in new.values())))


if __name__ == '__main__':
    main()
