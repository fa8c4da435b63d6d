"""python3 tests/corpus.py baseline KERN LP >tests/corpus/baseline.csv
python3 tests/corpus.py summary
python3 tests/corpus.py score VALUES

baseline: what the library says of every structure of the corpus, by the program
KERN (examples/kern.c), and what one cold LP costs, from the lines that
bash tests/work.sh lp LIST prints for both halves, in the file LP. summary: the
tables of tests/CORPUS.md, from tests/corpus/*.csv. score: how well another
measure does; VALUES has a line NAME,VALUE a structure, larger is safer.
"""
import csv
import json
import os
import subprocess
import sys

FOLDER = 'tests/corpus/'
COLUMNS = ('half', 'set', 'name', 'stones', 'points', 'status', 'margin',
           'load', 'tilt', 'reserve', 'drop', 'lp')


def rows(name):
    with open(FOLDER + name, encoding='utf-8') as file:
        return list(csv.DictReader(file))


def asked(kern, files, *options):
    """The JSON objects of examples/kern.c for some files, by path."""
    said = subprocess.run([kern, '--json', *options, *files], text=True,
                          capture_output=True, check=False)
    assert said.returncode <= 1, said.stderr
    return {r['file']: r for r in map(json.loads, said.stdout.splitlines())}


def least(r, what):
    """Of both sides, the smaller one."""
    both = [r[what + side] for side in ('_left', '_right')
            if r.get(what + side) is not None]
    return min(both) if both else None


def number(value):
    return '' if value is None else '%.6g' % value


def baseline(kern, costs):
    with open(costs, encoding='utf-8') as file:
        cost = dict(line.strip().split(',') for line in file)
    out = csv.writer(sys.stdout, lineterminator='\n')
    out.writerow(COLUMNS)
    for half in ('odd', 'even'):
        with open(FOLDER + half + '.txt', encoding='utf-8') as file:
            files = file.read().split()
        plain = asked(kern, files, '--raised')
        near = asked(kern, files, '--near', '--profile')
        for path in files:
            r, n = plain[path], near[path]
            base = os.path.splitext(path)[0].split('/')[-2:]
            out.writerow([
                half, *base, r['blocks'], r['contact_points'], r['status'],
                number(r['margin'] if r['status'] == 'stands' else None),
                number(least(r, 'load')), number(least(r, 'tilt')),
                number(r.get('reserve')), number(n.get('expected_drop')),
                cost['/'.join(base)]])


def ranks(values):
    order = sorted(range(len(values)), key=values.__getitem__)
    rank = [0.0] * len(values)
    at = 0
    while at < len(order):
        end = at
        while end < len(order) and values[order[end]] == values[order[at]]:
            end += 1
        for k in order[at:end]:
            rank[k] = (at + end - 1) / 2
        at = end
    return rank


def spearman(a, b):
    """Rank correlation, ties by their mean rank."""
    x, y = ranks(a), ranks(b)
    mean = (len(x) - 1) / 2
    both = sum((p - mean) * (q - mean) for p, q in zip(x, y))
    return both / (sum((p - mean) ** 2 for p in x)
                   * sum((q - mean) ** 2 for q in y)) ** 0.5


def correlations(found, what, sign=1):
    """A row of the table of shaken(): by half, and of how many structures."""
    level = {r['name']: float(r['level']) for r in rows('shaken.csv')}
    cells = []
    for half in ('odd', 'even', ''):
        some = [r for r in found if r['set'] == 'shaken' and r[what]
                and half in ('', r['half'])]
        cells.append('%.2f (%d)' % (
            spearman([sign * float(r[what]) for r in some],
                     [level[r['name']] for r in some]), len(some)))
    print('| %s | %s |' % (what, ' | '.join(cells)))


def shaken(found):
    print('| rank correlation with the level of collapse | odd | even | all |')
    print('|---|---:|---:|---:|')
    for what, sign in (('margin', 1), ('load', 1), ('reserve', 1),
                       ('drop', -1)):
        correlations(found, what, sign)


def score(found, values):
    """The same row for other values, and the share of the pairs of a new stone
    that stays and one that moves which they order as they should; ties half."""
    with open(values, encoding='utf-8') as file:
        value = dict(line.strip().split(',') for line in file if line.strip())
    for r in found:
        r['value'] = value.get(r['name'], '')
    correlations(found, 'value')
    label = {r['name']: r['label'] for r in rows('placed.csv')}
    stays, moves = ([float(r['value']) for r in found if r['value']
                     and r['set'] == 'placed' and label[r['name']] == name]
                    for name in ('stays', 'moves'))
    right = sum((a > b) + (a == b) / 2 for a in stays for b in moves)
    print('stays above moves: %.2f of %d pairs'
          % (right / max(len(stays) * len(moves), 1), len(stays) * len(moves)))


def placed(found):
    label = {r['name']: r['label'] for r in rows('placed.csv')}
    print('\n| the new stone | structures | stand | reserve at least .0055 | '
          'load factor above .02 |\n|---|---:|---:|---:|---:|')
    for name in ('stays', 'unclear', 'moves'):
        some = [r for r in found if r['set'] == 'placed'
                and label[r['name']] == name]
        print('| %s | %d | %d | %d | %d |' % (
            name, len(some), sum(r['status'] == 'stands' for r in some),
            sum(float(r['reserve'] or 0) >= 0.0055 for r in some),
            sum(float(r['load'] or 0) > 0.02 for r in some)))


def sizes(found):
    print('\n| stones | structures | contact points | stand | median margin | '
          'million instructions of an LP, median |\n'
          '|---:|---:|---:|---:|---:|---:|')
    bounds = (1, 8, 13, 19, 26, 41, 10 ** 6)
    for low, high in zip(bounds, bounds[1:]):
        some = [r for r in found if low <= int(r['stones']) < high]
        if not some:
            continue
        margin = sorted(float(r['margin']) for r in some if r['margin'])
        cost = sorted(float(r['lp']) for r in some)
        print('| %s | %d | %d to %d | %d | %.3f | %.2f |' % (
            '%d-%d' % (low, high - 1) if high < 10 ** 6 else '> 40', len(some),
            min(int(r['points']) for r in some),
            max(int(r['points']) for r in some),
            sum(r['status'] == 'stands' for r in some),
            margin[len(margin) // 2], cost[len(cost) // 2] / 1e6))


def summary(found):
    shaken(found)
    placed(found)
    sizes(found)


if __name__ == '__main__':
    if sys.argv[1] == 'baseline':
        baseline(*sys.argv[2:])
    else:
        {'summary': summary, 'score': score}[sys.argv[1]](
            rows('baseline.csv'), *sys.argv[2:])
