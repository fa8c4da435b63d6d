# ./bench | awk -f tests/bench.awk                        every table
# bash tests/bench.sh                             those of BENCH.md
#
# Tables of the CSV that tests/bench.c prints, and tests/work.sh. First a robot's
# placements by size, then the files
# of the corpus by size: median, p90 and worst of each ratio, over all tries where
# stones were tried, and over all structures their sums and the share above one
# LP; then the answers and the times of each peer; then made structures. Of those
# a family's number is the median over its structures, a size's number the median
# over the families' numbers but that of fitted masonry, which has a row of its
# own; the worst is that of any structure. In rates (names that end with /s) the
# least is the worst.

BEGIN {
    FS = ","
    large = 200
    classes = split("7,12,18,25,40,100000", class, ",")
    reported = "verdict / LP;measure / LP;load / LP;tilt / LP;try / LP;" \
        "contacts / LP"
}

$1 == "family" || NF != 6 { next }
$5 ~ /^peer / {
    peer($4 == 2 ? "corpus" : "made")
    next
}
$4 == 2 {
    ratio[$5, class_of($2), ++ratios[$5, class_of($2)]] = $6
    total[$5] += $6
    of[$5]++
    above[$5] += $6 > 1
    if ($6 > peak[$5]) { peak[$5] = $6; peak_of[$5] = $3 }
    if (!(($1, $3) in file)) { file[$1, $3] = 1; files[class_of($2)]++ }
    next
}
$5 ~ /^robot / {
    robot(substr($5, 7), class_of($2))
    next
}
$1 == "memory" { memory[$2, $5] = $6; next }
{
    if (!($1 in wall)) { family[++families] = $1; wall[$1] = $4 }
    if (!($2 in seen)) { seen[$2] = 1; size[++sizes] = $2 }
    if ($5 == "fallen") { fallen = fallen " " $1 "/" $2 "/" $3; next }
    value[$5, $2, $1, ++count[$5, $2, $1]] = $6
    sign = $5 ~ /\/s$/ ? -1 : 1
    if (!(($5, $2) in worst) || sign * $6 > sign * worst[$5, $2]) {
        worst[$5, $2] = $6
        worst_of[$5, $2] = $1 "/" $2 "/" $3
    }
}

# Keeps a number of a placement, and counts how often both judges agree.
function robot(name, k) {
    asked[name, k, ++asks[name, k]] = $6
    if (name == "lets go") lets_go = $6
    if (name == "Box2D stays") same[k] += lets_go == $6
}

# Keeps an answer of a peer: which question it was, how the answer was, and its
# time over that of kern.h.
function peer(set,    word, key) {
    split($5, word, " ")
    key = set " " word[3] " " word[2]
    if (!(key in answers)) asked_of[++peers_asked] = key
    slower[key, ++answers[key]] = $6
    answer[key, word[4]]++
}

# How often each peer answered, and its time over the verdict's where it was right
# or not; the corpus first.
function peer_table(    list, word, text, i, j, k, n, set) {
    text["open"] = "as it is"
    text["closed"] = "kerns closed"
    printf("%s| structures | question | solver | asked | right | no answer | " \
           "wrong | time / verdict: median, p90, worst |\n" \
           "|---|---|---|---:|---:|---:|---:|---:|\n",
           summary ? "## Other solvers\n\n" : "ANSWERS of the peers\n\n")
    split("corpus made", set, " ")
    for (k = 1; k <= 2; k++)
        for (i = 1; i <= peers_asked; i++) {
            split(asked_of[i], word, " ")
            if (word[1] != set[k]) continue
            n = answers[asked_of[i]]
            for (j = 1; j <= n; j++) list[j] = slower[asked_of[i], j]
            j = median(list, n)
            printf("| %s | %s | %s | %d | %d | %d | %d | %s  %s  %s |\n",
                   word[1], text[word[2]], word[3], n,
                   answer[asked_of[i], "right"], answer[asked_of[i], "none"],
                   answer[asked_of[i], "wrong"], number(j, 2),
                   number(list[int(0.9 * (n - 1) + 1.5)], 2), number(list[n], 2))
        }
    printf("\n")
}

# A robot's whole question, a row for each class of sizes.
function robots(    list, item, all, m, k, i, j, n, sum) {
    m = split("pose us;touch us;bears us;try us;stays us;kern us;Box2D us;" \
              "Box2D / kern", all, ";")
    printf("%s| stones | placements |", summary ? "## A robot's question\n\n" : \
           "A ROBOT'S QUESTION: median, p90, worst of each step\n\n")
    for (i = 1; i <= m; i++) cell(all[i])
    cell("sums, Box2D / kern")
    cell("agree")
    printf("\n|---:|---:|")
    for (i = 1; i <= m + 2; i++) printf("---:|")
    printf("\n")
    for (k = 1; k <= classes; k++) {
        if (!asks["kern us", k]) continue
        printf("| %s | %d |", k == classes ? "> " class[k - 1] : \
               (k > 1 ? class[k - 1] + 1 : 1) "-" class[k], asks["kern us", k])
        for (i = 1; i <= m; i++) {
            n = asks[all[i], k]
            for (j = 1; j <= n; j++) list[j] = asked[all[i], k, j]
            item = n ? number(median(list, n), 2) : ""
            if (n) item = item "  " number(list[int(0.9 * (n - 1) + 1.5)], 2) \
                "  " number(list[n], 2)
            cell(item)
        }
        for (i in sum) delete sum[i]
        n = asks["Box2D us", k]
        for (j = 1; j <= n; j++) {
            sum["kern"] += asked["kern us", k, j]
            sum["Box2D"] += asked["Box2D us", k, j]
        }
        cell(n ? number(sum["Box2D"] / sum["kern"], 2) : "")
        cell(n ? same[k] " of " n : "")
        printf("\n")
    }
    printf("\n")
}

function class_of(blocks,    k) {
    for (k = 1; k < classes && blocks > class[k]; k++) ;
    return k
}

# "median p90 worst" of a ratio in classes from..to; "" where there is none.
function spread(name, from, to,    list, n, i, k, m) {
    for (k = from; k <= to; k++)
        for (i = 1; i <= ratios[name, k]; i++) list[++n] = ratio[name, k, i]
    if (!n) return ""
    m = median(list, n) # sorts the list
    return number(m, 2) "  " number(list[int(0.9 * (n - 1) + 1.5)], 2) "  " \
        number(list[n], 2)
}

# The files, a row for each class of sizes.
function corpus(list,    all, m, k, i, name, unit, sum, mean) {
    m = split(list, all, ";")
    if (!("verdict / LP" in of)) return
    printf("%s| stones | structures |", summary ? "## Real structures\n\n" : \
           "THE CORPUS: median, p90, worst of each question / LP\n\n")
    for (i = 1; i <= m; i++) cell(all[i])
    printf("\n|---:|---:|")
    for (i = 1; i <= m; i++) printf("---:|")
    printf("\n")
    for (k = 1; k <= classes + 1; k++) {
        if (k <= classes && !files[k]) continue
        sum += files[k]
        printf("| %s | %d |", k > classes ? "all" : k == classes ? "> " \
               class[k - 1] : (k > 1 ? class[k - 1] + 1 : 1) "-" class[k],
               k > classes ? sum : files[k])
        for (i = 1; i <= m; i++)
            cell(spread(all[i], k > classes ? 1 : k, k > classes ? classes : k))
        printf("\n")
    }
    printf("| the worst | |")
    for (i = 1; i <= m; i++) cell(peak_of[all[i]])
    printf("\n| above one LP | |")
    for (i = 1; i <= m; i++)
        cell(of[all[i]] ? sprintf("%.1f %%", 100 * above[all[i]] / of[all[i]]) : "")
    unit = "verdict ms" in of ? "ms" : "M"
    if ("LPs" in of)
        mean = sprintf("A measure takes %.1f top-down passes and linear " \
            "programs, and %.1f pivots, on the average.\n\n",
            total["LPs"] / of["LPs"], total["pivots"] / of["pivots"])
    printf("\n| sum, %s | |", unit == "M" ? "million instructions" : unit)
    for (i = 1; i <= m; i++) {
        name = all[i]
        sub(/\/ LP/, unit, name)
        cell(number(total[name], 3))
    }
    printf("\n\n%s", mean)
}

# The median of list[1..n]; "" where n is 0.
function median(list, n,    i, j, x) {
    for (i = 2; i <= n; i++) {
        x = list[i]
        for (j = i - 1; j >= 1 && list[j] > x; j--) list[j + 1] = list[j]
        list[j + 1] = x
    }
    return n ? (list[int((n + 1) / 2)] + list[int(n / 2) + 1]) / 2 : ""
}

# Of one family at one size; size "growth": its exponent.
function of_family(name, blocks, f,    list, i, n) {
    if (blocks == "growth") return growth(name, f)
    n = count[name, blocks, f]
    for (i = 1; i <= n; i++) list[i] = value[name, blocks, f, i]
    return median(list, n)
}

# The median over all families but fitted masonry, or over the walls alone.
function of_all(name, blocks, walls,    list, i, n, v) {
    for (i = 1; i <= families; i++) {
        if (family[i] == "fit") continue
        v = of_family(name, blocks, family[i])
        if (v != "" && (!walls || wall[family[i]])) list[++n] = v
    }
    return median(list, n)
}

# The slope of log(median) over log(size) by least squares, from 30 blocks on.
function growth(name, f,    i, n, v, lx, ly, x, y, xx, xy) {
    for (i = 1; i <= sizes; i++) {
        v = of_family(name, size[i], f)
        if (size[i] < 30 || v == "") continue
        lx = log(size[i])
        ly = log(v)
        n++
        x += lx
        y += ly
        xx += lx * lx
        xy += lx * ly
    }
    return n > 1 ? (n * xy - x * y) / (n * xx - x * x) : ""
}

function number(v, digits) {
    if (v == "") return ""
    return sprintf(v >= 10 ^ digits - 0.5 ? "%.0f" : "%." digits "g", v)
}

function cell(text) { printf(summary ? " %s |" : " %18s |", text) }

function heading(name) { sub(/ ms$/, ", ms", name); return name }

# Rows of one size: the median, fitted masonry or each family, the worst.
function rows(blocks, names, n,    i, k, v, top, digits) {
    digits = summary ? 2 : 3
    for (i = 0; i <= families + (blocks != "growth"); i++) {
        if (summary && i > 0 && i <= families && family[i] != "fit") continue
        printf("| %6s | %-6s |", blocks, i == 0 ? "median" : i > families ? \
               "worst" : summary ? "fitted" : family[i])
        for (k = 1; k <= n; k++) {
            top = worst_of[names[k], blocks]
            v = i == 0 ? of_all(names[k], blocks) : i <= families ? \
                of_family(names[k], blocks, family[i]) : worst[names[k], blocks]
            cell(number(v, digits) (i > families && top ? " " top : ""))
        }
        printf("\n")
    }
}

# Columns that nothing was found for are left out. which: 0 the sizes up to
# `large`, 1 those above, 2 the growth exponents.
function table(title, list, which,    all, names, want, m, n, i, k, found) {
    m = split(list, all, ";")
    for (i = 1; i <= sizes; i++)
        if (which == (size[i] > large)) want[++found] = size[i]
    if (which == 2) want[found = 1] = "growth"
    for (k = 1; k <= m; k++)
        for (i = 1; i <= found; i++)
            if ((which == 2 && of_all(all[k], "growth") != "") ||
                ((all[k], want[i]) in worst)) { names[++n] = all[k]; break }
    if (!n) return
    printf("%s| blocks | |", summary ? "" : title "\n\n")
    for (k = 1; k <= n; k++) cell(heading(names[k]))
    printf("\n|---:|---|")
    for (k = 1; k <= n; k++) printf("---:|")
    printf("\n")
    for (i = 1; i <= found; i++) rows(want[i], names, n)
    printf("\n")
}

function over_all() {
    printf("| over all | |\n|---|---:|\n| growth of the measure on walls, " \
           "exponent from 30 to %d blocks | %.2g |\n", size[sizes],
           of_all("measure ms", "growth", 1))
    printf("| lean work memory, 30 blocks with 70 line contacts, KB | %.0f |\n" \
           "| the same with the blocks and contacts, KB | %.0f |\n" \
           "| lean work memory, 1000 blocks with 3500 points, KB | %.0f |\n",
           memory[31, "lean KB"], memory[31, "whole KB"],
           memory[1001, "lean KB"])
    printf("| structures that fall or reach the limit, in columns of the verdict alone |%s |" \
           "\n\n", fallen)
}

END {
    for (k = 1; k <= classes; k++) if (asks["kern us", k]) placed = 1
    if (placed) robots()
    corpus(reported)
    if (peers_asked) peer_table()
    if (!families) exit
    times = "verdict ms;measure ms;scan ms;kerns closed ms;load ms;tilt ms"
    for (which = 0; which < 2 && !summary; which++) {
        table("RATIOS to the faster simplex's cold LP and warm Algorithm 1; to " \
              "the floor", "verdict / LP;measure / LP;kerns closed / LP;" \
              "Alg. 1 / peer's;scan / peer's;measure / floor", which)
        table("RATIOS to the measure",
              "load / measure;tilt / measure;try / measure", which)
        table("CANDIDATES on walls", "places;stand;margin stays;tries/s;" \
              "stay/s;bears/s", which)
        table("TIMES", times ";floor ms;contacts ms", which)
        table("TIMES of the peers", "GLPK ms;Clp ms;DAQP ms;OSQP ms;" \
              "LP closed ms;GLPK's Alg. 1 ms;Clp's Alg. 1 ms", which)
        table("COUNTS", "points;d*/d_max;pivots at 0;pivots;LPs", which)
    }
    if (!summary) {
        table("GROWTH: exponent of the time, from 30 blocks on",
              times ";peer's LP ms;peer's Alg. 1 ms", 2)
        printf("Without a margin:%s\n", fallen)
        exit
    }
    printf("## Made structures\n\n")
    for (which = 0; which < 2; which++) {
        table("", "verdict ms;measure ms;peer's LP ms;verdict / LP;" \
              "measure / LP;kerns closed / LP;Alg. 1 / peer's", which)
        table("", "measure / floor;load / measure;tilt / measure;" \
              "try / measure;tries/s;stay/s;bears/s", which)
    }
    over_all()
}
