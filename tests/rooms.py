"""python3 tests/rooms.py            are the rooms of kern.h as tests/rooms.txt says?
python3 tests/rooms.py --table    prints that file anew

A struct of the implementation is touched in its own chapter alone: the first
that stands beside it. Further chapters are exceptions, for each of which there
should be a reason. Every field is declared deprecated in a copy, and gcc says
where one is used. A struct has 16 fields at the most; those that have more are
listed with their number.
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


def touched(text):
    """How often each chapter touches each struct."""
    copy, fields = marked(text)
    where = chapters(text)
    with tempfile.NamedTemporaryFile('w', suffix='.h') as file:
        file.write(copy)
        file.flush()
        said = subprocess.run(
            ['gcc', '-x', 'c', '-std=c99', '-fsyntax-only', '-I.',
             '-DKERN_STATIC', '-DKERN_IMPLEMENTATION', '-fno-diagnostics-color',
             '-Wno-unused-function', file.name], capture_output=True, text=True,
            check=True, env=dict(os.environ, LC_ALL='C')).stderr
        uses = re.findall(r'^' + re.escape(file.name) +
                          r':(\d+):.* is deprecated: (kern_\w+) ', said, re.M)
    count = {name: {} for name in fields}
    for line, name in set(uses):
        tag = where[int(line) - 1]
        count[name][tag] = count[name].get(tag, 0) + 1
    return count, fields


def strays(text):
    """Constants of the implementation outside of their chapters."""
    start = text[:text.index('==== Part III')].count('\n')
    for tag, line in list(zip(chapters(text), text.split('\n')))[start:]:
        m = CONSTANT.match(line)
        if m and tag not in ('tune', 'tol'):
            yield '%s stands in >>%s' % (m[1], tag)


def row(name, count, fields, old):
    """The own chapter stays first; else it is the one that touches it most."""
    tags = sorted(count, key=lambda tag: (-count[tag], tag))
    own = old.get(name, [''])[0]
    if own in tags:
        tags.remove(own)
        tags.insert(0, own)
    more = ' (%d fields)' % fields if fields > MOST else ''
    return '%s: %s%s' % (name, ' '.join(tags), more)


def main():
    with open('kern.h', encoding='utf-8') as file:
        text = file.read()
    try:
        with open(TABLE, encoding='utf-8') as file:
            lines = [line.strip() for line in file]
    except FileNotFoundError:
        lines = []
    old = {line.split(':')[0]: line.split(':')[1].split() for line in lines}
    count, fields = touched(text)
    assert len(count) > 10
    new = [row(name, count[name], fields[name], old) for name in count]
    if sys.argv[1:] == ['--table']:
        print('\n'.join(new))
        return
    bad = 0
    for stray in strays(text):
        print(stray)
        bad += 1
    for name, line in zip(count, new):
        then = '%s: %s' % (name, ' '.join(old.get(name, ['nowhere'])))
        if sorted(line.split()) != sorted(then.split()):
            print('%s\n    and not, as %s says,\n%s' % (line, TABLE, then))
            bad += 1
    for name in old:
        if name not in count:
            print('%s of %s is no struct' % (name, TABLE))
            bad += 1
    if bad:
        sys.exit(1)
    print('%d structs, %d touched outside of their chapters' % (
        len(count), sum(len(c) > 1 for c in count.values())))


if __name__ == '__main__':
    main()
