"""python3 tests/judge.py WHAT FILE...    what the example programs wrote

structures, profiles, each_block, let_go: JSON of examples/kern.c; pushes: of
examples/push.c, of the structure that is built in; figures, walls: the folder that
figures.c and walls.c of examples/laboratory wrote into; svg: pictures;
functions: C sources, whose functions must be short and simple; tokens: how
many the implementation of kern.h has; rules: the map from the rules of kern.h to
the tests.
Fails with the first thing that is wrong.
"""
import csv
import glob
import html.parser
import json
import os
import re
import sys
import xml.dom.minidom


def rows(folder, name):
    with open(os.path.join(folder, name), encoding='utf-8') as file:
        return list(csv.DictReader(file))


def objects(name):
    with open(name, encoding='utf-8') as file:
        return [json.loads(line) for line in file]


def svg(*names):
    assert names
    for name in names:
        xml.dom.minidom.parse(name)


def structures(name):
    found = objects(name)
    assert len(found) >= 10
    assert all(r['status'] in ('stands', 'falls') for r in found), found
    assert [r['file'] for r in found if r['status'] == 'falls'] == [
        'examples/structures/falls.kern', 'examples/structures/ladder.kern']
    for r in found:
        resultants(r)
    arch, = (r for r in found if r['file'].endswith('/arch.kern'))
    for p in arch['resultants']:  # its forces are as symmetric as it is
        assert any(abs(p['x'] + q['x']) < 1e-6 and abs(p['y'] - q['y']) < 1e-6
                   and abs(p['stress'] - q['stress']) < 1e-3
                   for q in arch['resultants']), p
    assert len(arch['thrust']) == arch['blocks']


def resultants(r):
    """They are the sums of the contacts' forces; the thrust joins them."""
    for p in r['resultants']:
        pair = [c for c in r['contacts']
                if (c['a'], c['b']) == (p['a'], p['b'])]
        fx = sum(c['normal'] * c['nx'] - c['tangential'] * c['ny']
                 for c in pair)
        fy = sum(c['normal'] * c['ny'] + c['tangential'] * c['nx']
                 for c in pair)
        size = abs(fx) + abs(fy)
        assert abs(p['fx'] - fx) + abs(p['fy'] - fy) < 1e-9 * size, p
        assert p['stress'] is None or p['stress'] <= r['peak_stress'] * 1.001
    places = {(p['x'], p['y']) for p in r['resultants']}
    assert all((t['x%d' % k], t['y%d' % k]) in places
               for t in r['thrust'] for k in (1, 2))


def axles(name, arch, folder):
    """Files with the live load as a load, a little below and above what the
    program says; the arch is symmetric, and the factor of Coulomb friction is
    never above that of limit analysis."""
    found, = objects(name)
    with open(arch, encoding='utf-8') as file:
        text = file.read()
    places = [p for p in found['sweep'] if p['live'] is not None]
    assert len(found['sweep']) == 14 and len(places) == 12
    least = min(places, key=lambda p: p['live'])
    even = [p for p in places if p is not least]
    for p, q in zip(even, reversed(even)):
        assert abs(p['x'] + q['x']) < 1e-9, (p, q)
        assert abs(p['live'] - q['live']) < 1e-6 * p['live'], (p, q)
    for p in places:
        assert 0 < p['raised_live'] <= p['live'] * (1 + 1e-9), p
        for word, share in ('stands', 1 - 1e-6), ('falls', 1 + 1e-6):
            path = os.path.join(folder, '%s-%g.kern' % (word, p['x']))
            with open(path, 'w', encoding='utf-8') as file:
                file.write('%sload %s 0 %r %r %r\n' % (
                    text, p['block'], -100 * p['live'] * share, p['x'],
                    p['y']))


def worst(name):
    """The least factor of a sweep is the same from few places as from many."""
    for key in 'live', 'raised_live':
        found = [min(p[key] for p in o['sweep'] if p[key] is not None)
                 for o in objects(name)]
        assert max(found) < 1.001 * min(found), (key, found)


def page(name):
    """A page to hand in: every element is closed, with a picture and tables."""
    class Page(html.parser.HTMLParser):
        opened, seen, text = [], [], ''

        def handle_starttag(self, tag, attrs):
            self.seen.append(tag)
            if tag not in ('meta', 'rect', 'path', 'circle', 'animate'):
                self.opened.append(tag)

        def handle_startendtag(self, tag, attrs):
            self.seen.append(tag)

        def handle_endtag(self, tag):
            while self.opened and self.opened[-1] == 'li' != tag:
                self.opened.pop()  # its end may be left out
            assert self.opened and self.opened.pop() == tag, (tag, self.opened)

        def handle_data(self, data):
            self.text += data

    with open(name, encoding='utf-8') as file:
        read = Page()
        read.feed(file.read())
    assert not read.opened, read.opened
    assert {'svg', 'table', 'h2', 'ul'} <= set(read.seen)
    for word in ('Results', 'Structure and loads', 'What is assumed',
                 'Sources of the rules', 'Heyman', 'Input', 'block '):
        assert word in read.text, word
    assert not re.search(r'\b(nan|inf)\b', read.text), name


def keys(name, text):
    """Every key of the objects stands in a text."""
    def found(value):
        if isinstance(value, dict):
            return set(value).union(*map(found, value.values()))
        return set().union(*map(found, value)) if isinstance(
            value, list) else set()

    with open(text, encoding='utf-8') as file:
        words = set(re.findall(r'\w+', file.read()))
    missing = {key for key in found(objects(name)) if key not in words}
    for key in list(missing):  # progressive_* stands for all of these
        if key.rsplit('_', 1)[0] + '_' in words:
            missing.discard(key)
    assert not missing, missing


def each_block(name, last, path):
    """The blocks of the file, each with a chance; the fixed ones with null."""
    (found,), (one,) = objects(name), objects(last)
    with open(path, encoding='utf-8') as file:
        words = [line.split() for line in file]
    assert [(b['fixed'], b['block']) for b in found['stays']] == [
        (w[0] == 'fixed', w[1]) for w in words if w[:1] in (
            ['block'], ['fixed'])], found
    for b in found['stays']:
        assert b['stays'] is None or not b['fixed'] and (
            0 <= b['stays'] <= 1), b
    assert found['stays'][-1]['stays'] == one['stays'], one


def undecided(key, value, name):
    """A key is named as undecided; it, or a value in its list, is null."""
    found, = objects(name)
    told = found[key]
    assert key in found['undecided'] and (told is None or None in [
        row[value] for row in told if not row.get('fixed')]), found


def wall_of_bricks(width, rows, mu, gap):
    """A running bond of square bricks with half bricks at its ends."""
    lines = ['friction %g' % mu, 'gravity 0 -1',
             'fixed ground -2 -2 %g -2 %g 0 -2 0' % (width + 2, width + 2)]
    for row in range(rows):
        cuts = ([0.0, *(k + 0.5 for k in range(width)), float(width)]
                if row % 2 else [float(k) for k in range(width + 1)])
        for k, (x, end) in enumerate(zip(cuts, cuts[1:])):
            end -= gap if end < width else 0
            lines.append('block b%d_%d * %r %d %r %d %r %d %r %d' % (
                row, k, x, row, end, row, end, row + 1, x, row + 1))
    return lines


def without(name):
    """Without the passive pressure of its fill a file says what the next one
    does, whose fill has none: the same digits."""
    one, two = objects(name)
    bare = one['without_passive']
    assert bare and two['without_passive'] is None, one
    assert bare['worst_live'] < one['worst_live'], one
    for key in bare:
        assert bare[key] == two[key], (key, bare[key], two[key])


def let_go_files(slope, folder):
    """Writes bricks at some frictions, and the slope with its blocks in another
    order, mirrored, and at a friction just below and above its least one."""
    def write(name, lines):
        with open(os.path.join(folder, name), 'w', encoding='utf-8') as file:
            file.write('\n'.join(lines) + '\n')

    with open(slope, encoding='utf-8') as file:
        lines = file.read().splitlines()
    head = [x for x in lines if x.split()[0] not in ('fixed', 'block')]
    rest = [x for x in lines if x.split()[0] in ('fixed', 'block')]
    write('slope-order.kern', head + rest[::2] + rest[::-2])
    mirrored = []
    for words in (x.split() for x in lines):
        first = {'fixed': 2, 'block': 3, 'gravity': 1}.get(words[0])
        if first:
            words[first::2] = ['%r' % -float(x) for x in words[first::2]]
        mirrored.append(' '.join(words))
    write('slope-mirror.kern', mirrored)
    for word, mu in ('below', .99 * .785544), ('above', 1.02 * .785544):
        write('slope-%s.kern' % word, [
            'friction %r' % mu if x.startswith('friction') else x
            for x in lines])
    for mu in .3, .9, 1.5:
        for gap in 0, .01:
            write('bond-%g-%g.kern' % (mu, gap),
                  wall_of_bricks(6, 6, mu, gap))


def let_go(name):
    """Textbook answers, in any order and mirrored; plain walls are no jam."""
    found = {os.path.basename(r['file'])[:-5]: r for r in objects(name)}
    slope = found['toppling-slope']
    assert slope['status'] == 'stands' and slope['let_go'] == 'not shown'
    assert 'no equilibrium' in slope['let_go_why'], slope['let_go_why']
    assert abs(slope['least_friction'] - .6596) < 1e-4, slope
    for word in 'toppling-slope', 'slope-order', 'slope-mirror':
        r = found[word]
        assert abs(r['least_friction_let_go'] - .785544) < .02 * .785544, r
    assert found['slope-below']['let_go'] == 'not shown'
    above = found['slope-above']
    assert above['let_go'] == 'stays' and above['tilt_let_go_right'] > 0
    assert 0 < above['raised_load_right'] < .9 * above['load_right'], above
    assert above['raised_end_right'] == 'no equilibrium', above
    assert above['raised_end_left'] in ('load factor', 'no equilibrium'), above
    ladder = found['ladder']
    assert ladder['let_go'] == 'moves' and 'ladder' in ladder['let_go_why']
    assert abs(ladder['live_least'] - 61.752) < 1e-3, ladder
    assert ladder['live'] > 10 * ladder['live_least'], ladder
    bonds = [r for word, r in found.items() if word.startswith('bond')]
    assert len(bonds) == 6
    for r in bonds:
        assert r['let_go'] == 'stays' and r['reserve'] >= .0055, r
        assert 'reserve' not in r['let_go_why'], r
        assert min(b['stays'] for b in r['stays'] if not b['fixed']) > .8, r


def profiles(name):
    """The least of a profile is the measure, and means are ordered."""
    for r in objects(name):
        least = min(b['margin'] for b in r['profile'])
        assert len(r['profile']) == r['blocks']
        assert abs(least - r['margin']) < 1e-5, r
        if 'props' in r:  # no means of pushes
            continue
        assert least <= r['weak_margin'] + 1e-9
        assert r['weak_margin'] <= r['progressive_margin'] + 1e-9
        assert r['progressive_load'] >= min(r['load_left'] or 0,
                                            r['load_right'] or 0) - 1e-5


def pushes(name):
    """A box 1 wide and 2 high slides, is lifted, bears any push downward."""
    found, = objects(name)
    box = found['blocks'][0]
    push = dict(zip(found['degrees'], box['push']))
    want = {0: 0.4, 90: 1, 180: 0.4, 45: 0.4 / (0.5 ** 0.5 * 1.4)}
    assert all(abs(push[k] - want[k]) < 1e-5 for k in want), push
    assert push[270] is None and not box['undecided'], box
    assert all(len(b['push']) == 24 for b in found['blocks'])


def best(name):
    """Places of one more stone: four, each in another pose, the best first."""
    found, = objects(name)
    places = found['places']
    assert len(places) == 4, places
    for p in places:
        assert p['stands'] and 0 <= p['stays'] <= 1 and p['margin'] >= 0, p
        assert p['own_margin'] >= p['margin'] * (1 - 1e-9) and p['load'] > 0, p
    classes = [min(p['stays'], 0.9) for p in places]
    assert classes == sorted(classes, reverse=True), classes
    assert len({str(p['polygon']) for p in places}) == 4


def figures(folder):
    cost = rows(folder, 'table1.csv')
    assert len(cost) == 4
    for r in cost:  # times are not judged, but for their order
        assert (0 < float(r['margin']) < float(r['profile'])
                < float(r['shaking']))
    curves = rows(folder, 'fig6.csv')
    assert len(curves) == len(rows(folder, 'labels.csv')) == 6
    assert all(0 < float(r['near_weak_load']) <= 0.401 for r in curves)
    assert all(float(r['ads1']) < 0.05 < float(r['ads20']) for r in curves)
    a, b = rows(folder, 'fig7.csv')
    assert abs(float(a['margin']) - 0.5) < 1e-6, a
    assert abs(float(b['margin']) - 0.15) < 1e-6, b
    assert int(a['level']) > 3 * int(b['level'])
    assert all(abs(float(a['ads%d' % l]) - float(b['ads%d' % l])) < 0.05
               for l in range(1, 21))
    for r in rows(folder, 'measures.csv'):
        assert abs(float(r['load']) - min(float(r['load']), 0.4)) < 1e-3
        assert float(r['margin']) <= float(r['weak_margin']) + 1e-6
        assert (float(r['weak_margin'])
                <= float(r['progressive_margin']) + 1e-6)
        assert float(r['near_load']) >= float(r['load']) - 1e-3
    pictures = (glob.glob(folder + '/*.svg')
                + glob.glob(folder + '/scatter/*.svg'))
    # fig. 3 twice, fig. 6, fig. 7 with its two walls, a plot a measure
    measured = len(rows(folder, 'measures.csv')[0]) - 4
    assert measured >= 17 and len(pictures) == 6 + measured, pictures
    svg(*pictures)
    with open(folder + '/study.md', encoding='utf-8') as file:
        assert '| near: load factor, weaker half |' in file.read()


TOKEN = re.compile(r"""
    "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])*'      # a string, a character
    | \.?\d (?:[eEpP][+-] | [\w.])* | \w+              # a number, a name
    | -> | \+\+ | -- | <<= | >>= | << | >> | && | \|\|
    | [-+*/%&|^<>=!]= | \S                              # an operator, a mark
    """, re.X)


def uncommented(text):
    """The text with each comment blanked out; its line ends stay."""
    return re.sub(r'/\*.*?\*/|"(\\.|[^"\\\n])*"',
                  lambda m: m[0] if m[0][0] == '"'
                  else ' ' + '\n' * m[0].count('\n'), text, flags=re.S)


def tokens(name):
    """Prints how many tokens the implementation has: all after Part II."""
    with open(name, encoding='utf-8') as file:
        text = file.read()
    start = re.search(r'^/\* ==== Part III', text, re.M).start()
    print(len(TOKEN.findall(uncommented(text[start:]).replace('\\\n', ' '))))


def functions(*names):
    """At most 60 code lines, and a cyclomatic complexity of at most 16
    (McCabe). Blank lines and lines of comment alone do not count."""
    found, long = 0, []
    for name in names:
        with open(name, encoding='utf-8') as file:
            text = re.sub(r'"(\\.|[^"\\\n])*"', '""', uncommented(file.read()))
        missed = len(re.findall(r'^\{', text, re.M))
        for f in re.finditer(r'^(?:\w[^;{}=]*\b(\w+)\([^;{}]*\)) *\n'
                             r'\{(?: .*\}| *\n(?:.*\n)*?\})$', text, re.M):
            lines = sum(1 for line in f[0].split('\n') if line.strip())
            ways = 1 + len(re.findall(r'\b(?:if|for|while|case)\b|&&|\|\||\?',
                                      f[0]))
            found += 1
            missed -= 1
            if lines > 60 or ways > 16:
                long.append((name, f[1], lines, ways))
        assert missed == 0, (name, missed)
    assert found > 0, names
    assert not long, long


def rules(header='kern.h', tests='tests/kern_test.c', rooms='tests/unit/*.h'):
    """Each rule stands in the map of the tests, each name there is a test's,
    and each room that has tests is listed."""
    with open(header, encoding='utf-8') as file:
        stated = re.search(r'>>rules\n(.*?)>>measures\n', file.read(), re.S)[1]
    with open(tests, encoding='utf-8') as file:
        text = file.read()
    listed = re.search(r'RULES of the header.*?:\n(.*?)\n\n', text, re.S)[1]
    named = re.findall(r'\w+_\w*|(?<= )overlap(?= \w+_)', listed)
    assert len(named) > 20, named
    run = ''
    for name in sorted(glob.glob(rooms)):
        with open(name, encoding='utf-8') as file:
            room = file.read()
        found = re.findall(r'\bTEST\((\w+)\),', room)
        run += ' ' + ' '.join(found)
        room = os.path.basename(name)[:-2]
        assert not found or 'TESTS_OF(%s)' % room in text, room
    missed = [n for n in named if n not in run]
    missed += [r for r in re.findall(r'^ {5}([a-z]+)  ?(?=[ A-Z])', stated, re.M)
               if not re.search(r' %ss?\b' % r.rstrip('s'), listed)]
    assert not missed, missed


def walls(folder):
    found = rows(folder, 'walls.csv')
    assert len(found) == 5 * 2 * 3
    assert all(0.4 < float(r['filling']) < 1 and int(r['stones']) > 15
               and int(r['level']) > 0 for r in found), found
    assert len(rows(folder, 'fig9.csv')) == 15
    svg(folder + '/fig8.svg', folder + '/fig9.svg')


if __name__ == '__main__':
    checks = (svg, structures, axles, worst, page, keys, each_block,
              without, let_go_files, let_go, undecided, profiles, pushes, best, figures,
              functions, tokens, rules, walls)
    {f.__name__: f for f in checks}[sys.argv[1]](*sys.argv[2:])
