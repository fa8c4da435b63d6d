/* engine.js - the library, a structure, its picture, and stones that move: what
   page.html and steps.html share; build.sh puts it into both. A page has
   say(), sayAsked(), placingError() and a slider `shrink`.
   SPDX-License-Identifier: MIT */
"use strict";
const $ = id => document.getElementById(id);

/* ==== The library ======================================================= */

let kern, exported;             // what page.c exports, and its arrays
let STANDS, FALLS, OVERLAP, RAISED, HANGS, LOST, WORK, RESTS;

async function loadLibrary() {
    const bytes = Uint8Array.from(atob($("wasm").textContent),
                                  c => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream()
        .pipeThrough(new DecompressionStream("gzip"));
    const code = await new Response(stream).arrayBuffer();
    const { instance } = await WebAssembly.instantiate(code, { page: {
        read_number: readNumber, write_number: writeNumber } });
    exported = instance.exports;
    const ints = new Int32Array(exported.memory.buffer,
                                exported.constant.value, 10);
    kern = { ...exported, blocks: ints[0], vertices: ints[1] };
    [STANDS, FALLS, OVERLAP, RAISED, HANGS, LOST, WORK, RESTS] = ints.slice(2);
    lookAtMemory();
}

/* The arrays of the library, which move where its memory has grown. */
function lookAtMemory() {
    const memory = exported.memory.buffer;
    const doubles = (name, length) =>
        new Float64Array(memory, exported[name].value, length);
    kern.vertex = doubles("vertex", 2 * kern.vertices);
    kern.force = doubles("force");
    kern.motion = doubles("motion");
    kern.group = new Int32Array(memory, exported.group.value, kern.blocks);
    kern.meeting = new Int32Array(memory, exported.meeting.value);
    kern.centre = doubles("centre", 2 * kern.blocks);
    kern.point = doubles("point");
    kern.overlap = doubles("overlap");
    kern.fault = doubles("fault", 4);
    kern.answer = doubles("answer", 6);
}

/* What examples/browser/heap.h asks of the page: numbers as text.h has them. */
const NUMBER = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i;

function readNumber(at, length, out) {
    const word = String.fromCharCode(
        ...new Uint8Array(exported.memory.buffer, at, Math.min(length, 5000)));
    const value = Number(word);
    if (length > 5000 || !NUMBER.test(word) || !Number.isFinite(value))
        return 0;
    new DataView(exported.memory.buffer).setFloat64(out, value, true);
    return 1;
}

function writeNumber(value, digits, out) {
    const word = String(digits < 17 ? Number(value.toPrecision(digits))
                                    : value);
    const bytes = new Uint8Array(exported.memory.buffer);
    for (let i = 0; i < word.length; i++) bytes[out + i] = word.charCodeAt(i);
    return word.length;
}

function textAt(at) {
    const bytes = new Uint8Array(exported.memory.buffer);
    return new TextDecoder().decode(bytes.slice(at, bytes.indexOf(0, at)));
}

const statusText = status => textAt(kern.text(status));

/* ==== Structures as text ================================================ */
/* The format of examples/parts/text.h, one statement a line. */

function number(word, least = -Infinity) {
    const value = Number(word);
    if (!NUMBER.test(word || "") ||
        !Number.isFinite(value) || !(value >= least))
        throw Error(`a number is expected, read '${word || "nothing"}'`);
    return value;
}

function pairs(words) {
    const out = [];
    if (words.length % 2)
        throw Error("the number of coordinates is odd");
    for (let i = 0; i < words.length; i += 2)
        out.push([number(words[i]), number(words[i + 1])]);
    return out;
}

const STATEMENTS = {
    friction(s, [mu]) { s.mu = number(mu, 0); },
    gravity(s, [x, y]) { s.gravity = [number(x), number(y)]; },
    density(s, [value]) { s.density = number(value, 0); },
    epsilon(s, [value]) { s.epsilon = number(value, 0); },
    tolerance(s, [gap, angle]) {
        s.gap = number(gap, 0);
        s.angle = angle ? number(angle, 0) : 0.0174533;
    },
    measured(s, [error, turn]) {
        s.error = number(error, 0);
        s.errorTurn = turn ? number(turn, 0) : 0;
    },
    units(s, [name]) { s.units = name; },
    fixed(s, [name, ...words]) { addStone(s, name, pairs(words), true); },
    block(s, [name, mass, ...words]) {
        addStone(s, name, pairs(words), false).mass =
            mass === "*" ? null : number(mass, 0);
    },
    com(s, [name, x, y]) {
        freeStone(s, name).com = [number(x), number(y)];
    },
    load(s, [name, ...words]) {
        const [force, at] = pairs(words);
        if (!at) throw Error("a force and a point are expected");
        freeStone(s, name).loads.push({ force, at });
    },
    live(s, [name, ...words]) {
        const [force, at] = pairs(words);
        if (!at) throw Error("a force and a point are expected");
        freeStone(s, name).lives.push({ force, at });
    },
    mass(s, [name, mass, x, y]) {
        freeStone(s, name).weights.push({ mass: number(mass, 0),
                                          at: [number(x), number(y)] });
    },
    torque(s, [name, value]) { freeStone(s, name).torque += number(value); },
    contact(s, [a, b, ...words]) {
        const at = words.indexOf("mu");
        const mu = at < 0 ? null : number(words[at + 1], 0);
        const [normal, p, q] = pairs(at < 0 ? words : words.slice(0, at));
        if (!p) throw Error("a normal and a point are expected");
        s.contacts.push({ a: s.stones.indexOf(stoneOf(s, a)),
                          b: s.stones.indexOf(stoneOf(s, b)),
                          normal, p, q: q || p, mu });
    }
};

function stoneOf(s, name) {
    const stone = s.stones.find(stone => stone.name === name);
    if (!stone) throw Error(`there is no block '${name}'`);
    return stone;
}

function freeStone(s, name) {
    const stone = stoneOf(s, name);
    if (stone.fixed) throw Error(`'${name}' is fixed`);
    return stone;
}

function addStone(s, name, home, fixed) {
    if (!name) throw Error("a name is expected");
    if (s.stones.some(stone => stone.name === name))
        throw Error(`the name '${name}' was given already`);
    const stone = { name, home, fixed, density: fixed ? 0 : s.density,
                    mass: null, com: null, loads: [], lives: [], weights: [],
                    torque: 0,
                    x: 0, y: 0, turn: 0 };
    s.stones.push(stone);
    return stone;
}

function parse(text) {
    const s = { mu: 0.4, gravity: [0, -9.81], density: 1, epsilon: 0, gap: 0,
                angle: 0.0174533, error: 0, errorTurn: 0, units: "",
                stones: [], contacts: [] };
    text.replace(/^\ufeff/, "").split("\n").forEach((line, i) => {
        const words = line.replace(/#.*/, "").trim().split(/\s+/);
        if (words[0] === "") return;
        try {
            if (!Object.hasOwn(STATEMENTS, words[0]))
                throw Error(`unknown statement '${words[0]}'`);
            STATEMENTS[words[0]](s, words.slice(1));
        } catch (error) {
            throw Error(`line ${i + 1}: ${error.message}`);
        }
    });
    if (s.stones.every(stone => stone.fixed)) throw Error("no block is free");
    return s;
}

/* ==== The structure in the library ====================================== */

let s;                          // the structure
let shown;                      // what was found out about it

/* Is a box checked? What a page has no box for is wanted. */
const wanted = id => $(id)?.checked ?? true;

/* Where a point of a stone is, in its present place. */
function placed(stone, [x, y]) {
    if (stone.turn) {
        const c = Math.cos(stone.turn), q = Math.sin(stone.turn);
        const dx = x - stone.pivot[0], dy = y - stone.pivot[1];
        x = stone.pivot[0] + c * dx - q * dy;
        y = stone.pivot[1] + q * dx + c * dy;
    }
    return [x + stone.x, y + stone.y];
}

function putStone(i) {
    const stone = s.stones[i];
    stone.home.forEach((p, k) =>
        kern.vertex.set(placed(stone, p), 2 * (stone.first + k)));
    const status = kern.block(i, stone.first, stone.home.length, stone.density);
    if (status < 0) throw Error(`'${stone.name}': ${statusText(status)}`);
    if (stone.mass !== null) kern.mass(i, stone.mass);
    if (stone.com) kern.move_centre(i, ...placed(stone, stone.com));
    for (const { mass, at } of stone.weights)
        kern.weight(i, mass, ...placed(stone, at));
    for (const { force, at } of stone.loads)
        kern.load(i, ...force, ...placed(stone, at), 0);
    for (const { force, at } of stone.lives)
        kern.live(i, ...force, ...placed(stone, at));
    if (stone.torque) kern.load(i, 0, 0, 0, 0, stone.torque);
    stone.centre = [kern.centre[2 * i], kern.centre[2 * i + 1]];
    stone.pivot ??= stone.centre;
}

function putStructure() {
    let first = 0;
    for (const stone of s.stones) {
        stone.first = first;
        first += stone.home.length;
    }
    if (s.stones.length > kern.blocks || first > kern.vertices)
        throw Error(`more than ${kern.blocks} blocks or ${kern.vertices} ` +
                    "vertices are too many for this page");
    kern.begin(...s.gravity);
    s.stones.forEach((_, i) => putStone(i));
    setOptions();
}

function setOptions() {
    kern.options(s.mu, s.gap, s.angle, s.epsilon, s.error, s.errorTurn);
}

/* The contacts: how many points there are, or a status below zero. */
function findContacts() {
    if (!s.contacts.length) return kern.find(held);
    putStructure();
    for (const c of s.contacts) {
        const made = kern.contact(c.a, c.b, ...c.normal, ...c.p, ...c.q,
                                  c.mu ?? s.mu);
        if (made < 0)
            throw Error(`contact ${s.stones[c.a].name} ` +
                        `${s.stones[c.b].name}: ${statusText(made)}`);
    }
    return kern.given();
}

/* All stones that overlap, and the deepest two. */
function overlaps() {
    const found = kern.overlaps(), out = { stones: new Set(), depth: 0 };
    for (let k = 0; k < found; k++) {
        const [a, b, depth] = kern.overlap.subarray(3 * k, 3 * k + 3);
        out.stones.add(a).add(b);
        if (depth > out.depth) Object.assign(out, { a, b, depth });
    }
    return out;
}

/* Everything that the page shows; in a hurry without what costs most. A stone
   that is held rests, and touches nothing. */
function assess(shrink, hurry) {
    const found = findContacts();
    if (found === OVERLAP) return { overlap: overlaps() };
    if (found < 0) return { error: statusText(found) };
    const measured = kern.measure();
    if (measured < 0) return { error: statusText(measured) };
    const [margin, level, saturated, most, , size] = kern.answer;
    const out = { contacts: found, stands: measured === STANDS, margin, level,
                  saturated, most, epsilon: s.epsilon || 0.02 * size, loads: [],
                  critical: -1, motion: null };
    if (!saturated) takeMotion(out, margin, out.stands);
    for (const side of out.stands && !hurry ? [-1, 1] : [])
        out.loads.push(kern.load_factor(side) === STANDS ? kern.answer[0]
                                                         : NaN);
    const e = placingError();   // and e / size in angle
    if (!hurry && kern.narrowed(Math.tan(e / view.size) / (2 * e)) > 0)
        out.bears = kern.answer[0] / (2 * e);
    if (!hurry && !s.contacts.length)
        out.measured = { verdict: kern.measured(e),
                         certain: kern.answer[0] === 1 };
    if (!out.stands && !hurry && kern.deficit() === FALLS &&
        kern.answer[0] < Infinity)
        out.deficit = kern.answer[0];
    out.verdict = kern.verdict(shrink);
    if (out.verdict === FALLS) {
        kern.falls(shrink);     // every mechanism, not the first alone
        takeMotion(out, shrink, false);
    }
    if (out.verdict === STANDS && !hurry) kern.forces(shrink);
    return out;
}

/* What costs more, asked when nothing has changed for a while: the whole let go,
   the load factors of Coulomb friction, the live load, and whether the stone
   under the mouse, or else the chosen one, would stay. */
function enquire() {
    if (stale || !s) return;
    if (dragged) return land();
    const told = status => status !== STANDS ? NaN : kern.answer[0];
    const good = shown.stands && shown.verdict !== undefined;
    const stone = hovered >= 0 ? hovered : chosen;
    if (shown.verdict !== undefined && !shown.asked) {
        const alive = s.stones.some(stone => stone.lives.length);
        shown.asked = true;
        shown.letGo = letGo();
        if (alive)
            shown.live = [...kern.live_range() === STANDS
                ? kern.answer.slice(0, 2) : [NaN, NaN],
                          told(kern.raised_load(0))];
        if (good)
            shown.raisedLoads = [-1, 1].map(side =>
                told(kern.raised_load(side)));
        if (good && kern.raised() === STANDS)
            [shown.raising, shown.reserve] = kern.answer;
    }
    if (good && stone >= 0 && s.stones[stone] && !s.stones[stone].fixed)
        shown.stays = { stone, chance: told(kern.stays(stone)) };
    sayAsked();
}

/* The answer for all stones at once, and why it is none. */
function letGo() {
    const status = kern.let_go(), [how, end] = kern.answer;
    return status === STANDS ? "stays"
        : status === FALLS ? how === HANGS ? "moves: a part hangs" : "moves"
        : end === LOST ? "not shown: no equilibrium found"
        : "not shown: a limit ended the search";
}

function enquireSoon() {
    clearTimeout(enquire.timer);
    enquire.timer = setTimeout(enquire, dragged ? 60 : 200);
}

/* The mechanism that was just found, and what it hinges on. */
function takeMotion(out, at, stands) {
    out.critical = kern.critical(at, stands);
    out.motion = kern.motion.slice(0, 3 * s.stones.length);
    out.group = kern.group.slice(0, s.stones.length);
    out.meeting = kern.meeting.slice(0, out.contacts);
}

/* ==== The picture ======================================================= */

const FILLS = ["#e9e3d6", "#ddd5c5", "#e3dccf", "#d6cebf", "#e6dccb",
               "#dad6cc"];
const svg = $("picture"), stage = $("stage");
let view;                       // from the structure to the page

const px = x => view.x + view.scale * x;
const py = y => view.y - view.scale * y;
const at = (x, y) => `${px(x).toFixed(2)} ${py(y).toFixed(2)}`;

function make(parent, name, attributes) {
    const element = document.createElementNS(svg.namespaceURI, name);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    return parent.appendChild(element);
}

/* The free stones where they are, with room to move them. */
function fitView() {
    const free = s.stones.filter(stone => !stone.fixed);
    const points = free.flatMap(stone => stone.home.map(p => placed(stone, p)));
    const xs = points.map(p => p[0]), ys = points.map(p => p[1]);
    const low = [Math.min(...xs), Math.min(...ys)];
    const high = [Math.max(...xs), Math.max(...ys)];
    const size = free.reduce((sum, t) => sum + t.size, 0) / free.length;
    const box = stage.getBoundingClientRect();
    const width = Math.max(box.width, 200), height = Math.max(box.height, 200);
    const room = [high[0] - low[0] + 2.4 * size, high[1] - low[1] + 2.2 * size];
    const scale = Math.min(width / room[0], height / room[1], 160 / size);
    view = { scale, fitted: scale, size, width, height,
             x: width / 2 - scale * (low[0] + high[0]) / 2,
             y: height / 2 + scale * (low[1] + high[1] - 0.6 * size) / 2 };
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
}

function polygonArea(points) {
    return points.reduce((sum, p, i) => {
        const q = points[(i + 1) % points.length];
        return sum + (p[0] * q[1] - p[1] * q[0]) / 2;
    }, 0);
}

function makeStones() {
    $("stones").replaceChildren();
    $("names").replaceChildren();
    s.stones.forEach((stone, i) => {
        stone.size = stone.fixed ? 0
            : Math.sqrt(Math.abs(polygonArea(stone.home)));
        stone.group = make($("stones"), "g", {});
        stone.path = make(stone.group, "path", stone.fixed
            ? { class: "ground" }
            : { class: "stone", fill: FILLS[(i * 7 + (i / 5 | 0)) % 6],
                tabindex: 0, role: "button", "data-stone": i,
                "aria-label": `stone ${stone.name}` });
        stone.label = make($("names"), "text", { class: "name" });
        stone.label.textContent = stone.fixed ? "" : stone.name;
    });
    for (const stone of s.stones) // the ground lies behind everything
        if (stone.fixed) $("stones").prepend(stone.group);
}

function drawStone(stone) {
    stone.path.setAttribute("d", "M" + stone.home.map(p =>
        at(...placed(stone, p))).join("L") + "Z");
    stone.label.setAttribute("x", px(stone.centre[0]).toFixed(2));
    stone.label.setAttribute("y", (py(stone.centre[1]) + 4).toFixed(2));
    stone.label.style.display = stone.size * view.scale < 30 ? "none" : "";
}

/* Contact point k where it acts at a shrinkage, as kern_contact_at(). */
function acts(k, shrink) {
    const [, , , x, y, nx, ny, travel] = kern.point.subarray(8 * k, 8 * k + 8);
    const way = Math.max(-shrink, Math.min(shrink, travel));
    return [x - ny * way, y + nx * way];
}

/* Contacts of a line come in twos (1), others are points (0). */
function forEachContact(visit) {
    for (let k = 0; k < shown.contacts; k++) {
        const line = kern.point[8 * k + 2] !== 0 ? 1 : 0;
        visit(k, line);
        k += line;
    }
}

function drawContacts(shrink) {
    let whole = "", kerns = "", dots = "", limit = "";
    forEachContact((k, line) => {
        if (shown.critical === k || (line && shown.critical === k + 1))
            limit = `M${at(...acts(k, 0))}L${at(...acts(k + line, 0))}`;
        if (line) {
            whole += `M${at(...acts(k, 0))}L${at(...acts(k + 1, 0))}`;
            kerns += `M${at(...acts(k, shrink))}L${at(...acts(k + 1, shrink))}`;
        } else {
            dots += `M${at(...acts(k, shrink))}h.01`;
        }
    });
    $("limit").setAttribute("d", limit);
    $("whole").setAttribute("d", whole);
    $("kerns").setAttribute("d", kerns);
    $("dots").setAttribute("d", dots);
}

/* The force of a contact as the arrow of what the upper block weighs on the
   lower one: normal and tangential of both ends together, where they act. */
function drawForces(shrink) {
    const arrows = [], through = s.stones.map(() => []);
    for (let k = 0, n; k < shown.contacts; k = n) {
        let x = 0, y = 0, sum = 0, fx = 0, fy = 0;
        for (n = k; n < shown.contacts && [0, 1].every(
            e => kern.point[8 * n + e] === kern.point[8 * k + e]); n++) {
            const i = n;
            const [, , , , , nx, ny] = kern.point.subarray(8 * i, 8 * i + 8);
            const normal = kern.force[2 * i], along = kern.force[2 * i + 1];
            const p = acts(i, shrink);
            x += normal * p[0];
            y += normal * p[1];
            sum += normal;
            fx += normal * nx - along * ny;
            fy += normal * ny + along * nx;
        }
        if (!(sum > 0)) continue;
        const a = s.stones[kern.point[8 * k]];
        const b = s.stones[kern.point[8 * k + 1]];
        through[kern.point[8 * k]].push([x / sum, y / sum]);
        through[kern.point[8 * k + 1]].push([x / sum, y / sum]);
        const lifts = -(fx * s.gravity[0] + fy * s.gravity[1]);
        const sign = b.fixed || (lifts < 0 && !a.fixed) ? -1 : 1;
        arrows.push([x / sum, y / sum, sign * fx, sign * fy]);
    }
    drawArrows(arrows, "forces", "heads");
    $("thrust").setAttribute("d", through.map((ends, i) =>
        ends.length === 2 && !s.stones[i].fixed
            ? `M${at(...ends[0])}L${at(...ends[1])}` : "").join(""));
}

/* Loads push on their stone at the point where they act, in a scale of theirs;
   live loads in another. */
function drawLoads() {
    const arrows = ["loads", "lives"].flatMap(kind => {
        const all = s.stones.flatMap(stone => stone[kind].map(load =>
            [...placed(stone, load.at), ...load.force]));
        const most = Math.max(...all.map(a => Math.hypot(a[2], a[3])));
        return all.map(([x, y, fx, fy]) => [x, y, fx / most, fy / most]);
    });
    drawArrows(arrows, "loads-drawn", "load-heads", true);
}

/* Arrows (x, y, fx, fy) that begin at their point, or with `into` end there;
   the longest is .8 of a stone. */
function drawArrows(arrows, shaft, head, into) {
    const largest = Math.max(...arrows.map(a => Math.hypot(a[2], a[3])));
    const scale = 0.8 * view.size * view.scale / largest;
    let lines = "", heads = "";
    for (const [x, y, fx, fy] of arrows) {
        const length = Math.hypot(fx, fy) * scale;
        if (length < 3) continue;
        const ux = fx * scale / length, uy = -fy * scale / length;
        const head = Math.min(9, 0.6 * length);
        const from = into ? length : 0;
        const tx = px(x) + ux * (length - from), ty = py(y) + uy * (length - from);
        const bx = tx - ux * head, by = ty - uy * head, w = 0.36 * head;
        lines += `M${(px(x) - ux * from).toFixed(2)} ` +
            `${(py(y) - uy * from).toFixed(2)}` +
            `L${bx.toFixed(2)} ${by.toFixed(2)}`;
        heads += `M${tx.toFixed(2)} ${ty.toFixed(2)}` +
            `L${(bx - uy * w).toFixed(2)} ${(by + ux * w).toFixed(2)}` +
            `L${(bx + uy * w).toFixed(2)} ${(by - ux * w).toFixed(2)}Z`;
    }
    $(shaft).setAttribute("d", lines);
    $(head).setAttribute("d", heads);
}

/* Contact points about which the mechanism turns. */
function drawHinges(shrink) {
    let rings = "";
    shown.meeting?.forEach((what, k) => {
        if (what !== 1) return;
        const [x, y] = acts(k, shrink);
        rings += `M${(px(x) - 4).toFixed(2)} ${py(y).toFixed(2)}` +
            "a4 4 0 1 0 8 0a4 4 0 1 0 -8 0";
    });
    $("hinges").setAttribute("d", rings);
}

/* An arrow at the edge of the frame toward each stone that lies outside. */
function drawOutside() {
    let marks = "";
    for (const { fixed, centre: [x, y] } of s.stones) {
        const cx = Math.max(14, Math.min(view.width - 14, px(x)));
        const cy = Math.max(14, Math.min(view.height - 14, py(y)));
        if (fixed || (Math.abs(cx - px(x)) < 1 && Math.abs(cy - py(y)) < 1))
            continue;
        const way = Math.atan2(py(y) - cy, px(x) - cx);
        const tip = turn => `${(cx + 9 * Math.cos(way + turn)).toFixed(2)} ` +
            `${(cy + 9 * Math.sin(way + turn)).toFixed(2)}`;
        marks += `M${tip(2.4)}L${tip(0)}L${tip(-2.4)}`;
    }
    $("outside").setAttribute("d", marks);
}

/* Does stone i move in the mechanism that is shown? */
const moves = i => !!shown.motion && shown.group[i] >= 0;

function draw() {
    const by = shrink();
    s.stones.forEach((stone, i) => {
        drawStone(stone);
        if (stone.fixed) return;
        const list = stone.path.classList;
        list.toggle("deep", !!shown.overlap?.stones.has(i));
        list.toggle("moves", shown.verdict === FALLS && moves(i));
        list.toggle("chosen", i === chosen);
    });
    drawGhosts();
    const drawn = shown.contacts !== undefined;
    const kernsAt = by > 0 ? by : shown.stands ? shown.margin : 0;
    $("marks").style.display = drawn ? "" : "none";
    $("key-kern").textContent = by > 0 ? "shrunk contact"
        : "its kern at the margin";
    for (const id of ["limit", "whole", "kerns", "dots", "forces", "heads",
                      "thrust", "hinges"])
        $(id).setAttribute("d", "");
    drawLoads();
    drawOutside();
    if (drawn && wanted("show-motion")) drawHinges(kernsAt);
    if (drawn && wanted("show-kerns")) drawContacts(kernsAt);
    if (drawn && wanted("show-forces") && shown.verdict === STANDS)
        drawForces(by);
}

/* ---- The mechanism moves ---- */

/* Of what stands, outlines show where the stones would go. */
function drawGhosts() {
    const still = shown.verdict === FALLS;
    $("ghosts").replaceChildren();
    s.stones.forEach((stone, i) => {
        const moving = moves(i) && wanted("show-motion");
        stone.ghost = !moving ? null : still ? stone.group
            : make($("ghosts"), "path", { class: "ghost",
                                          d: stone.path.getAttribute("d") });
    });
}

const PERIOD = 3000;            // ms of an outline's way and back
const FALL = 700, LIE = 900;    // ms to fall by a stone's size, and to lie then
const FARTHEST = 10;            // stones that a fall is followed

/* What falls moves on until something catches it, lies there and begins again;
   the outlines of what stands go to and fro. */
function animate(now) {
    const idle = !shown.motion || dragged ||
        matchMedia("(prefers-reduced-motion: reduce)").matches;
    const falls = shown.verdict === FALLS && !idle;
    const phase = idle ? dragged ? 0 : 0.25 : (now % PERIOD) / PERIOD;
    const way = falls ? wayFallen(now)
        : 0.45 * (0.5 - 0.5 * Math.cos(2 * Math.PI * phase));
    const time = shown.motion && way * view.size / fastest();
    let moving = false;
    s.stones.forEach((stone, i) => {
        const itself = stone.ghost === stone.group;
        const way = stone.ghost ? movedBy(stone, ...movedTo(i, time)) : "";
        stone.group.setAttribute("transform", itself ? way : "");
        stone.label.setAttribute("transform", itself ? way : "");
        if (!stone.ghost) return;
        stone.ghost.setAttribute("transform", way);
        moving = !idle;
    });
    $("marks").style.opacity = moving && falls ? 0.25 : "";
    return moving;
}

/* How far the fastest corner has fallen by now, in stones. It begins to when
   the structure has not changed for a moment. */
function wayFallen(now) {
    shown.since ??= now;
    if (now - shown.since < 150) return 0;
    shown.caught ??= caughtAfter();
    const whole = FALL * Math.sqrt(shown.caught);
    const passed = (now - shown.since - 150) % (whole + LIE) / whole;
    return shown.caught * Math.min(1, passed * passed);
}

/* After which way, in stones, one that falls meets another. */
function caughtAfter() {
    const unit = view.size / fastest();
    const meets = way => {
        s.stones.forEach((stone, i) => {
            if (moves(i)) putMoved(i, way * unit);
        });
        return overlaps().depth > 0.06 * view.size;
    };
    let clear = 0, met = 0.1;
    while (met < FARTHEST && !meets(met)) [clear, met] = [met, met + 0.1];
    for (let n = 0; n < 5; n++) {
        const middle = (clear + met) / 2;
        if (meets(middle)) met = middle; else clear = middle;
    }
    putStructure();
    findContacts();
    return met;
}

function putMoved(i, time) {
    const stone = s.stones[i], [turn, dx, dy] = movedTo(i, time);
    const c = Math.cos(turn), q = Math.sin(turn), [x, y] = stone.centre;
    stone.home.forEach((p, k) => {
        const [u, v] = placed(stone, p);
        kern.vertex.set([x + dx + c * (u - x) - q * (v - y),
                         y + dy + q * (u - x) + c * (v - y)],
                        2 * (stone.first + k));
    });
    kern.block(i, stone.first, stone.home.length, stone.density);
}

/* By which angle, and where to, stone i has moved then: at constant speed and
   spin as seen from itself, so that one that hinges turns about its hinge. */
function movedTo(i, time) {
    const [vx, vy, spin] = shown.motion.subarray(3 * i, 3 * i + 3);
    const turn = spin * time, c = Math.cos(turn), q = Math.sin(turn);
    const even = Math.abs(turn) < 1e-4 ? 1 : q / turn;
    const odd = Math.abs(turn) < 1e-4 ? turn / 2 : (1 - c) / turn;
    return [turn, (even * vx - odd * vy) * time, (odd * vx + even * vy) * time];
}

function movedBy(stone, turn, right, up) {
    const c = Math.cos(turn), q = Math.sin(turn);
    const dx = right * view.scale, dy = -up * view.scale;
    const x = px(stone.centre[0]), y = py(stone.centre[1]);
    return `matrix(${c} ${-q} ${q} ${c} ${x + dx - c * x - q * y} ` +
        `${y + dy + q * x - c * y})`;
}

/* The largest speed of a corner in the mechanism, about. */
function fastest() {
    const m = shown.motion;
    return Math.max(...s.stones.map((stone, i) => Math.hypot(
        m[3 * i], m[3 * i + 1]) + Math.abs(m[3 * i + 2]) * stone.size));
}

/* ==== Words ============================================================= */

function listOf(names) {
    return names.length > 6 ? names.slice(0, 6).join(", ") +
        ` and ${names.length - 6} more` : names.join(", ")
        .replace(/, ([^,]*)$/, " and $1");
}

const digits = x => Number(x.toPrecision(4)).toString();

/* Stones that no contact reaches. */
function alone() {
    const reached = new Set();
    for (let k = 0; k < 8 * shown.contacts; k++)
        if (k % 8 < 2) reached.add(kern.point[k]);
    const names = s.stones.filter((stone, i) =>
        !stone.fixed && !reached.has(i)).map(stone => stone.name);
    return names.length ? ` Nothing touches ${listOf(names)}.` : "";
}

/* The verdict in a word, and why. */
function words() {
    const kind = shown.verdict === STANDS ? "stands"
        : shown.verdict === FALLS ? "falls" : "unsure";
    const moving = shown.motion ? s.stones.filter((_, i) => moves(i)) : [];
    const names = listOf(moving.map(stone => stone.name));
    const most = shown.most || 1;
    let head = "undecided", why = shown.error || "";
    if (shown.overlap) {
        const { a, b, depth } = shown.overlap;
        head = "overlap";
        why = `${s.stones[a].name} and ${s.stones[b].name} overlap, ` +
            `${digits(depth)} deep: there is no verdict.`;
    } else if (kind === "stands") {
        head = shown.margin > 0 ? "stands" : "stands, but is critical";
        why = shown.saturated ? "Even where every contact is a point."
            : `Past the margin ${names} would fall.`;
    } else if (kind === "falls") {
        head = "falls";
        why = `Nothing holds ${names} up.${alone()}`;
        if (shown.deficit > 0)
            why += ` Contacts ${digits(shown.deficit)} longer at each end ` +
                "would.";
    }
    if (held >= 0 && shown.verdict !== undefined)
        head += ` without ${s.stones[held].name}`;
    if (shrink() > 0 && shown.verdict > 0)
        why = `With contacts shrunk by ${digits(shrink())}. ${why}`;
    return { kind, head, why };
}

/* ==== Moving stones ===================================================== */

let chosen = -1;                // stone with the focus, -1: none
let dragged = null;             // while a pointer holds it
let held = -1;                  // the dragged stone while it is in the air
let hovered = -1;               // stone under the mouse

/* The slider goes to where the widest kern is closed. */
const shrinkUnit = () => shown?.most || view.size / 2;
const shrink = () => Number($("shrink").value) * shrinkUnit();

/* Moves stone i up or down, by at most `reach`, to where it touches what is
   above or below it: the middle of the places that count as touching. */
const OVERLAPS = 0, IS_FREE = 1, TOUCHES = 2;

function stateAt(i, y) {
    s.stones[i].y = y;
    putStone(i);
    const rests = kern.rests(i);
    return rests < 0 ? OVERLAPS : rests > 0 ? TOUCHES : IS_FREE;
}

/* The last y from `inside` toward `outside` of whose state `holds` is true. */
function lastWhere(i, inside, outside, holds) {
    for (let n = 0; n < 32; n++) {
        const middle = (inside + outside) / 2;
        if (holds(stateAt(i, middle))) inside = middle;
        else outside = middle;
    }
    return inside;
}

function rest(i, reach) {
    const start = s.stones[i].y, steps = 12, first = stateAt(i, start);
    if (first === TOUCHES) return;
    const step = (first === OVERLAPS ? 1 : -1) * reach / steps;
    for (let k = 1; k <= steps; k++) {
        if (stateAt(i, start + k * step) === first) continue;
        const beyond = first === OVERLAPS ? IS_FREE : OVERLAPS;
        const begin = lastWhere(i, start + (k - 1) * step, start + k * step,
                                state => state === first);
        const end = lastWhere(i, begin, begin + step,
                              state => state !== beyond);
        stateAt(i, (begin + end) / 2);
        return;
    }
    stateAt(i, start);
}

function moveStone(i, x, y, turn, comesToRest) {
    const stone = s.stones[i];
    if (s.contacts.length) return;
    Object.assign(stone, { x, y, turn });
    putStone(i);
    if (comesToRest && wanted("snap")) rest(i, 0.15 * stone.size);
}

/* ---- let down ---- */

/* Stone i comes down where it is, until no way leads down: kern_rest(). What
   lies above it does not stop it. */
function settle(i) {
    const stone = s.stones[i];
    putStone(i);                // no longer held
    if (kern.rest(i, 0.5 * stone.size) !== RESTS) return;
    const [x, y, cosine, sine] = kern.answer;
    stone.turn += Math.atan2(sine, cosine);
    putStone(i);                // turned about its pivot: shift it
    stone.x += x - stone.centre[0];
    stone.y += y - stone.centre[1];
    putStone(i);
    rest(i, 0.05 * stone.size);
}

/* Shows where the stone in the hand would come to rest, and how likely it stays
   there, as a colour from red to green. */
function land() {
    if (held < 0) return;
    const stone = s.stones[held], { x, y, turn } = stone, i = held;
    settle(i);
    const outline = stone.home.map(p => placed(stone, p));
    const chance = kern.find(-1) >= 0 && kern.stays(i) === STANDS
        ? kern.answer[0] : 0;
    Object.assign(stone, { x, y, turn });
    putStone(i);
    kern.find(i);
    showLanding(outline, chance, stone.name);
}

function showLanding(outline, chance) {
    const path = $("landing"), word = $("chance");
    path.style.display = word.style.display = outline ? "" : "none";
    if (!outline) return;
    const colour = `hsl(${Math.round(120 * chance)} 60% 38%)`;
    path.setAttribute("d", "M" + outline.map(p => at(...p)).join("L") + "Z");
    path.setAttribute("style", `fill: ${colour}; stroke: ${colour}`);
    const xs = outline.map(p => p[0]), ys = outline.map(p => p[1]);
    word.setAttribute("x", px((Math.min(...xs) + Math.max(...xs)) / 2));
    word.setAttribute("y", py(Math.max(...ys)) - 6);
    word.textContent = chance > 0 ? `stays: ${Math.round(100 * chance)} %`
        : "does not stay";
}

/* ---- add, take away, undo ---- */

let past = [];                  // stones as they were before each change

function remember() {
    past.push(s.stones.map(stone => ({ ...stone })));
    past = past.slice(-100);
}

function setStones(stones) {
    const name = s.stones[chosen]?.name;
    s.stones = stones;
    makeStones();
    putStructure();
    chosen = stones.findIndex(stone => stone.name === name);
    change();
}

function undo() {
    if (past.length) setStones(past.pop());
}

/* One more stone like the chosen one, or like the last, above everything. */
function add() {
    const like = s.stones[chosen]?.fixed === false ? s.stones[chosen]
        : s.stones.findLast(stone => !stone.fixed);
    const top = Math.max(...s.stones.flatMap(
        stone => stone.home.map(p => placed(stone, p)[1])));
    const low = Math.min(...like.home.map(p => placed(like, p)[1]));
    let n = 1;
    while (s.stones.some(stone => stone.name === `new${n}`)) n++;
    const stone = { ...like, name: `new${n}`, loads: [], lives: [],
                    weights: [], torque: 0, pivot: null,
                    home: like.home.map(p => placed(like, p)),
                    com: like.com && placed(like, like.com),
                    x: 0, y: top - low + 0.2 * like.size, turn: 0 };
    setStones([...s.stones, stone]);
    chosen = s.stones.length - 1;
}

function takeAway(i) {
    if (s.stones.filter(stone => !stone.fixed).length > 1)
        setStones(s.stones.filter((_, k) => k !== i));
}

function choose(i) {
    if (i === chosen) return;
    chosen = i;
    change();
}

/* A step by key: sideways and in angle it stays on what carries it. */
function press(key, fine) {
    const stone = s.stones[chosen];
    if (s.contacts.length || !(stone || key === "Insert")) return false;
    remember();
    const step = (fine ? 0.001 : 0.01) * stone.size;
    const angle = (fine ? 0.1 : 1) * Math.PI / 180;
    const { x, y, turn } = stone;
    switch (key) {
    case "ArrowLeft": moveStone(chosen, x - step, y, turn, true); break;
    case "ArrowRight": moveStone(chosen, x + step, y, turn, true); break;
    case "ArrowUp": moveStone(chosen, x, y + step, turn, false); break;
    case "ArrowDown": moveStone(chosen, x, y - step, turn, false); break;
    case "q": case "Q": moveStone(chosen, x, y, turn + angle, true); break;
    case "e": case "E": moveStone(chosen, x, y, turn - angle, true); break;
    case "Home": moveStone(chosen, 0, 0, 0, false); break;
    case "s": case "S": settle(chosen); break;
    case "Insert": add(); break;
    case "Delete": takeAway(chosen); break;
    default: past.pop(); return false;
    }
    change();
    return true;
}

const stoneOfEvent = event =>
    Number(event.target.closest?.("[data-stone]")?.dataset.stone ?? -1);

svg.addEventListener("pointerdown", event => {
    const i = stoneOfEvent(event);
    if (i < 0 || event.button > 0) return;
    const { x, y } = s.stones[i];
    remember();
    dragged = { i, x, y, left: event.clientX, top: event.clientY,
                pointer: event.pointerId };
});

svg.addEventListener("pointermove", event => {
    const i = stoneOfEvent(event);
    if (i !== hovered) enquireSoon();
    hovered = i;
});

addEventListener("pointermove", event => {
    if (dragged?.pointer !== event.pointerId) return;
    const scale = view.scale * svg.clientWidth / view.width;
    dragged.to = [dragged.x + (event.clientX - dragged.left) / scale,
                  dragged.y - (event.clientY - dragged.top) / scale];
    change();
});

for (const type of ["pointerup", "pointercancel"])
    addEventListener(type, event => {
        if (dragged?.pointer !== event.pointerId) return;
        if (stale) refresh();
        putStone(dragged.i);    // no longer held
        if (dragged.to && wanted("snap") && !s.contacts.length &&
            stateAt(dragged.i, s.stones[dragged.i].y) !== TOUCHES)
            settle(dragged.i);
        dragged = null;
        change();
    });

svg.addEventListener("focusin", event => choose(stoneOfEvent(event)));
svg.addEventListener("keydown", event => {
    if (press(event.key, event.shiftKey)) event.preventDefault();
});
/* ---- zoom and pan ---- */

let panned = null;              // while a mouse holds the background

/* The point under the mouse stays where it is. */
svg.addEventListener("wheel", event => {
    if (dragged) return;
    event.preventDefault();
    const box = svg.getBoundingClientRect();
    const x = event.clientX - box.left, y = event.clientY - box.top;
    const to = view.scale * Math.exp(
        -0.0015 * Math.max(-300, Math.min(300, event.deltaY)));
    const scale = Math.max(view.fitted / 10,
                           Math.min(50 * view.fitted, to));
    view.x = x + (view.x - x) * scale / view.scale;
    view.y = y + (view.y - y) * scale / view.scale;
    view.scale = scale;
    change();
}, { passive: false });

/* A finger on the background scrolls the page instead. */
svg.addEventListener("pointerdown", event => {
    if (stoneOfEvent(event) >= 0 || event.button > 0 ||
        event.pointerType === "touch") return;
    panned = { pointer: event.pointerId, x: view.x - event.clientX,
               y: view.y - event.clientY };
});

addEventListener("pointermove", event => {
    if (panned?.pointer !== event.pointerId) return;
    view.x = panned.x + event.clientX;
    view.y = panned.y + event.clientY;
    change();
});

for (const type of ["pointerup", "pointercancel"])
    addEventListener(type, event => {
        if (panned?.pointer === event.pointerId) panned = null;
    });

/* ==== Frames ============================================================ */

let stale = false, waiting = false;
let took = 0;                   // ms of the last look at the structure at rest

function change() {
    stale = true;
    ask();
}

function ask() {
    if (!waiting) requestAnimationFrame(frame);
    waiting = true;
}

function refresh() {
    stale = false;
    held = -1;
    if (dragged?.to) {
        moveStone(dragged.i, ...dragged.to, s.stones[dragged.i].turn, true);
        if (!s.contacts.length && kern.rests(dragged.i) === 0 &&
            s.stones.filter(stone => !stone.fixed).length > 1)
            held = dragged.i;
    }
    const begun = performance.now(), hurry = dragged && took > 5;
    try {
        shown = assess(shrink(), hurry);
    } catch (error) {
        shown = { error: error.message };
    }
    if (!hurry) took = performance.now() - begun;
    showLanding(null);
    draw();
    say();
}

function frame(now) {
    waiting = false;
    if (stale) refresh();
    if (animate(now)) ask();
}

/* Begins with the structure that the library has now. */
function begin() {
    past = [];
    chosen = -1;
    dragged = shown = null;
    $("shrink").value = 0;
    makeStones();
    fitView();
    refresh();
    ask();
}
