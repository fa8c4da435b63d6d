"""kern.h for Python: how safely does a dry-stacked structure stand?

    >>> ground = Block("ground", [(-5, -1), (5, -1), (5, 0), (-5, 0)],
    ...                fixed=True)
    >>> stone = Block("stone", [(0, 0), (2, 0), (2, 1), (0, 1)], density=2400)
    >>> wall = Structure([ground, stone])
    >>> wall.measure()
    Margin(stands=True, margin=1.0, level=37, saturated=True)

kern needs the standard library alone, and uses numpy where it is installed. The
first import compiles kern.h with `cc` (or $CC) into the user's cache; later
imports load the library from there. `pip install ./examples/python` compiles it
once and installs it with this file. A symbolic link to this file works as well.
A copy elsewhere needs the variable KERN_LIBRARY: the path of a library that
`python3 kern.py --build FILE` wrote.

Structures
    Block(name, vertices, ...) is a stone, or ground with fixed=True.
    Structure(blocks, options=Options(mu=0.6)) finds the contacts between them.
    read(path), parse(text), from_labelme(page) and from_coco(page) read files,
    drawings and photographs. wall.save(path) writes a file.
    wall["s3"] is a block; wall.move("s3", 0.1, 0) moves it.

Methods of a structure
    verdict()                does it stand?
    let_go(), stays(block)   does it, or a block, stay where it is released?
    measure()                margin: how far may every contact shrink?
    load_factor(side), raised_load(side), tilt(side), live(loads)
                             how much load?
    profile(), critical(), sensitivity()
                             which block, which contact, and why?
    interval()               how certain is the margin of measured stones?
    svg(), plot(ax)          how does it look?

    An answer is true where the structure stands. Its `forces` and `motion` are
    the proof, which check_forces() and check_motion() check once more.
    as_dict() returns its numbers by name.

Many structures
    Plan(blocks) tries one more block: try_(), bears(), try_stays(), places().
    many(wall, poses=...) answers for arrays of structures, in C, on all
    processors.

Units are metres, kilograms, newtons and radians; y points up and gravity is
(0, -9.81). Other consistent units work as well. A density is the mass of a
square metre. An array has rows, shape, [i, j] and tolist(), with numpy or
without. Bad input raises KernError, a ValueError that names the blocks. A word
where a number belongs raises TypeError.

Each Structure and Plan has its own copies of the blocks and its own memory, and
answers one thread at a time. Blocks, structures, plans, answers and errors can
be pickled and copied.

SPDX-License-Identifier: MIT
"""
# The classes of this file share private names: they are private to the file.
# pyright: reportPrivateUsage=false

from __future__ import annotations

import ctypes
import enum
import functools
import hashlib
import importlib
import json
import math
import operator
import os
import pathlib
import re
import reprlib
import subprocess
import sys
import tempfile
import threading
import warnings
from array import array as _array
from concurrent.futures import ThreadPoolExecutor
from ctypes import (POINTER, addressof, byref, c_char_p, c_double, c_int,
                    c_void_p)
from dataclasses import dataclass, field, fields
from itertools import chain
from typing import (Any, Callable, Dict, Iterable, Iterator, List,
                    NamedTuple, Optional, Protocol, Sequence, Tuple, TypeVar,
                    Union, cast)

try:
    numpy: Any = importlib.import_module("numpy")
except ImportError:
    numpy = None

if os.name != "posix":
    raise ImportError("kern.py: compiles kern.h with cc, so it needs a POSIX "
                      "system (Linux, macOS, WSL)")

__version__ = "0.2.0"
__all__ = [
    "LEFT", "SHRINK", "RIGHT", "Side", "Status", "KernError", "Options", "Body",
    "Block", "Contact", "contact_make", "contact_travels", "work_need",
    "Verdict", "Raising", "End", "Raised", "LetGo", "Margin", "Factor",
    "Interval", "Profile", "Critical", "ContactRate", "BlockRate", "Solution",
    "Structure", "Plan", "Place", "overlaps", "example", "Many", "many",
    "Array", "Rows", "parse", "read", "from_labelme", "from_coco",
    "DrawingWarning", "simplified", "lp_solve", "status_text", "build",
]


def __dir__() -> List[str]:
    """Lists what is for users, without the names that the module imports."""
    return sorted(__all__)


Point = Tuple[float, float]


class Side(enum.IntEnum):
    """A side of load_factor(), raised_load(), tilt() and profile()."""
    LEFT = -1
    SHRINK = 0  # neither: contacts shrink
    RIGHT = 1


LEFT, SHRINK, RIGHT = Side.LEFT, Side.SHRINK, Side.RIGHT

# ---- Structures of the headers ----------------------------------------------


class _Vec(ctypes.Structure):
    _fields_ = [("x", c_double), ("y", c_double)]


class _Box(ctypes.Structure):
    _fields_ = [("low", _Vec), ("high", _Vec)]


class _Fault(ctypes.Structure):
    _fields_ = [("block", c_int), ("other", c_int), ("index", c_int),
                ("value", c_double), ("allowed", c_double)]


class _Overlap(ctypes.Structure):
    _fields_ = [("a", c_int), ("b", c_int), ("depth", c_double),
                ("allowed", c_double)]


class _Wrench(ctypes.Structure):
    _fields_ = [("fx", c_double), ("fy", c_double), ("torque", c_double)]


class _Block(ctypes.Structure):
    _fields_ = [("vertex", c_void_p), ("vertices", c_int), ("fixed", c_int),
                ("area", c_double), ("box", _Box), ("mass", c_double),
                ("centre", _Vec), ("load", _Wrench)]


class _Contact(ctypes.Structure):
    _fields_ = [("a", c_int), ("b", c_int), ("line", c_int), ("p", _Vec),
                ("n", _Vec), ("mu", c_double), ("travel", c_double)]


class _Structure(ctypes.Structure):
    _fields_ = [("block", c_void_p), ("blocks", c_int), ("contact", c_void_p),
                ("contacts", c_int), ("gravity", _Vec)]


class _Options(ctypes.Structure):
    _fields_ = [("mu", c_double), ("gap", c_double), ("angle", c_double),
                ("epsilon", c_double), ("relative", c_int), ("limit", c_int),
                ("overlap", c_double), ("pose_error", c_double),
                ("pose_turn", c_double), ("narrow", c_double),
                ("reserve", c_double), ("lone", _Vec)]


class _Force(ctypes.Structure):
    _fields_ = [("normal", c_double), ("tangential", c_double)]


class _Motion(ctypes.Structure):
    _fields_ = [("vx", c_double), ("vy", c_double), ("spin", c_double)]


class _Proof(ctypes.Structure):
    _fields_ = [("force", c_void_p), ("motion", c_void_p)]


class _Margin(ctypes.Structure):
    _fields_ = [("margin", c_double), ("holds", c_double), ("fails", c_double),
                ("most", c_double), ("epsilon", c_double), ("level", c_int),
                ("saturated", c_int)]


class _Interval(ctypes.Structure):
    _fields_ = [("low", c_double), ("high", c_double), ("settles", c_double)]


class _Collapse(ctypes.Structure):
    _fields_ = [("least", c_double), ("mean", c_double), ("weak", c_double),
                ("drop", c_double)]


class _Critical(ctypes.Structure):
    _fields_ = [("meeting", c_void_p), ("limit", c_void_p),
                ("group", c_void_p), ("contact", c_int), ("groups", c_int)]


class _ContactRate(ctypes.Structure):
    _fields_ = [("p", _Vec), ("turn", c_double), ("mu", c_double),
                ("travel", c_double)]


class _BlockRate(ctypes.Structure):
    _fields_ = [("centre", _Vec), ("place", _Vec), ("turn", c_double),
                ("mass", c_double), ("load", _Wrench)]


class _Work(ctypes.Structure):
    _fields_ = [("real", c_void_p), ("reals", c_int), ("index", c_void_p),
                ("indices", c_int), ("pivots", c_int), ("solves", c_int),
                ("units", c_int), ("error", c_double), ("fault", _Fault),
                ("end", c_int)]


class _Known(ctypes.Structure):
    _fields_ = [("motion", c_void_p), ("force", c_void_p), ("holds", c_double),
                ("margin", c_double), ("fails", c_double)]


class _Task(ctypes.Structure):
    _fields_ = [("s", _Structure), ("options", _Options), ("work", c_void_p),
                ("known", _Known)]


class _Plan(ctypes.Structure):
    _fields_ = [("task", _Task), ("block", c_void_p), ("block_room", c_int),
                ("contact", c_void_p), ("contact_room", c_int)]


class _Pose(ctypes.Structure):
    _fields_ = [("block", _Block), ("turn", _Vec), ("motions", c_int)]


class _Place(ctypes.Structure):
    _fields_ = [("stays", c_double), ("margin", c_double), ("own", c_double),
                ("load", c_double), ("x", c_double), ("turn", c_double)]


class _Lp(ctypes.Structure):
    _fields_ = [("rows", c_int), ("cols", c_int), ("a", c_void_p),
                ("rhs", c_void_p), ("cost", c_void_p), ("limit", c_int)]


class _Live(ctypes.Structure):
    _fields_ = [("block", c_int), ("force", _Vec), ("place", _Vec)]


class _Text(ctypes.Structure):
    _fields_ = [("block", POINTER(_Block)), ("name", POINTER(c_char_p)),
                ("block_line", c_void_p), ("blocks", c_int), ("fixed", c_int),
                ("given", c_int), ("contact", POINTER(_Contact)),
                ("beside", c_double), ("own_mu", c_void_p),
                ("contacts", c_int), ("live", c_void_p),
                ("lives", c_int), ("loads", c_int), ("axle", POINTER(_Live)),
                ("mass", c_void_p), ("masses", c_int), ("added", c_double),
                ("added_x", c_double), ("added_y", c_double), ("gravity", _Vec),
                ("options", _Options), ("epsilon_line", c_int),
                ("error", c_double), ("turn", c_double), ("units", c_char_p),
                ("line", c_int), ("message", ctypes.c_char * 512),
                ("text", c_void_p), ("vertex", c_void_p), ("wheel", c_void_p),
                ("soil", c_void_p), ("wheels", c_int), ("soils", c_int),
                ("spread", c_int), ("props", c_int), ("found", c_int),
                ("bond", c_double), ("strength", c_double),
                ("force_units", c_char_p), ("prop_vertex", c_void_p),
                ("prop_name", c_void_p)]


class _Cases(ctypes.Structure):
    _fields_ = [(name, c_void_p) for name in (
        "wall", "options", "density", "own", "pose", "mu", "stone", "status",
        "level", "margin", "load", "motion")]


class _Asked(ctypes.Structure):
    _fields_ = [("layer", c_void_p), ("layers", c_int),
                ("densities", c_void_p), ("density_words", c_int),
                ("has_ground", c_int), ("ground", c_double),
                ("pixel", c_double), ("tolerance", c_double),
                ("image", c_char_p), ("frictions", c_void_p),
                ("friction_words", c_int), ("phi", c_double)]


_LAYOUTS = {
    "kern_vec": _Vec, "kern_box": _Box, "kern_fault": _Fault,
    "kern_overlap": _Overlap,
    "kern_wrench": _Wrench, "kern_block": _Block, "kern_contact": _Contact,
    "kern_structure": _Structure, "kern_options": _Options,
    "kern_force": _Force, "kern_motion": _Motion, "kern_proof": _Proof,
    "kern_margin": _Margin, "kern_interval": _Interval,
    "kern_collapse": _Collapse, "kern_work": _Work,
    "kern_contact_rate": _ContactRate, "kern_block_rate": _BlockRate,
    "kern_critical": _Critical, "kern_known": _Known, "kern_task": _Task,
    "kern_plan": _Plan, "kern_pose": _Pose, "kern_place": _Place,
    "kern_lp": _Lp, "struct text_live": _Live,
    "struct text_file": _Text, "struct shapes_asked": _Asked,
    "struct many": _Cases,
}

# ---- The library ------------------------------------------------------------

_ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
_HEADERS = ("kern.h", "kern_lp.h", "examples/python/many.h", *(
    "examples/parts/%s.h" % part for part in (
    "draw", "drawing", "dxf", "falls", "image", "lines", "outlines", "png",
    "room", "shapes", "soil", "statements", "svg", "text", "tokens", "words")))
_FLAGS = ("-O2", "-ffp-contract=off", "-shared", "-fPIC", "-I%s" % _ROOT)


def _source() -> str:
    """The C file of the library: the headers, what they keep static, and
    tables of their statuses, sizes and offsets."""
    layout: List[str] = []
    for name, mirror in _LAYOUTS.items():
        layout.append("SIZE(%s)" % name)
        for part, *_ in mirror._fields_:
            layout.append("FIELD(%s, %s)" % (name, part))
    return """
#define KERN_IMPLEMENTATION
#include "kern.h"
#include "examples/parts/draw.h"
#include "examples/parts/text.h"
#include "examples/parts/drawing.h"
#include "examples/parts/room.h"
#include "examples/python/many.h"
#include <stddef.h>
#define ROW(name, value, text) #name " " #value " "
#define SIZE(type) (int)sizeof(type),
#define FIELD(type, f) (int)offsetof(type, f), (int)sizeof(((type *)0)->f),
const char *kern_py_statuses(void) { return KERN_STATUS_LIST(ROW); }
const int kern_py_layout[] = {
%s
};
const int kern_py_layouts = sizeof kern_py_layout / sizeof(int);
int kern_py_read(struct text_file *t, const char *data, size_t length)
{ return text_read(t, data, length); }
void kern_py_free(struct text_file *t) { text_free(t); }
void kern_py_falls(const kern_task *task, double shrink, kern_motion *motion)
{ room_falls(task, shrink, motion); }
int kern_py_many(const struct many *m, int first, int end)
{ return many_run(m, first, end); }
struct drawing *kern_py_drawing_new(void)
{ return calloc(1, sizeof(struct drawing)); }
int kern_py_drawing_parse(struct text_file *t, struct drawing *d,
                          const char *name, const char *data, size_t length,
                          const struct shapes_asked *asked)
{ return drawing_parse(t, d, name, data, length, asked); }
const char *kern_py_drawing_notes(const struct drawing *d)
{ return d->s.notes.at ? d->s.notes.at : ""; }
int kern_py_drawing_skips(const struct drawing *d) { return d->s.skips; }
void kern_py_drawing_skip(const struct drawing *d, int i, const char **row,
                          int *line, int *count)
{
    const struct shapes_skip *k = d->s.skip + i;
    row[0] = shapes_at(&d->s, k->kind);
    row[1] = shapes_at(&d->s, k->label);
    *line = k->line;
    *count = k->count;
}
void kern_py_drawing_free(struct drawing *d) { drawing_free(d); free(d); }
int kern_py_draw(const char *path, const kern_structure *s, char *const *names,
                 int relative, double shrink, const kern_force *force,
                 const char *force_name, const kern_motion *motion,
                 const kern_motion *hinges, double hinged,
                 const char *motion_name, int limiting,
                 const kern_real *value, double most, const char *caption,
                 const kern_wrench *live)
{
    FILE *out = fopen(path, "wb");
    struct draw_scene scene = { 0 };
    int bad;
    scene.s = s;
    scene.names = names;
    scene.relative = relative;
    scene.shrink = shrink;
    scene.force = force;
    scene.force_name = force_name;
    scene.motion = motion;
    scene.motion_name = motion_name;
    scene.hinges = hinges;
    scene.hinged = hinged;
    scene.limiting = limiting;
    scene.value = value;
    scene.most = most;
    scene.value_name = "margin of a stone";
    scene.caption = caption;
    scene.live = live;
    bad = !out || draw_svg(out, &scene);
    return (out && fclose(out)) || bad;
}
""" % "\n".join(layout)


def build(path: Union[str, os.PathLike[str]]) -> None:
    """Compiles the library and writes it to a file. Raises ImportError."""
    target = pathlib.Path(path).resolve()
    with tempfile.TemporaryDirectory(dir=target.parent) as folder:
        source, made = (pathlib.Path(folder, name) for name in ("k.c", "k.so"))
        source.write_text(_source())
        command = [*os.environ.get("CC", "cc").split(), *_FLAGS, str(source),
                   "-o", str(made), "-lm"]
        try:
            subprocess.run(command, check=True, capture_output=True, text=True)
        except (OSError, subprocess.CalledProcessError) as error:
            raise ImportError("kern.h could not be compiled: %s\n%s" % (
                " ".join(command), getattr(error, "stderr", error)
            )) from None
        os.replace(made, target)


def _cached() -> pathlib.Path:
    """The library of these headers and flags, built where it is missing."""
    key = hashlib.sha256(repr((_source(), _FLAGS, os.environ.get("CC"),
                               sys.platform, os.uname().machine)).encode())
    try:
        for name in _HEADERS:
            key.update((_ROOT / name).read_bytes())
    except OSError as error:
        raise ImportError("%s, and KERN_LIBRARY names no library"
                          % error) from None
    cache = os.environ.get("XDG_CACHE_HOME") or "~/.cache"
    folder = pathlib.Path(cache, "kern").expanduser()
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ImportError("%s: the library has no place; set XDG_CACHE_HOME, or "
                          "KERN_LIBRARY" % error) from None
    path = folder / ("kern-%s.so" % key.hexdigest()[:16])
    if not path.exists():
        build(path)
    return path


def _load() -> ctypes.CDLL:
    """Loads the library and compares its layouts with the classes above."""
    beside = pathlib.Path(__file__).resolve().with_name("kern_library.so")
    path = os.environ.get("KERN_LIBRARY") or str(
        beside if beside.exists() else _cached())
    lib = ctypes.CDLL(path)
    try:
        entries = c_int.in_dll(lib, "kern_py_layouts").value
    except ValueError:
        raise ImportError("%s was not built by kern.py --build"
                          % path) from None
    table = list((c_int * entries).in_dll(lib, "kern_py_layout"))
    for name, mirror in _LAYOUTS.items():
        want = [ctypes.sizeof(mirror)]
        for part, kind in mirror._fields_:  # type: ignore
            want += [getattr(mirror, part).offset, ctypes.sizeof(kind)]
        if table[:len(want)] != want:
            raise ImportError("%s: %s has another layout than in kern.py"
                              % (path, name))
        del table[:len(want)]
    return lib


def _declare(name: str, result: Any, *arguments: Any) -> Any:
    function = getattr(_lib, name)
    function.restype, function.argtypes = result, arguments
    return function


_lib = _load()
_p, _r, _i = c_void_p, c_double, c_int
_status_text = _declare("kern_status_text", c_char_p, _i)
_defaults = _declare("kern_defaults", _Options)
_near = _declare("kern_near", _Options, _p, _r)
_measured = _declare("kern_measured_options", _Options, _p, _r, _r)
_work_need = _declare("kern_work_need", None, _i, _i, _p, _p)
_block_init = _declare("kern_block_init", _i, _p, _p, _i, _r, _p)
_ground_init = _declare("kern_ground_init", _i, _p, _p, _i, _p)
_block_load = _declare("kern_block_load", None, _p, _Vec, _Vec, _r)
_mean_size = _declare("kern_mean_size", _r, _p, _i)
_outline_simplify = _declare("kern_outline_simplify", _i, _p, _i, _r, _p, _p,
                             _i)
_contacts = _declare("kern_contacts", _i, _p, _i, _p, _p, _i, _p)
_overlaps = _declare("kern_overlaps", _i, _p, _i, _p, _p, _i, _p)
_certain = _declare("kern_certain", _i, _p, _r, _p, _p, _i)
_stretches = _declare("kern_stretches", _i, _p, _i, _p, _p, _i, _p)
_touch = _declare("kern_touch", _i, _p, _i, _p, _p, _i, _p)
_contact_make = _declare("kern_contact_make", _i, _p, _Vec, _p)
_contact_travels = _declare("kern_contact_travels", None, _p, _i)
_contact_at = _declare("kern_contact_at", _Vec, _p, _r, _i)
_task_of = _declare("kern_task_of", _Task, _p, _i, _p, _i, _p)
_verdict = _declare("kern_verdict", _i, _p, _r, _p)
_raised = _declare("kern_raised", _i, _p, _r, _p, _p, _p)
_let_go = _declare("kern_let_go", _i, _p, _p, _p)
_stays = _declare("kern_stays", _i, _p, _i, _p)
_least_forces = _declare("kern_forces", _i, _p, _r, _p)
_measure = _declare("kern_measure", _i, _p, _p, _p)
_deficit = _declare("kern_deficit", _i, _p, _p)
_bearing = _declare("kern_bearing", _i, _p, _p, _p)
_load_factor = _declare("kern_load_factor", _i, _p, _r, _i, _p, _p)
_load_factor_of = _declare("kern_load_factor_of", _i, _p, _r, _p, _p, _p)
_least_load_of = _declare("kern_least_load_of", _i, _p, _r, _p, _p, _p)
_raised_load = _declare("kern_raised_load", _i, _p, _r, _i, _p, _p, _p)
_tilt = _declare("kern_tilt", _i, _p, _r, _i, _p, _p)
_profile = _declare("kern_profile", _i, _p, _i, _p, _p)
_sensitivity = _declare("kern_sensitivity", _i, _p, _p, _p, _p, _p)
_critical_of = _declare("kern_critical_of", _i, _p, _r, _p, _p)
_known_of = _declare("kern_known_of", _Known, _p, _p)
_plan_of = _declare("kern_plan_of", _Plan, _p, _i, _p, _i, _Known, _p)
_plan_add = _declare("kern_plan_add", _i, _p, _p)
_plan_remove = _declare("kern_plan_remove", _i, _p, _i)
_plan_copy = _declare("kern_plan_copy", _i, _p, _p)
_rest = _declare("kern_rest", _i, _p, _p, _r, _Vec, _p, _p)
_place_compare = _declare("kern_place_compare", _i, _p, _p, _r)
_plan_try = _declare("kern_plan_try", _i, _p, _p, _p, _p)
_plan_bears = _declare("kern_plan_bears", _i, _p, _p, _r, _p)
_plan_raised = _declare("kern_plan_raised", _i, _p, _p, _p, _p, _p)
_plan_stays = _declare("kern_plan_stays", _i, _p, _p, _p)
_check_forces = _declare("kern_check_forces", _r, _p, _r, _p)
_check_motion = _declare("kern_check_motion", _r, _p, _r, _p)
_check_raised = _declare("kern_check_raised", _r, _p, _r, _i, _p)
_lp_solve = _declare("kern_lp_solve", _i, _p, _p, _p, _p)
_read = _declare("kern_py_read", _i, _p, c_char_p, ctypes.c_size_t)
_free = _declare("kern_py_free", None, _p)
_drawing_new = _declare("kern_py_drawing_new", _p)
_drawing_parse = _declare("kern_py_drawing_parse", _i, _p, _p, c_char_p,
                          c_char_p, ctypes.c_size_t, _p)
_drawing_notes = _declare("kern_py_drawing_notes", c_char_p, _p)
_drawing_skips = _declare("kern_py_drawing_skips", _i, _p)
_drawing_skip = _declare("kern_py_drawing_skip", None, _p, _i, _p, _p, _p)
_drawing_free = _declare("kern_py_drawing_free", None, _p)
_many = _declare("kern_py_many", _i, _p, _i, _i)
_falls = _declare("kern_py_falls", None, _p, _r, _p)
_draw = _declare("kern_py_draw", _i, c_char_p, _p, _p, _i, _r, _p, c_char_p, _p,
                 _p, _r, c_char_p, _i, _p, _r, c_char_p, _p)


def _statuses() -> Any:
    words = _declare("kern_py_statuses", c_char_p)().decode().split()
    return enum.IntEnum("Status", {
        name.replace("KERN_", "", 1): int(value)
        for name, value in zip(words[::2], words[1::2])})


Status = _statuses()  # OK, STANDS, FALLS, ... as in kern.h
_STANDS, _FALLS = int(Status.STANDS), int(Status.FALLS)


_Method = TypeVar("_Method", bound=Callable[..., Any])
_NO_NUMBERS: Any = (type(None), str, bytes, list, tuple, dict, complex)


def _numeric(function: _Method) -> _Method:
    """A function that says which argument is no number where C takes one."""
    @functools.wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        try:
            return function(*arguments, **options)
        except ctypes.ArgumentError:
            words: List[Any] = [a for a in (*arguments, *options.values())
                                if isinstance(a, _NO_NUMBERS)]
            raise TypeError("%s(): a number is expected%s" % (
                function.__name__, ", read " + reprlib.repr(words[0])
                if words else "")) from None
    return call  # type: ignore


@_numeric
def status_text(status: int) -> str:
    """Returns the meaning of a status.

    >>> status_text(Status.FALLS)
    'falls: a motion was found that no forces can stop'
    """
    return str(_status_text(status).decode())


class KernError(ValueError):
    """The library refused its input, or could not decide.

    status:   the Status, below 0
    blocks:   names of the blocks at fault: none, one or two
    index:    number of the vertex or contact point at fault, or -1
    value:    depth of an overlap [m], or 0; a lower bound of it from a Plan
    overlaps: a tuple for each pair of blocks that overlap: two names, the depth
              [m] and the depth that is allowed [m]
    margin:   the Margin that measure() had proven when it reached the limit of
              work (Status.LIMIT), otherwise None

    >>> Structure([Block("bow tie", [(0, 0), (1, 1), (2, 0), (0, 1)])])
    Traceback (most recent call last):
        ...
    kern.KernError: 'bow tie': a polygon crosses itself or passes a point twice \
(vertex 0)
    """

    def __init__(self, status: int, names: Sequence[str] = (),
                 fault: Optional[_Fault] = None, text: str = "",
                 overlaps: Sequence[Tuple[str, str, float, float]] = ()):
        fault = fault or _Fault(-1, -1, -1, 0, 0)
        self.status = Status(status)
        self.blocks = tuple(names[i] for i in (fault.block, fault.other)
                            if 0 <= i < len(names))
        self.index, self.value = fault.index, fault.value
        self.margin: Optional[Margin] = None
        self.overlaps = tuple(overlaps)
        place = ""
        if self.overlaps:
            self.blocks, self.value = self.overlaps[0][:2], self.overlaps[0][2]
            place = " (%.4g deep; %.4g is allowed: Options.overlap)" % (
                self.overlaps[0][2:])
            more = ["'%s' and '%s' (%.4g deep)" % pair[:3]
                    for pair in self.overlaps[1:]]
            if more:
                place += "; also " + ", ".join(more)
        elif self.status == Status.OVERLAP:
            place = " (at least %.4g deep; %.4g is allowed: Options.overlap)" % (
                self.value, fault.allowed)
        elif self.status == Status.STALE:
            place = ": call update()"
        elif self.index >= 0:
            point = self.status in (Status.BAD_BLOCK, Status.SAME_BLOCK,
                                    Status.BAD_NORMAL, Status.BAD_FRICTION
                                    ) or not self.blocks
            place = " (%s %d)" % ("contact point" if point else "vertex",
                                  self.index)
        who = " and ".join("'%s'" % name for name in self.blocks)
        super().__init__((who + ": " if who else "")
                         + (text or status_text(status)) + place)

    def __reduce__(self) -> Any:
        return _error_again, (int(self.status), self.args, self.__dict__)


def _error_again(status: int, args: Tuple[str, ...],
                 state: Dict[str, Any]) -> KernError:
    """A KernError that was pickled."""
    error = KernError(status)
    error.args = args
    error.__dict__.update(state)
    return error


# ---- Arrays -----------------------------------------------------------------


class Array(Protocol):
    """An array of numbers, (n, k): one of numpy where it is installed,
    otherwise Rows. Both have a length, rows to iterate over, [i, j], shape and
    tolist()."""

    @property
    def shape(self) -> Tuple[int, ...]: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[Any]: ...
    def __getitem__(self, key: Any) -> Any: ...
    def __setitem__(self, key: Any, value: Any) -> None: ...
    def tolist(self) -> List[Any]: ...
    def tobytes(self) -> bytes: ...


_Numbers = Union[Array, Sequence[float]]
_Table = Union[Array, Sequence[Sequence[float]]]


class Rows:
    """An array of numbers where numpy is not installed. A row is a tuple.

    >>> rows = Rows(memoryview(bytearray(32)).cast("d"), 2)
    >>> rows[1, 0] = 3
    >>> len(rows), rows.shape, rows[1], rows[:, 0]
    (2, (2, 2), (3.0, 0.0), [0.0, 3.0])
    >>> [x + y for x, y in rows], rows.tolist()
    ([0.0, 3.0], [[0.0, 0.0], [3.0, 0.0]])
    """

    def __init__(self, flat: Any, columns: int):
        self._flat, self._columns = flat, columns

    @property
    def shape(self) -> Tuple[int, int]:
        """The number of rows and the number of columns."""
        return len(self), self._columns

    def __len__(self) -> int:
        return len(self._flat) // self._columns

    def _row(self, i: int) -> Tuple[float, ...]:
        return tuple(self._flat[i * self._columns:(i + 1) * self._columns])

    def __iter__(self) -> Iterator[Tuple[float, ...]]:
        return map(self._row, range(len(self)))

    @staticmethod
    def _key(key: Any) -> Tuple[Any, Any]:
        """Returns the row and the column of an index: all columns of i."""
        return cast(Tuple[Any, Any], key if isinstance(key, tuple)
                    else (key, slice(None)))

    def __getitem__(self, key: Any) -> Any:
        i, j = self._key(key)
        if isinstance(i, slice):
            return [self._row(k)[j] for k in range(len(self))[i]]
        row: Any = self._row(range(len(self))[operator.index(i)])
        return row[j]

    def __setitem__(self, key: Any, value: Any) -> None:
        i, j = self._key(key)
        start = range(len(self))[operator.index(i)] * self._columns
        if isinstance(j, slice):
            where = range(self._columns)[j]
            if len(value) != len(where):
                raise ValueError("%d numbers for %d columns"
                                 % (len(value), len(where)))
            for k, number in zip(where, value):
                self._flat[start + k] = number
        else:
            self._flat[start + range(self._columns)[operator.index(j)]] = value

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Rows) and self.tolist() == other.tolist()

    def __repr__(self) -> str:
        return "Rows(%r)" % self.tolist()

    def __reduce__(self) -> Any:
        return _rows_of, (self.tobytes(), self._columns)

    def tolist(self) -> List[List[float]]:
        """Returns the rows as a list of lists."""
        return [list(row) for row in self]

    def tobytes(self) -> bytes:
        """Returns the numbers as doubles of this machine, row by row."""
        return bytes(self._flat)

    def toreadonly(self) -> Rows:
        """Returns the same numbers as Rows that cannot be changed."""
        return Rows(self._flat.toreadonly(), self._columns)


def _rows_of(data: Any, columns: int) -> Rows:
    """Rows that show the doubles of a buffer."""
    return Rows(memoryview(data).cast("B").cast("d"), columns)


def _view(data: bytes, columns: int) -> Array:
    """Returns the bytes of doubles as an array that cannot be written."""
    if numpy is not None:
        return cast(Array, numpy.frombuffer(data).reshape(-1, columns))
    return _rows_of(data, columns)


def _doubles(data: Optional[bytes]) -> Any:
    """A ctypes array of what _view() shows; None for None."""
    return data and (c_double * (len(data) // 8)).from_buffer_copy(data)


def _rows(values: Any, rows: int, columns: int, what: str) -> Any:
    """Rows of numbers as a ctypes array, of the length that C will read."""
    try:
        table: List[Any] = (values.tolist() if hasattr(values, "tolist")
                            else list(values))
        out = _numbers(table)
    except (TypeError, OverflowError):
        raise TypeError("%s: rows of %d numbers are expected, read %s" % (
            what, columns, reprlib.repr(values))) from None
    if len(out) != rows * columns:
        raise ValueError("%d numbers of %s where %d rows of %d are expected"
                         % (len(out), what, rows, columns))
    for i, row in enumerate(table if len(table) != len(out) else ()):
        if not hasattr(row, "__len__") or len(row) != columns:
            raise ValueError("%s: row %d is %s where %d numbers are expected"
                             % (what, i, reprlib.repr(row), columns))
    return out


def _numbers(values: Any) -> Any:
    """Numbers, or rows of them, as a ctypes array of doubles."""
    flat: List[float] = []
    for value in values.tolist() if hasattr(values, "tolist") else values:
        if isinstance(value, (int, float)):
            flat.append(value)
        else:
            flat.extend(value)
    return (c_double * len(flat))(*flat)


def _several(what: str, values: Any, count: int) -> List[float]:
    """So many numbers, neither more nor less."""
    try:
        told = [math.fsum((value,)) for value in values]
    except (TypeError, ValueError, OverflowError):
        told = []
    if len(told) != count:
        raise TypeError("%s: %s expected, read %r" % (
            what, "a number is" if count == 1 else "%d numbers are" % count,
            values[0] if count == 1 else values))
    return told


def _vector(what: str, values: Any) -> _Vec:
    """Two numbers as a vector of C."""
    return _Vec(*_several(what, values, 2))


# ---- Options, blocks, contacts ----------------------------------------------

_D = _defaults()


def _not_below(x: float) -> bool:
    return x >= 0


# What each number of the options takes, and the status of what is none.
_TAKES: Dict[str, Tuple[str, Callable[[float], bool], int]] = {
    "mu": ("a number not below zero", _not_below, Status.BAD_FRICTION),
    "angle": ("an angle in radians above 0 and below 0.5",
              lambda x: 0 < x < 0.5, Status.BAD_OPTION),
    "reserve": ("a share from 0 to 0.1", lambda x: 0 <= x <= 0.1,
                Status.BAD_OPTION),
    **{name: ("a number not below zero", _not_below, Status.BAD_OPTION)
       for name in ("gap", "epsilon", "overlap", "pose_error", "pose_turn",
                    "narrow")},
}


def _refuse(name: str, takes: str, value: Any,
            status: int = Status.BAD_OPTION) -> None:
    raise KernError(status, text="Options.%s takes %s, read %r"
                    % (name, takes, value))


@dataclass
class Options:
    """Tolerances, friction and limits of a structure.

    mu:       friction of contacts between polygons, tan(friction angle)
    gap:      widest gap that counts as a contact [m]; 0: a thousandth of the
              size of the smaller free block
    angle:    widest angle between edges that touch [rad], below 0.5
    epsilon:  step of the level [m]; 0: a fiftieth of the mean block size
    relative: whether contacts shrink by a share of their length instead of by a
              length
    limit:    limit on the work of one call, in units; 0: 2,000,000,000
    overlap:  deepest overlap that counts as a contact [m]; 0: the gap
    pose_error, pose_turn: standard error of the blocks' places [m] and turns
              [rad], which measured() sets; 0: exact
    narrow:   rate at which friction falls as contacts shrink [1/m]
    reserve:  largest reserve that raised(reserve=True) searches for, a share of
              g; 0: 0.1
    lone:     direction of gravity in which lone points are moved; (0, 0): none

    At the next update() of a structure a number out of its range raises
    KernError, and a value that is no number raises TypeError.

    >>> Options(mu=0.6).near(1.0).gap
    0.04
    """
    mu: float = _D.mu
    gap: float = _D.gap
    angle: float = _D.angle
    epsilon: float = _D.epsilon
    relative: bool = bool(_D.relative)
    limit: int = _D.limit
    overlap: float = _D.overlap
    pose_error: float = _D.pose_error
    pose_turn: float = _D.pose_turn
    narrow: float = _D.narrow
    reserve: float = _D.reserve
    lone: Point = (_D.lone.x, _D.lone.y)

    def _c(self) -> _Options:
        for name, (takes, good, status) in _TAKES.items():
            value = getattr(self, name)
            try:
                finite = math.isfinite(value)
            except (TypeError, OverflowError):
                raise TypeError("Options.%s takes %s, read %r"
                                % (name, takes, value)) from None
            if not finite or not good(value):
                _refuse(name, takes, value, status)
        if self.relative and self.epsilon > 1:
            _refuse("epsilon", "a share up to 1 with relative", self.epsilon)
        try:
            limit = operator.index(self.limit)
        except TypeError:
            raise TypeError("Options.limit takes a whole number, read %r"
                            % self.limit) from None
        if not 0 <= limit <= 2000000000:
            _refuse("limit", "a whole number from 1 to 2,000,000,000, or 0",
                    limit)
        return _Options(self.mu, self.gap, self.angle, self.epsilon,
                        bool(self.relative), limit, self.overlap,
                        self.pose_error, self.pose_turn, self.narrow,
                        self.reserve, _vector("Options.lone", self.lone))

    def _suits(self, size: float) -> None:
        """Raises where everything would touch everything in a structure of
        blocks of this mean size: a length of another unit, or mistyped."""
        most = "a length up to %%sthe mean size of the blocks, %.4g"
        if self.pose_error > size / 5:
            _refuse("pose_error", (most % (size / 5)) % "a fifth of ",
                    self.pose_error)
        for name in ("gap", "overlap") if not self.pose_error else ():
            if getattr(self, name) > size:
                _refuse(name, (most % size) % "", getattr(self, name))

    @staticmethod
    def _of(c: _Options) -> Options:
        return Options(c.mu, c.gap, c.angle, c.epsilon, bool(c.relative),
                       c.limit, c.overlap, c.pose_error, c.pose_turn,
                       c.narrow, c.reserve, (c.lone.x, c.lone.y))

    def near(self, mean_size: float) -> Options:
        """Returns options that also find the contacts which close as soon as
        the structure rocks.

        mean_size: Structure.mean_size [m]; the gap is a share of it. Raises
                   KernError where it is no length above 0"""
        (mean_size,) = _several("near()", [mean_size], 1)
        if not 0 < mean_size < math.inf:
            raise KernError(Status.BAD_OPTION, text="near() takes a length "
                            "above 0, read %r" % mean_size)
        return Options._of(_near(byref(self._c()), mean_size))

    def measured(self, e: float, theta: float) -> Options:
        """Returns options for poses that were measured, with wider tolerances.

        e:     standard error of the places [m]
        theta: standard error of the turns [rad]
        Raises KernError for errors out of their range. Structure.interval()
        then returns the range of the margin.

        >>> round(Options().measured(0.01, 0.01).gap, 6)
        0.0525
        """
        e, theta = _several("measured()", (e, theta), 2)
        if not 0 < e < math.inf or not 0 <= theta < 0.5:
            raise KernError(Status.BAD_OPTION, text="measured() takes a length "
                            "above 0 and an angle in radians from 0 to below "
                            "0.5, read %r and %r" % (e, theta))
        return Options._of(_measured(byref(self._c()), e, theta))


def _asked_options(options: Any) -> Options:
    """Returns the options; those by default for None."""
    if options is None:
        return Options()
    if not isinstance(options, Options):
        raise TypeError("options are Options(...), read %r" % (options,))
    return options


def _plain(value: Any) -> Any:
    """What as_dict() has for a value."""
    if isinstance(value, KernError):
        return str(value)
    if isinstance(value, list):
        return list(map(_plain, cast(Any, value)))
    return value.tolist() if hasattr(value, "tolist") else value


class _Answer:
    """The base of blocks and answers."""

    def as_dict(self) -> Dict[str, Any]:
        """Returns the numbers by name, without the proof of an answer. Arrays
        become lists, and an error becomes its message.

        >>> example().verdict().as_dict()
        {'stands': True}
        """
        return {f.name: _plain(getattr(self, f.name)) for f in fields(
            cast(Any, self)) if f.init}


class Body(NamedTuple):
    """Area, mass and centre of mass of a block."""
    area: float
    mass: float
    centre: Point


_NO_LOAD = (0.0, 0.0, 0.0)


def _block(block: Any, what: str = "") -> Block:
    """Returns the block. Raises TypeError where it is something else."""
    if not isinstance(block, Block):
        raise TypeError("%sa Block is expected, read %s"
                        % (what, reprlib.repr(block)))
    return block


@dataclass(eq=False)
class Block(_Answer):
    """A stone, or with `fixed` a piece of ground.

    name:     a word that no other block of a structure has
    vertices: corners (x, y) [m] in order, or a polygon of shapely
    density:  mass a square metre [kg/m^2]
    fixed:    whether it is ground, which bears whatever is needed
    mass:     [kg]; None: density times area
    centre:   centre of mass [m]; None: the centroid. One that is given stays
              where it is unless move() moves it
    load:     force and torque [N, N, N m] at the centre, besides the weight

    vertices becomes an Array (n, 2). A numpy array of float64 in C order is not
    copied: a later change of it counts from the next update(), until move()
    gives the block vertices of its own. A closed ring loses its last vertex, and
    a MultiPolygon of one part is that part. Raises ValueError for other shapes
    and for polygons with holes or of several parts. body() and Structure()
    raise KernError where the polygon crosses itself or has no area.

    >>> b = Block("b", [(0, 0), (2, 0), (2, 1), (0, 1)], density=2)
    >>> b.body()
    Body(area=2.0, mass=4.0, centre=(1.0, 0.5))
    >>> b.move(1, 0, turn=math.pi / 2).body().centre
    (2.0, 0.5)
    """
    name: str
    vertices: Any
    density: float = 1.0
    fixed: bool = False
    mass: Optional[float] = None
    centre: Optional[Point] = None
    load: Tuple[float, float, float] = _NO_LOAD
    _taken: Any = field(default=None, init=False, repr=False)

    def __post_init__(self) -> None:
        name = cast(object, self.name)
        if not isinstance(name, str):
            raise TypeError("a block has a str as its name, read %r"
                            % (name,))
        self._take()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Block) and self._key() == other._key()

    __hash__ = None  # type: ignore

    def __getstate__(self) -> Dict[str, Any]:
        return {**self.__dict__, "vertices": self.vertices.tolist(),
                "_taken": None}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._take()

    def copy(self) -> Block:
        """Returns a block with vertices of its own."""
        return Block(self.name, self.vertices.tolist(), self.density,
                     self.fixed, self.mass, self.centre, self.load)

    def _key(self) -> Any:
        """All that the library reads, to compare."""
        if self.vertices is not self._taken:
            self._take()
        return (self.name, self.vertices.tobytes(), self.density, self.fixed,
                self.mass, self.centre, self.load)

    def _take(self) -> None:
        """Makes an array of the vertices, and remembers where it lies."""
        shape: Any = self.vertices
        parts = getattr(shape, "geoms", (shape,))
        if len(parts) != 1:
            raise ValueError("'%s': a %s of %d parts: a block is one polygon"
                             % (self.name, type(shape).__name__, len(parts)))
        shape = parts[0]
        holes = len(getattr(shape, "interiors", ()))
        if holes:
            raise ValueError("'%s': the polygon has %d hole%s, a block has none"
                             % (self.name, holes, "s" if holes > 1 else ""))
        ring: Any = getattr(shape, "exterior", shape)
        ring = getattr(ring, "coords", ring)
        try:
            if numpy is None or not isinstance(ring, numpy.ndarray):
                ring = [tuple(point) for point in (
                    ring.tolist() if hasattr(ring, "tolist") else ring)]
            if len(ring) > 3 and tuple(ring[0]) == tuple(ring[-1]):
                ring = ring[:-1]
            if any(len(point) != 2 for point in ring):
                raise ValueError("a vertex is no pair")
            if numpy is not None:
                array = numpy.ascontiguousarray(ring, numpy.float64)
                self._address = array.ctypes.data
            else:
                memory = (c_double * (2 * len(ring)))(
                    *chain.from_iterable(ring))
                self._address = addressof(memory)
                array = _rows_of(memory, 2)
        except (TypeError, ValueError, OverflowError) as error:
            raise ValueError("'%s': vertices are not of shape (n, 2): %s"
                             % (self.name, error)) from None
        self.vertices = self._taken = array

    def _fill(self, c: Any) -> None:
        """Fills a kern_block from the vertices where they are now."""
        if self.vertices is not self._taken:
            self._take()
        fault = _Fault()
        n = len(self.vertices)
        try:
            status = (_ground_init(byref(c), self._address, n, byref(fault))
                      if self.fixed else
                      _block_init(byref(c), self._address, n, self.density,
                                  byref(fault)))
        except ctypes.ArgumentError:
            raise TypeError("'%s': density: a number is expected, read %r"
                            % (self.name, self.density)) from None
        if status < 0:
            fault.block = 0
            raise KernError(status, (self.name,), fault)
        if self.mass is not None:
            (c.mass,) = self._told("mass", [self.mass], 1)
        if self.centre is not None:
            c.centre = _Vec(*self._told("centre", self.centre, 2))
        if self.load is not _NO_LOAD:
            c.load = _Wrench(*self._told("load", self.load, 3))

    def _told(self, what: str, values: Any, count: int) -> List[float]:
        return _several("'%s': %s" % (self.name, what), values, count)

    def _copy_to(self, c: Any) -> Any:
        """Fills a kern_block that reads a copy of the vertices; returns it."""
        self._fill(c)
        copy = (c_double * (2 * c.vertices))()
        ctypes.memmove(copy, self._address, ctypes.sizeof(copy))
        c.vertex = addressof(copy)
        return copy

    def body(self) -> Body:
        """Returns area [m^2], mass [kg] and centre of mass [m]."""
        c = _Block()
        self._fill(c)
        return Body(abs(c.area), c.mass, (c.centre.x, c.centre.y))

    def push(self, force: Point, at: Point, torque: float = 0.0) -> Block:
        """Adds a force and a torque to the load of the block. Returns the
        block.

        force:  (x, y) [N]
        at:     the point at which the force acts [m]
        torque: [N m], counter-clockwise

        >>> Block("b", [(0, 0), (2, 0), (2, 1), (0, 1)]).push((3, 0), (0, 1)).load
        (3.0, 0.0, -1.5)
        """
        c = _Block()
        self._fill(c)
        (torque,) = self._told("torque", [torque], 1)
        _block_load(byref(c), _vector("'%s': force" % self.name, force),
                    _vector("'%s': at" % self.name, at), torque)
        self.load = (c.load.fx, c.load.fy, c.load.torque)
        return self

    def move(self, x: float, y: float, turn: float = 0.0) -> Block:
        """Turns the block [rad] about its centre of mass, then shifts it [m].
        Returns the block, which has new vertices: an array that was given, and
        other blocks made of it, stay as they are. Structures that hold the
        block need an update()."""
        x, y, turn = self._told("move()", (x, y, turn), 3)
        if not math.isfinite(turn):
            raise ValueError("'%s': turn: a finite angle is expected, read %r"
                             % (self.name, turn))
        cx, cy = self.body().centre
        cos, sin = math.cos(turn), math.sin(turn)
        points: List[Point] = []
        for px, py in self.vertices.tolist():
            if turn:
                px, py = (cx + cos * (px - cx) - sin * (py - cy),
                          cy + sin * (px - cx) + cos * (py - cy))
            points.append((px + x, py + y))
        self.vertices = points
        self._take()
        if self.centre is not None:
            self.centre = (cx + x, cy + y)
        return self

    def to_shapely(self) -> Any:
        """Returns a Polygon of shapely, which must be installed."""
        return importlib.import_module("shapely.geometry").Polygon(
            [tuple(point) for point in self.vertices.tolist()])


@dataclass
class Contact(_Answer):
    """A contact point between two blocks.

    a, b:   numbers of the blocks; a force pushes b along n and a against it
    line:   whether it is an end of a line contact; the other end is the point
            before or after it in the list
    p:      place [m]
    n:      normal, of length 1, out of a and into b
    mu:     friction, tan(friction angle)
    travel: distance along the contact [m] by which the point may move when the
            contact shrinks, with a sign; 0: it stays"""
    a: int
    b: int
    line: bool
    p: Point
    n: Point
    mu: float
    travel: float

    def _c(self) -> _Contact:
        try:
            a, b = operator.index(self.a), operator.index(self.b)
        except TypeError:
            raise TypeError("a contact has the numbers of two blocks, read %r "
                            "and %r" % (self.a, self.b)) from None
        mu, travel = _several("a contact: mu and travel",
                              (self.mu, self.travel), 2)
        return _Contact(a, b, self.line, _vector("a contact: place", self.p),
                        _vector("a contact: normal", self.n), mu, travel)

    @staticmethod
    def _of(c: _Contact) -> Contact:
        return Contact(c.a, c.b, bool(c.line), (c.p.x, c.p.y), (c.n.x, c.n.y),
                       c.mu, c.travel)

    @_numeric
    def at(self, shrink: float, relative: bool = False) -> Point:
        """Returns the place of the point when the contact has shrunk.

        shrink:   at each end: a length [m], or with relative a share of it"""
        v = _contact_at(byref(self._c()), shrink, relative)
        return v.x, v.y


def _contact(contact: Any) -> Contact:
    """Returns the contact. Raises TypeError where it is something else."""
    if not isinstance(contact, Contact):
        raise TypeError("a Contact is expected, read %s"
                        % reprlib.repr(contact))
    return contact


def contact_make(a: int, b: int, normal: Point, p: Point,
                 q: Optional[Point] = None, mu: float = _D.mu,
                 options: Optional[Options] = None) -> List[Contact]:
    """Returns the points of a contact that you describe yourself.

    a, b:    numbers of the blocks
    normal:  direction out of a and into b, of any length
    p, q:    its ends [m]; without q the contact is one point
    mu:      friction
    Pass all contacts to contact_travels(), and its result to
    Structure(contacts=...). Raises KernError.

    >>> [c.travel for c in contact_make(0, 1, (0, 2), (0, 0), (3, 0))]
    [-1.5, 1.5]
    """
    out = (_Contact * 2)()
    out[0] = Contact(a, b, False, p, normal, mu, 0)._c()
    made = _contact_make(
        out, _vector("a contact: place", p if q is None else q),
        byref(_asked_options(options)._c()))
    if made < 0:
        raise KernError(made, (), _Fault(-1, -1, -1, 0))
    return [Contact._of(c) for c in out[:made]]


def contact_travels(contacts: Sequence[Contact]) -> List[Contact]:
    """Returns the contacts with their travels, which depend on the contacts
    beside them: call it once with all contacts of contact_make()."""
    array = (_Contact * len(contacts))(*(_contact(c)._c() for c in contacts))
    _contact_travels(array, len(contacts))
    return [Contact._of(c) for c in array[:len(contacts)]]


@_numeric
def work_need(blocks: int, contacts: int) -> Tuple[int, int]:
    """Returns how many doubles and ints of work memory kern.h needs."""
    reals, ints = c_int(), c_int()
    _work_need(blocks, contacts, byref(reals), byref(ints))
    return reals.value, ints.value


# ---- Answers ----------------------------------------------------------------


class _Proven(_Answer):
    """An answer with a proof, which is no field: so a table of answers has no
    columns of bytes."""
    _force: Optional[bytes] = None
    _motion: Optional[bytes] = None

    def _by(self: _P, force: Optional[bytes], motion: Optional[bytes]) -> _P:
        """Returns the answer with its proof."""
        self._force, self._motion = force, motion
        return self


_P = TypeVar("_P", bound=_Proven)


@dataclass
class Verdict(_Proven):
    """Whether a structure stands. A Verdict is true where it does.

    stands: whether forces in equilibrium exist
    forces: where it stands the normal and the tangential force [N] of each
            contact point, an array (n, 2); otherwise None
    motion: where it falls vx, vy and spin of each block, an array (n, 3);
            otherwise None
    """
    stands: bool

    def __bool__(self) -> bool:
        return self.stands

    @property
    def forces(self) -> Optional[Array]:
        """Forces that hold the structure, (n, 2), or None."""
        return _view(self._force, 2) if self.stands and self._force else None

    @property
    def motion(self) -> Optional[Array]:
        """A motion that no forces can stop, (n, 3), or None."""
        return (None if self.stands or not self._motion
                else _view(self._motion, 3))


class Raising(enum.IntEnum):
    """Whether the load of a structure raises the forces that hold it.

    RAISED: it does; HANGS: some blocks are held only by friction that nothing
    presses together; NOT_SHOWN: neither was found"""
    NOT_SHOWN = 0
    RAISED = 1
    HANGS = 2


class End(enum.IntEnum):
    """Why the search for forces that the load raises ended.

    NONE: there was no search; SHOWN: forces were found; LOST: no step led any
    further; WORK: the limit of work was reached"""
    NONE = 0
    SHOWN = 1
    LOST = 2
    WORK = 3


@dataclass
class Raised(Verdict):
    """Whether the load of a structure raises the forces that hold it. A Raised
    is true where it does.

    stands:  whether forces in equilibrium exist
    raising: a Raising, None where it falls
    reserve: the additional sideways push that the structure bears, a share of
             g; None without reserve=True
    why:     an End: the reason why the search ended
    forces and motion are the proof."""
    raising: Optional[Raising]
    reserve: Optional[float]
    why: End = field(default=End.NONE, repr=False)

    def __bool__(self) -> bool:
        return self.raising == Raising.RAISED

    @property
    def motion(self) -> Optional[Array]:
        """The displacement that raises the forces, (n, 3), or None."""
        return (None if self.raising == Raising.NOT_SHOWN or not self._motion
                else _view(self._motion, 3))


@dataclass
class LetGo(_Proven):
    """Whether a structure stays when all of it is released at once. A LetGo is
    true where it stays.

    stays:  True where it stays, False where it moves, None where neither is
            shown
    why:    an End: the reason why the search for forces ended, NONE where no
            search was needed
    how:    a Raising: RAISED where it stays, HANGS where blocks hang, otherwise
            NOT_SHOWN
    forces [N], (n, 2), and motion, (n, 3), are the proof: forces are None where
    it falls, both are None where nothing is shown."""
    stays: Optional[bool]
    why: End
    how: Raising

    def __bool__(self) -> bool:
        return self.stays is True

    @property
    def forces(self) -> Optional[Array]:
        """Forces that hold the structure, (n, 2), or None."""
        return (None if self.how == Raising.NOT_SHOWN
                else _view(self._force or b"", 2))

    @property
    def motion(self) -> Optional[Array]:
        """The displacement or the fall, (n, 3), or None."""
        return (None if self.stays is None
                else _view(self._motion or b"", 3))


@dataclass
class Margin(Verdict):
    """How far every contact can shrink until a structure falls. A Margin is
    true where it stands.

    stands:    whether it stands as it is
    margin:    the least shrinkage at which it falls [m, at each end of each
               contact], 0 where it falls as it is
    holds, fails: it stands at the one and falls at the other [m]; the margin
               lies between
    most:      contacts shrink no further [m]
    epsilon:   the step of the level [m]
    level:     steps that it stands
    saturated: whether it stands at `most`: such margins do not compare
    refused:   from Plan.try_() the KernError of a block that overlaps another;
               the margin is then nan. Otherwise None
    forces hold the structure at `holds`; motion moves it at `fails`, or as it
    is where it falls, and is None where it is saturated.

    >>> wall = example()
    >>> m = wall.measure()
    >>> wall.check_forces(m.forces, m.holds) <= 1
    True
    >>> wall.check_motion(m.motion, m.fails) <= 1
    True
    """
    margin: float
    holds: float = field(repr=False)
    fails: float = field(repr=False)
    most: float = field(repr=False)
    epsilon: float = field(repr=False)
    level: int
    saturated: bool
    refused: Optional[KernError] = field(default=None, repr=False,
                                         compare=False)

    @staticmethod
    def _of(m: _Margin, stands: bool, force: Optional[bytes] = None,
            motion: Optional[bytes] = None) -> Margin:
        return Margin(stands, m.margin, m.holds, m.fails, m.most, m.epsilon,
                      m.level, bool(m.saturated))._by(force, motion)

    @property
    def motion(self) -> Optional[Array]:
        """The mechanism just past the margin, (n, 3), or None."""
        return (None if self.saturated or not self._motion
                else _view(self._motion, 3))


@dataclass
class Interval(_Answer):
    """The range of the margin of a measured structure.

    low, high: the ends of the range [m]
    settles:   how far blocks may settle [m], inf where that is not known
    surely_stands, surely_falls: whether the verdict is certain
    """
    low: float
    high: float
    settles: float
    surely_stands: bool
    surely_falls: bool

    @property
    def certain(self) -> bool:
        """Whether the verdict is certain."""
        return self.surely_stands or self.surely_falls


class Factor(float):
    """A load factor, an angle of tilt or a length: a float with its proof.

    forces: forces that hold the structure at this number [N], an array (n, 2)
    motion: the mechanism just beyond it, (n, 3), None where it is infinite
    why:    an End: the reason why the search of raised_load() ended, NONE from
            other methods
    """
    _force: bytes = b""
    _motion: bytes = b""
    why: End = End.NONE

    @staticmethod
    def _of(value: float, force: bytes, motion: bytes) -> Factor:
        out = Factor(value)
        out._force, out._motion = force, motion
        return out

    @property
    def forces(self) -> Array:
        """Forces that hold the structure at this number, (n, 2)."""
        return _view(self._force, 2)

    @property
    def motion(self) -> Optional[Array]:
        """The mechanism just beyond, (n, 3), or None."""
        return (None if self == math.inf or not self._motion
                else _view(self._motion, 3))


@dataclass
class Profile(_Answer):
    """How far each block is from falling.

    values: the margin [m] or load factor at which each block moves; inf for
            fixed blocks
    least:  the smallest of these
    mean:   their mean
    weak:   the mean of the smaller half
    drop:   expected drop: the mean of h exp(-value / 0.07), where h is the
            height of a block's centre above the lowest block in mean sizes
    """
    values: List[float]
    least: float
    mean: float
    weak: float
    drop: float


@dataclass
class Critical(_Answer):
    """The contact that limits the margin, and the blocks that move first.

    contact:  number of the contact point that limits the margin most, or None
    limits:   how much each contact point limits it, as a share of the most
    meetings: "rests", "hinges", "slides" or "opens" for each contact point
    groups:   lists of the blocks that move together, the fastest first
    """
    contact: Optional[int]
    limits: List[float]
    meetings: List[str]
    groups: List[List[int]]


@dataclass
class ContactRate(_Answer):
    """Derivatives of the margin [m] with respect to a contact point.

    p:      with respect to its place [m]
    turn:   to a turn of its normal [rad]
    mu:     to its friction
    travel: to its travel [m]"""
    p: Point
    turn: float
    mu: float
    travel: float


@dataclass
class BlockRate(_Answer):
    """Derivatives of the margin [m] with respect to a block.

    centre: with respect to the centre of mass alone [m]
    place:  to a shift of the block [m]
    turn:   to a turn of the block [rad]
    mass:   to its mass [kg]
    load:   to its load [N, N, N m]"""
    centre: Point
    place: Point
    turn: float
    mass: float
    load: Tuple[float, float, float]


@dataclass
class Solution(_Answer):
    """The answer of lp_solve().

    status: Status.LP_OPTIMAL, LP_INFEASIBLE or LP_UNBOUNDED
    x:      the solution
    y:      its prices, or the proof that there is no solution
    """
    status: Any
    x: List[float]
    y: List[float]


# ---- Structures -------------------------------------------------------------


def _asks(method: _Method) -> _Method:
    """A question: one thread at a time, of what update() has read."""
    call = _numeric(method)

    @functools.wraps(method)
    def ask(self: Structure, *arguments: Any, **options: Any) -> Any:
        with self._lock:
            self._fresh()
            return call(self, *arguments, **options)
    return ask  # type: ignore


class _Held:
    """What C reads and writes of one structure, all of it private: arrays for
    so many blocks and contact points, copies of vertices, work memory."""

    def __init__(self, blocks: int, contacts: int):
        reals, ints = work_need(blocks, contacts)
        self.block = (_Block * blocks)()
        self.contact = (_Contact * contacts)()
        self.vertex: List[Any] = []
        self.real, self.index = (c_double * reals)(), (c_int * ints)()
        self.work = _Work(addressof(self.real), reals, addressof(self.index),
                          ints)


class _Kept(Block):
    """A block of a plan: it stays as it was when it was added."""
    _kept = False

    def __init__(self, *arguments: Any):
        super().__init__(*arguments)
        self._keep()

    def __setstate__(self, state: Dict[str, Any]) -> None:
        super().__setstate__({k: v for k, v in state.items() if k != "_kept"})
        self._keep()

    def _keep(self) -> None:
        if numpy is not None:
            self._taken.setflags(write=False)
        else:
            self.vertices = self._taken = self._taken.toreadonly()
        self._kept = True

    def __setattr__(self, name: str, value: Any) -> None:
        if self._kept:
            raise TypeError("'%s' is in a plan: remove() it and add() a copy()"
                            % self.name)
        object.__setattr__(self, name, value)

    def move(self, x: float, y: float, turn: float = 0.0) -> Block:
        raise TypeError("'%s' is in a plan: remove() it and add() a copy()"
                        % self.name)


def _name_once(blocks: Iterable[Block]) -> None:
    """Raises where two blocks have one name: a question by name would be
    answered for the first."""
    place: Dict[str, int] = {}
    for i, block in enumerate(blocks):
        if place.setdefault(block.name, i) != i:
            raise ValueError("block %d: the name '%s' was given to block %d "
                             "already" % (i, block.name, place[block.name]))


def _unique(word: str, used: Dict[str, int]) -> str:
    """The word, with a number where it is used already."""
    own = word
    while own in used:
        used[word] += 1
        own = "%s_%d" % (word, used[word])
    used[own] = 1
    return own


class Structure:
    """Blocks, their contacts, options and gravity.

    blocks:   Blocks, each with a name of its own
    contacts: a list of Contacts; None: they are found between the polygons
    options:  Options
    gravity:  (x, y) [m/s^2]
    name:     for captions and messages

    wall["s3"] and wall[3] are blocks, `for block in wall` visits all of them,
    and `"s3" in wall` is true where there is one of that name. Call update()
    after a change of blocks, options, gravity or given contacts; until then
    every method that computes raises KernError. Where update() raises, the
    structure is as it was before.

    Raises KernError for blocks that the library refuses, with all pairs that
    overlap, and ValueError where two blocks have one name. Methods that compute
    may raise KernError with Status.UNDECIDED, or with LIMIT at the limit of
    work.

    >>> box = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> wall = Structure([Block("ground", [(-3, -1), (4, -1), (4, 0), (-3, 0)],
    ...                         fixed=True),
    ...                   Block("low", box), Block("top", box).move(0.25, 1)])
    >>> bool(wall.verdict()), wall.measure().level, len(wall.contacts)
    (True, 13, 4)
    >>> round(wall.load_factor(RIGHT), 6), round(math.degrees(wall.tilt(LEFT)))
    (0.375, 22)
    >>> wall.move("top", 0.5, 0).verdict()
    Verdict(stands=False)
    >>> round(wall.deficit(), 6)
    0.25
    >>> wall.move("top", 0, -0.5)
    Traceback (most recent call last):
        ...
    kern.KernError: 'low' and 'top': two blocks overlap deeper than the gap \
tolerance (0.25 deep; 0.001 is allowed: Options.overlap)
    """

    lives: Sequence[Tuple[str, Point, Point]] = ()  # of live()
    units: Optional[str] = None                     # of lengths, if known

    def __init__(self, blocks: Iterable[Block],
                 *, contacts: Optional[Sequence[Contact]] = None,
                 options: Optional[Options] = None,
                 gravity: Point = (0.0, -9.81), name: str = "structure"):
        self.blocks: List[Block] = list(blocks)
        self.given = contacts
        self.options = options or Options()
        self.gravity = gravity
        self.name = name
        self.notes: List[str] = []
        self.skipped: List[Tuple[str, str, Optional[int], int]] = []
        self._lock = threading.RLock()
        self.update()

    # What update() makes: it is neither pickled nor copied.
    _made = frozenset((
        "_lock", "_held", "_task", "_at_task", "_told", "_forces", "_motions",
        "_candidate", "_plan", "_at_plan", "_known"))

    def __getstate__(self) -> Dict[str, Any]:
        return {key: value for key, value in self.__dict__.items()
                if key not in self._made}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._lock = threading.RLock()
        self.update()

    def __len__(self) -> int:
        return len(self.blocks)

    def __getitem__(self, block: Union[int, str]) -> Block:
        return self.blocks[self._index(block)]

    def __iter__(self) -> Iterator[Block]:
        return iter(self.blocks)

    def __contains__(self, block: object) -> bool:
        return any(b.name == block or b is block for b in self.blocks)

    def __repr__(self) -> str:
        return "<%s '%s': %d blocks, %d contact points>" % (
            type(self).__name__, self.name, len(self.blocks),
            self._task.s.contacts)

    def _key(self) -> Any:
        """All that update() reads, to compare."""
        return ([b._key() for b in self.blocks], self.given and
                list(self.given), self.options.__dict__.copy(), self.gravity)

    def _fresh(self) -> None:
        """Raises where something has changed since update()."""
        key, told = self._key(), self._told
        if key == told:
            return
        fault = _Fault(-1, -1, -1, 0, 0)
        for i, (new, old) in enumerate(zip(key[0], told[0])):
            if new != old:
                fault.block = i
                break
        raise KernError(Status.STALE, [b.name for b in self.blocks], fault,
                        "vertices, mass, centre or load have changed"
                        if fault.block >= 0 else "blocks, options, gravity or "
                        "given contacts have changed")

    def _check(self, status: int) -> int:
        if status < 0:
            raise KernError(status, [b.name for b in self.blocks],
                            self._held.work.fault)
        return status

    def update(self) -> None:
        """Reads blocks, options, gravity and given contacts again, and finds
        the contacts if none are given. Raises KernError and ValueError."""
        with self._lock:
            given, n = self.given, len(self.blocks)
            asked = _asked_options(self.options)
            for i, block in enumerate(self.blocks):
                _block(block, "block %d: " % i)
            names, options = [b.name for b in self.blocks], asked._c()
            search = asked._c()  # a short limit is meant for the questions
            if search.limit > 0:
                search.limit = max(search.limit, Options().limit)
            _name_once(self.blocks)
            room = 16 * n if given is None else len(given)
            while True:
                held = _Held(n, room)
                for i, block in enumerate(self.blocks):
                    held.vertex.append(block._copy_to(held.block[i]))
                if given is None:
                    self.options._suits(_mean_size(held.block, n) or math.inf)
                    found = _contacts(held.block, n, byref(search),
                                      held.contact, room, byref(held.work))
                    room *= 2
                else:
                    found = room
                    held.contact[:] = [_contact(c)._c() for c in given]
                if found != Status.NO_SPACE or room > 1000000:
                    break
            if found < 0:
                fault = held.work.fault
                raise KernError(
                    found, names, fault, overlaps=overlaps(
                        self.blocks, options=self.options)
                    if found == Status.OVERLAP else ())
            task = _task_of(held.block, n, held.contact, found,
                            byref(held.work))
            task.options = options
            task.s.gravity = _Vec(*_several("gravity", self.gravity, 2))
            self._held, self._task, self._told = held, task, self._key()
            self._at_task = byref(self._task)
            self._shape()

    def move(self, block: Union[int, str], x: float, y: float,
             turn: float = 0.0) -> Structure:
        """Turns a block [rad] about its centre of mass, then shifts it [m], and
        updates the structure. Returns the structure. Where KernError is raised
        the block is where it was.

        >>> round(example().move("top", 0.1, 0).measure().margin, 6)
        0.2
        """
        b = self.blocks[self._index(block)]
        before, centre = b.vertices, b.centre
        b.move(x, y, turn)
        try:
            self.update()
        except ValueError:
            b.vertices, b.centre = before, centre
            raise
        return self

    def _shape(self) -> None:
        """Types of the arrays of a proof, for this many."""
        self._forces = c_double * (2 * self._task.s.contacts)
        self._motions = c_double * (3 * self._task.s.blocks)

    def _index(self, block: Union[int, str]) -> int:
        if isinstance(block, str):
            for i, b in enumerate(self.blocks):
                if b.name == block:
                    return i
            raise KeyError("no block is named '%s'" % block)
        try:
            i = operator.index(block)
        except TypeError:
            raise TypeError("the name or the number of a block is expected, "
                            "read %s" % reprlib.repr(block)) from None
        if not -len(self.blocks) <= i < len(self.blocks):
            raise IndexError("block %d of %d" % (i, len(self.blocks)))
        return i % len(self.blocks)

    @property
    def contacts(self) -> List[Contact]:
        """The contact points of the structure."""
        n = self._task.s.contacts
        return [Contact._of(c) for c in self._held.contact[:n]]

    @property
    def mean_size(self) -> float:
        """Mean size of the free blocks [m]; a size is the root of an area."""
        return float(_mean_size(self._held.block, self._task.s.blocks))

    @_asks
    def touch(self, block: Union[int, str]) -> List[Contact]:
        """Returns the Contacts of a block with the blocks before it.

        block: its name or number"""
        i, room = self._index(block), 64
        while True:
            room *= 2
            out = (_Contact * room)()
            found = _touch(self._held.block, i, byref(self._task.options), out,
                           room, byref(self._held.work))
            if found != Status.NO_SPACE or room > 1000000:
                break
        return [Contact._of(c) for c in out[:self._check(found)]]

    @_asks
    def verdict(self, shrink: float = 0.0) -> Verdict:
        """Returns whether the structure stands, a Verdict with its proof.

        shrink: length by which contacts are shortened at each end [m]

        >>> bool(example().verdict()), example().verdict(0.4)
        (True, Verdict(stands=False))
        """
        force, motion = self._forces(), self._motions()
        status = _verdict(self._at_task, shrink,
                          byref(_Proof(addressof(force), addressof(motion))))
        if status < 0:
            self._check(status)
        return Verdict(status == _STANDS)._by(bytes(force), bytes(motion))

    @_asks
    def interval(self) -> Interval:
        """Returns the Interval in which the margin lies, given the errors of
        the poses. Raises KernError unless Options.measured() has set them.

        >>> wall = example()
        >>> wall.options = wall.options.measured(0.01, 0.01)
        >>> wall.update()
        >>> interval = wall.interval()
        >>> interval.low < 0.3 < interval.high, interval.surely_stands
        (True, True)
        """
        m, out, status = _Margin(), _Interval(), int(Status.NO_SPACE)
        if not self.options.pose_error > 0:
            raise KernError(Status.BAD_OPTION, text="interval() and certain(): "
                            "the errors of the poses are not known; "
                            "Options.measured() sets them")
        self._check(_measure(self._at_task, byref(m), None))
        task = _Task.from_buffer_copy(self._task)
        points = 2 * self._task.s.contacts + 12 * len(self.blocks)
        for _ in range(6):
            room = _Held(len(self.blocks), points)
            task.work = addressof(room.work)
            status = _certain(byref(task), m.margin, byref(out), room.contact,
                              points)
            if status != Status.NO_SPACE:
                break
            points *= 2
        self._check(status)
        return Interval(out.low, out.high, out.settles, status == _STANDS,
                        status == _FALLS)

    @_asks
    def certain(self) -> bool:
        """Returns whether the verdict is certain: interval().certain."""
        return self.interval().certain

    @_asks
    def raised(self, shrink: float = 0.0, reserve: bool = False) -> Raised:
        """Returns whether the load of the structure raises the forces that hold
        it, a Raised with its proof.

        shrink:  length by which contacts are shortened at each end [m]
        reserve: whether to search for the sideways push that it bears as well

        >>> raised = example().raised(reserve=True)
        >>> bool(raised), raised.raising.name, raised.reserve > 0.01
        (True, 'RAISED', True)
        """
        if reserve:
            self._pulls("raised(reserve=True)")
        force, motion = self._forces(), self._motions()
        raising, share = c_int(), c_double()
        stands = self._check(_raised(
            self._at_task, shrink, byref(raising),
            byref(share) if reserve else None,
            byref(_Proof(addressof(force), addressof(motion))))) == _STANDS
        return Raised(stands, Raising(raising.value) if stands else None,
                      share.value if stands and reserve else None,
                      self._end() if stands else End.NONE)._by(
                          bytes(force), bytes(motion))

    def _end(self) -> End:
        """Returns why the last search for raised forces ended."""
        return End(self._held.work.end)

    @_asks
    def let_go(self) -> LetGo:
        """Returns whether the structure stays when all blocks are released at
        once, from rest, a LetGo. A block that balances on its tip stays, too:
        raised() has the reserve, and 0.0055 g is usually enough. Where the
        limit of work is reached it raises nothing: `stays` is None and `why`
        is End.WORK.

        >>> box = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> low = Block("ground", [(-3, -1), (4, -1), (4, 0), (-3, 0)],
        ...             fixed=True), Block("low", box)
        >>> for x in (0.2, 0.7):
        ...     print(Structure([*low, Block("top", box).move(x, 1)])
        ...           .let_go().stays)
        True
        False
        """
        force, motion, how = self._forces(), self._motions(), c_int()
        status = _let_go(self._at_task, byref(how), byref(
            _Proof(addressof(force), addressof(motion))))
        if status == Status.LIMIT:
            return LetGo(None, End.WORK, Raising.NOT_SHOWN)
        if status != Status.UNDECIDED:
            self._check(status)
        stays = {_STANDS: True, _FALLS: False}.get(status)
        return LetGo(stays, End.NONE if stays is False else self._end(),
                     Raising(how.value))._by(bytes(force), bytes(motion))

    @_asks
    def stays(self, block: Union[int, str]) -> Optional[float]:
        """Returns the chance from 0 to 1 that a block, placed last, stays where
        it is released; None where the structure falls.

        block: its name or number; a fixed one raises ValueError

        >>> example().stays("top") > 0.9
        True
        """
        out, i = c_double(), self._index(block)
        if self.blocks[i].fixed:
            raise ValueError("'%s' is fixed" % self.blocks[i].name)
        self._pulls("stays()")
        status = self._check(_stays(self._at_task, i, byref(out)))
        return out.value if status == _STANDS else None

    def _side(self, ask: str, side: Any) -> Side:
        """Returns a side. Raises where a question to it has no answer."""
        if side not in (LEFT, RIGHT):
            raise KernError(Status.BAD_OPTION, text="%s: a side is LEFT or "
                            "RIGHT, read %r" % (ask, side))
        self._pulls(ask)
        return Side(side)

    def _load(self, ask: str, side: Any, pattern: Any) -> Tuple[Side, Any]:
        """Returns the side and the pattern of a load: one or the other."""
        if pattern is None:
            return self._side(ask, side), None
        if side != SHRINK:
            raise KernError(Status.BAD_OPTION, text="%s: a pattern takes the "
                            "place of a side: pass SHRINK, read %r"
                            % (ask, side))
        return SHRINK, _rows(pattern, len(self.blocks), 3, "a load pattern")

    def _pulls(self, ask: str) -> None:
        if not any(self.gravity):
            raise KernError(Status.BAD_OPTION,
                            text="%s: there is no gravity" % ask)

    def _least(self, shrink: float) -> Any:
        force = self._forces()
        status = _least_forces(self._at_task, shrink, addressof(force))
        if status != Status.UNDECIDED:
            self._check(status)
        return force if status == _STANDS else None

    @_asks
    def forces(self, shrink: float = 0.0) -> Optional[Array]:
        """Returns the least forces that hold the structure: normal and
        tangential force of each contact point [N], an array (n, 2). Returns
        None where there are none, or where rounding hides them.

        shrink: length by which contacts are shortened at each end [m]

        >>> len(example().forces())
        4
        """
        force = self._least(shrink)
        return None if force is None else _view(bytes(force), 2)

    @_asks
    def measure(self) -> Margin:
        """Returns margin and level, a Margin with its proof. Where the limit of
        work is reached, KernError.margin has the bounds that were proven.

        >>> margin = example().measure()
        >>> bool(margin), round(margin.margin, 6), margin.saturated
        (True, 0.3, False)
        """
        force, motion, m = self._forces(), self._motions(), _Margin()
        status = _measure(self._at_task, byref(m), byref(
            _Proof(addressof(force), addressof(motion))))
        if status == Status.LIMIT:
            error = KernError(status, (), self._held.work.fault)
            error.margin = Margin._of(m, False)
            raise error
        if status < 0:
            self._check(status)
        return Margin._of(m, status == _STANDS, bytes(force), bytes(motion))

    def _factor(self, ask: Callable[..., int], *arguments: Any
                ) -> Optional[Factor]:
        """The number that a function writes, with its proof."""
        out, force, motion = c_double(), self._forces(), self._motions()
        status = self._check(ask(self._at_task, *arguments, byref(out), byref(
            _Proof(addressof(force), addressof(motion)))))
        return (Factor._of(out.value, bytes(force), bytes(motion))
                if status == _STANDS else None)

    @_asks
    def deficit(self) -> float:
        """Returns the length [m] by which contacts would have to grow for the
        structure to stand: 0 where it stands, inf where no length helps.

        >>> round(example(0.75).deficit(), 6)
        0.25
        """
        out = c_double()
        status = self._check(_deficit(self._at_task, byref(out)))
        return out.value if status == _FALLS else 0.0

    @_asks
    def bearing(self) -> Optional[Factor]:
        """Returns the length [m] of the shortest contact that the structure
        needs, a Factor: inf where it needs none. Returns None where it falls
        with all of them. Unless contacts are given, each stretch of a hollow
        face is a contact of its own, also in the forces.

        >>> round(example().bearing(), 6)
        0.8
        """
        task, n = _Task.from_buffer_copy(self._task), len(self.blocks)
        points, found = task.s.contacts, int(Status.NO_SPACE)
        while self.given is None and found == Status.NO_SPACE:
            points = 2 * points + 12 * n
            held = _Held(n, points)
            task.work = addressof(held.work)
            found = _stretches(self._held.block, n, byref(task.options),
                               held.contact, points, task.work)
            task.s.contact = addressof(held.contact)
            task.s.contacts = found
        self._check(found if self.given is None else 0)
        out, motion = c_double(), self._motions()
        force = (c_double * (2 * task.s.contacts))()
        status = self._check(_bearing(byref(task), byref(out), byref(
            _Proof(addressof(force), addressof(motion)))))
        return (Factor._of(out.value, bytes(force), bytes(motion))
                if status == _STANDS else None)

    @_asks
    def load_factor(self, side: int, shrink: float = 0.0,
                    pattern: Optional[_Table] = None
                    ) -> Optional[Factor]:
        """Returns the largest factor of a load at which the structure stands, a
        Factor with its proof; inf above 1,000,000. Returns None where it falls
        without the load.

        side:    LEFT or RIGHT: a horizontal load of each block, its weight
                 times the factor
        shrink:  length by which contacts are shortened at each end [m]
        pattern: instead of a side, which is then SHRINK, (fx, fy, torque)
                 [N, N, N m] of each block

        This is limit analysis, which is too high where joints slide; use
        raised_load() there. Raises KernError for SHRINK without a pattern, and
        without gravity.

        >>> round(example().load_factor(RIGHT), 6)
        0.4
        """
        side, load = self._load("load_factor()", side, pattern)
        return (self._factor(_load_factor, shrink, side) if load is None else
                self._factor(_load_factor_of, shrink, load))

    @_asks
    def raised_load(self, side: int, shrink: float = 0.0,
                    pattern: Optional[_Table] = None
                    ) -> Optional[Factor]:
        """Returns the largest factor of a load for which equilibrium with
        Coulomb friction was found by raising the load from rest, a Factor. Its
        `why` is SHOWN where it equals load_factor(), otherwise the reason why
        it is less.

        side, shrink, pattern: as in load_factor(). Raises KernError, with
        Status.UNDECIDED where nothing is shown.

        >>> round(example().raised_load(RIGHT), 2)
        0.4
        """
        side, load = self._load("raised_load()", side, pattern)
        out = self._factor(_raised_load, shrink, side, load)
        if out is not None:
            out.why = self._end()
        return out

    @_asks
    def least_load(self, pattern: _Table,
                   shrink: float = 0.0) -> Optional[Factor]:
        """Returns the least multiple of a load at which the structure stands, a
        Factor: 0, without a motion, where it stands without the load. Returns
        None where it falls at every multiple.

        pattern: (fx, fy, torque) [N, N, N m] of each block
        shrink:  length by which contacts are shortened at each end [m]"""
        out = self._factor(_least_load_of, shrink, _rows(
            pattern, len(self.blocks), 3, "a load pattern"))
        if out is not None and float(out) == 0:
            out._motion = b""
        return out

    def live(self, loads: Optional[Iterable[Tuple[str, Point, Point]]] = None,
             shrink: float = 0.0, raised: bool = False) -> Optional[Factor]:
        """Returns the largest factor of a live load that the structure bears, a
        Factor; live_least() is the least. None where it falls at every factor.
        Both are those of limit analysis: where blocks slide or topple past each
        other the largest is too high and the least too low. Ask `raised`, or
        let_go() with the load on the blocks.

        loads:  tuples (name of a block, force [N], point [m]); None: `lives`,
                the loads of the file. Raises ValueError where there are none
        shrink: length by which contacts are shortened at each end [m]
        raised: whether to use raised_load() instead of load_factor()

        >>> round(example().live([("top", (1, 0), (0.7, 1))]), 4)
        3.924
        """
        pattern = self._live_pattern("live", loads)
        if raised:
            return self.raised_load(SHRINK, shrink, pattern)
        least = self.least_load(pattern, shrink)
        if least is None:
            return None
        if not least > 0:
            return self.load_factor(SHRINK, shrink, pattern)

        # It falls without the load: what it bears on top of the least.
        blocks = [b.copy() for b in self.blocks]
        for b, row in zip(blocks, pattern):
            if not b.fixed:
                b.load = (b.load[0] + least * row[0], b.load[1] + least * row[1],
                          b.load[2] + least * row[2])
        more = Structure(blocks, contacts=self.given, options=self.options,
                         gravity=self.gravity
                         ).load_factor(SHRINK, shrink, pattern)
        return more and Factor._of(least + more, more._force, more._motion)

    def live_least(self, loads: Optional[Iterable[Tuple[str, Point, Point]]]
                   = None, shrink: float = 0.0) -> Optional[Factor]:
        """Returns the least factor of a live load that holds the structure: 0
        where it stands without the load, None where it falls at every factor.

        loads, shrink: as in live()

        >>> box = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> wall = Structure([Block("ground", [(-3, -1), (4, -1), (4, 0),
        ...                                    (-3, 0)], fixed=True),
        ...                   Block("low", box),
        ...                   Block("top", box, mass=1).move(0.75, 1)])
        >>> round(wall.live_least([("top", (0, -1), (0.75, 2))]), 4)
        9.81
        """
        return self.least_load(self._live_pattern("live_least", loads), shrink)

    def _live_pattern(self, ask: str,
                      loads: Optional[Iterable[Tuple[str, Point, Point]]]
                      ) -> List[List[float]]:
        """Returns the wrench of a live load on each block; `ask` names the
        question."""
        pattern = [[0.0, 0.0, 0.0] for _ in self.blocks]
        index = {b.name: i for i, b in enumerate(self.blocks)}
        if loads is None and not self.lives:
            raise ValueError("no live load: %s([(NAME, FORCE, POINT), ...])"
                             % ask)
        for load in self.lives if loads is None else loads:
            try:
                name, force, at = load
            except (TypeError, ValueError):
                raise TypeError("%s(): (NAME, FORCE, POINT) is expected, read "
                                "%s" % (ask, reprlib.repr(load))) from None
            fx, fy = _several("%s(): the force" % ask, force, 2)
            x, y = _several("%s(): the point" % ask, at, 2)
            if name not in index:
                raise ValueError("no block is named %r" % name)
            if self.blocks[index[name]].fixed:
                raise ValueError("'%s' is fixed" % name)
            centre = self.blocks[index[name]].body().centre
            row = pattern[index[name]]
            row[0] += fx
            row[1] += fy
            row[2] += (x - centre[0]) * fy - (y - centre[1]) * fx
        return pattern

    @_asks
    def tilt(self, side: int, shrink: float = 0.0) -> Optional[Factor]:
        """Returns the angle [rad] by which gravity may turn until the structure
        falls, a Factor. Returns None where it falls as it is.

        side: LEFT or RIGHT

        >>> round(math.degrees(example().tilt(RIGHT)), 1)
        21.8
        """
        return self._factor(_tilt, shrink, self._side("tilt()", side))

    @_asks
    def profile(self, side: int = SHRINK) -> Profile:
        """Returns how far each block is from falling, a Profile.

        side: SHRINK: margins; LEFT or RIGHT: load factors

        >>> [round(value, 6) for value in example().profile().values]
        [inf, 0.5, 0.3]
        """
        side = SHRINK if side == SHRINK else self._side("profile()", side)
        value, c = (c_double * self._task.s.blocks)(), _Collapse()
        self._check(_profile(self._at_task, side, value, byref(c)))
        return Profile(value[:len(self.blocks)], c.least, c.mean, c.weak,
                       c.drop)

    @_asks
    def critical(self, margin: Optional[Margin] = None) -> Optional[Critical]:
        """Returns the contact that limits a margin and the blocks that move
        first, a Critical. Returns None where the margin is saturated.

        margin: the result of measure(); None: it is measured here

        >>> critical = example().critical()
        >>> critical.meetings[critical.contact], critical.groups
        ('hinges', [[2]])
        """
        margin = self.measure() if margin is None else margin
        if not isinstance(cast(object, margin), Margin):
            raise TypeError("critical(): a Margin is expected, read %s"
                            % reprlib.repr(margin))
        if margin.motion is None:
            return None
        n = self._task.s.contacts
        limit, meeting = (c_double * n)(), (c_int * n)()
        group = (c_int * len(self.blocks))()
        c = _Critical(addressof(meeting), addressof(limit), addressof(group))
        held = margin.forces
        force = (None if held is None
                 else _rows(held.tolist(), n, 2, "forces"))
        motion = _rows(margin.motion.tolist(), len(self.blocks), 3, "a motion")
        self._check(_critical_of(
            self._at_task, margin.margin, byref(_Proof(
                addressof(force) if force else None, addressof(motion))),
            byref(c)))
        names = ("rests", "hinges", "slides", "opens")
        groups: List[List[int]] = [[] for _ in range(c.groups)]
        members: List[int] = list(group)
        for i, g in enumerate(members):
            if g >= 0:
                groups[g].append(i)
        return Critical(c.contact if c.contact >= 0 else None,
                        list(limit), [names[k] for k in meeting], groups)

    @_asks
    def sensitivity(self) -> Tuple[List[ContactRate], List[BlockRate]]:
        """Returns how the margin depends on every contact point and every
        block, lists of ContactRate and BlockRate.

        >>> round(example().sensitivity()[1][2].place[0], 4)
        -1.0
        """
        s, m = self._task.s, self.measure()
        c = _Margin(m.margin, m.holds, m.fails, m.most, m.epsilon, m.level,
                    m.saturated)
        force, motion = _doubles(m._force), _doubles(m._motion)
        points = (_ContactRate * s.contacts)()
        blocks = (_BlockRate * s.blocks)()
        self._check(_sensitivity(
            self._at_task, byref(c), byref(_Proof(
                addressof(force), addressof(motion))), points, blocks))
        return ([ContactRate((r.p.x, r.p.y), r.turn, r.mu, r.travel)
                 for r in points],
                [BlockRate((r.centre.x, r.centre.y), (r.place.x, r.place.y),
                           r.turn, r.mass, (r.load.fx, r.load.fy, r.load.torque))
                 for r in blocks])

    @_asks
    def check_forces(self, forces: _Table,
                     shrink: float = 0.0) -> float:
        """Returns the error of a proof: these forces prove that the structure
        stands if it is at most 1.

        forces: normal and tangential force of each contact point [N], (n, 2)
        shrink: length by which contacts are shortened at each end [m]"""
        return float(_check_forces(self._at_task, shrink, _rows(
            forces, self._task.s.contacts, 2, "forces")))

    @_asks
    def check_motion(self, motion: _Table,
                     shrink: float = 0.0) -> float:
        """Returns the error of a proof: this motion proves that the structure
        falls if it is at most 1.

        motion: vx, vy and spin of each block, (n, 3)
        shrink: length by which contacts are shortened at each end [m]"""
        return float(_check_motion(self._at_task, shrink, _rows(
            motion, self._task.s.blocks, 3, "a motion")))

    @_asks
    def check_raised(self, raised: Union[Raised, LetGo],
                     shrink: float = 0.0) -> float:
        """Returns the error of a proof: the forces and the motion of raised()
        or let_go() are proven if it is at most 1. Where let_go() has found that
        a structure moves and no block hangs, check_motion() checks the
        proof."""
        if not isinstance(cast(object, raised), (Raised, LetGo)):
            raise TypeError("check_raised(): a Raised or a LetGo is expected, "
                            "read %s" % reprlib.repr(raised))
        how = raised.how if isinstance(raised, LetGo) else raised.raising
        force = _rows(_view(raised._force or b"", 2).tolist(),
                      self._task.s.contacts, 2, "forces")
        motion = _rows(_view(raised._motion or b"", 3).tolist(),
                       self._task.s.blocks, 3, "a motion")
        proof = _Proof(addressof(force), addressof(motion))
        return float(_check_raised(self._at_task, shrink,
                                   how or Raising.NOT_SHOWN, byref(proof)))

    @_asks
    def svg(self, shrink: float = 0.0, mechanism: bool = False,
            profile: bool = False, caption: Optional[str] = None) -> str:
        """Returns a picture as SVG: stones, contacts, the least forces where
        the structure stands, all mechanisms where it falls.

        shrink:    length by which contacts are shortened at each end [m]
        mechanism: also the motion just past the margin
        profile:   colours the stones by their margins
        caption:   the line below; None: the verdict and its numbers

        Where no block is free, as in an empty plan, the picture shows the
        ground alone."""
        if all(block.fixed for block in self.blocks):
            return self._picture(shrink, "%s: no block is free" % self.name
                                 if caption is None else caption)
        verdict, m = self.verdict(shrink), self.measure()
        least = self._least(shrink) if verdict else None
        force = least or (_doubles(verdict._force) if verdict else None)
        moves = _doubles(verdict._motion if not verdict
                         else None if m.saturated else m._motion)
        if not verdict:
            _falls(self._at_task, shrink, moves)
        critical = self.critical(m)
        limiting = critical.contact if critical else None
        if caption is None:
            caption = "%s: %s%s; level %d, %s" % (
                self.name, "stands" if verdict else "falls",
                " when shrunk by %.4g" % shrink if shrink > 0 else "", m.level,
                "margin %.4g" % m.margin if m.stands
                else "deficit %.4g" % self.deficit())
        return self._picture(
            shrink, caption, force, b"least forces" if least else None,
            moves if mechanism or not verdict else None, moves,
            m.fails if verdict else shrink,
            b"collapse mechanism just past the margin" if verdict else None,
            -1 if limiting is None else limiting,
            self.profile().values if profile else None)

    def _picture(self, shrink: float, caption: str, force: Any = None,
                 force_name: Optional[bytes] = None, motion: Any = None,
                 hinges: Any = None, hinged: float = 0.0,
                 motion_name: Optional[bytes] = None, limiting: int = -1,
                 values: Optional[Sequence[float]] = None) -> str:
        """Returns the picture of struct draw_scene (examples/parts/draw.h)."""
        names = (c_char_p * len(self.blocks))(
            *(b.name.encode() for b in self.blocks))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "picture.svg")
            if _draw(os.fsencode(path), byref(self._task.s), names,
                     self.options.relative, shrink, force, force_name, motion,
                     hinges, hinged, motion_name, limiting,
                     _numbers(values) if values else None,
                     max((v for v in values or () if v < math.inf), default=0),
                     str(caption).encode(),
                     _rows(self._live_pattern("svg", None), len(self.blocks), 3,
                           "a live load") if self.lives else None):
                raise OSError("cannot write %s" % path)
            return pathlib.Path(path).read_text(encoding="utf-8")

    def plot(self, ax: Any = None) -> Any:
        """Draws stones, their names, contact points and, in red, the one that
        limits the margin, into axes of matplotlib. Returns the axes.

        ax: the axes; None: the current ones"""
        if ax is None:
            ax = importlib.import_module("matplotlib.pyplot").gca()
        for block in self.blocks:
            x, y = zip(*block.vertices.tolist())
            ax.fill(x, y, facecolor="0.6" if block.fixed else "#e8dcc0",
                    edgecolor="0.2", linewidth=0.8)
            ax.annotate(block.name, block.body().centre, ha="center",
                        va="center", fontsize="small")
        title, contacts = "no block is free", self.contacts
        ax.plot([c.p[0] for c in contacts], [c.p[1] for c in contacts], "k.",
                markersize=3)
        if not all(block.fixed for block in self.blocks):
            margin = self.measure()
            title = ("stands, margin %.4g" % margin.margin if margin else
                     "falls, deficit %.4g" % self.deficit())
            critical = self.critical(margin)
            if critical is not None and critical.contact is not None:
                ax.plot(*contacts[critical.contact].p, "ro", markersize=6)
        ax.set_aspect("equal")
        ax.set_title("%s: %s" % (self.name, title))
        return ax

    def to_shapely(self) -> Any:
        """Returns the blocks as a GeometryCollection of shapely, in their
        order: its `geoms` are Polygons. Blocks that touch share parts of their
        edges, which the parts of a valid MultiPolygon do not."""
        return importlib.import_module("shapely.geometry").GeometryCollection(
            [block.to_shapely() for block in self.blocks])

    def _repr_svg_(self) -> str:
        """For notebooks, whose pages take no XML declaration."""
        text = self.svg()
        return text[text.index("<svg"):]

    def text(self) -> str:
        """Returns the structure in the format of text files. parse() makes a
        structure of it that has the same answers. Blanks in names become
        underscores. The text has these options: friction, epsilon, gap and
        angle, or the errors of measured()."""
        o, lines = self.options, ["friction %r" % self.options.mu]
        used: Dict[str, int] = {}
        names = [_unique(re.sub(r"[\s#]+", "_", b.name) or "block", used)
                 for b in self.blocks]
        lines.append("gravity %r %r" % tuple(map(float, self.gravity)))
        if o.epsilon:
            lines.append("epsilon %r" % o.epsilon)
        if self.units:
            lines.append("units %s" % self.units)
        if o.pose_error:
            lines.append("measured %r %r" % (o.pose_error, o.pose_turn))
        elif o.gap:
            lines.append("tolerance %r %r" % (o.gap, o.angle))
        elif o.angle != _D.angle:
            raise ValueError("an angle without a gap has no place in a file")
        for name, b in zip(names, self.blocks):
            place = "  ".join("%r %r" % (x, y) for x, y in b.vertices.tolist())
            if b.fixed:
                lines.append("fixed %s  %s" % (name, place))
                continue
            lines.append("block %s %r  %s" % (name, b.body().mass, place))
            if b.centre is not None:
                lines.append("com %s %r %r" % (name, *map(float, b.centre)))
            if any(b.load[:2]):
                lines.append("load %s %r %r %r %r" % (
                    name, *map(float, b.load[:2]), *b.body().centre))
            if b.load[2]:
                lines.append("torque %s %r" % (name, float(b.load[2])))
        given = {b.name: name for b, name in zip(self.blocks, names)}
        lines += ["live %s %r %r %r %r" % (given[name], *map(float, force),
                                           *map(float, at))
                  for name, force, at in self.lives]
        lines += self._contact_lines(names)
        return "\n".join(lines) + "\n"

    def _contact_lines(self, names: List[str]) -> List[str]:
        lines: List[str] = []
        given, i = list(self.given or ()), 0
        while i < len(given):
            c, ends = given[i], [given[i].p]
            if c.line:
                i += 1
                if i == len(given):
                    raise ValueError("contact point %d: a line contact has two"
                                     % (i - 1))
                ends.append(given[i].p)
            i += 1
            lines.append("contact %s %s %r %r %s mu %r" % (
                names[c.a], names[c.b], *map(float, c.n),
                " ".join("%r %r" % (x, y) for x, y in ends), c.mu))
        return lines

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes text() to a file."""
        pathlib.Path(path).write_text(self.text(), encoding="utf-8")


class Place(NamedTuple):
    """A place for one more stone, as Plan.places() ranks them.

    block:  the stone at that place
    x:      where its centre was let down [m]
    turn:   by which it was turned [rad]
    stays:  the chance from 0 to 1 that it stays there
    margin: the margin of the structure with it [m]
    own:    the stone's own margin in the profile [m]
    load:   the least load factor of the structure with it

    own and load are 0 where stays and margin tell it from every other place."""
    block: Block
    x: float
    turn: float
    stays: float
    margin: float
    own: float = 0.0
    load: float = 0.0

    def _c(self, whole: bool = True) -> "_Place":
        """Returns it for kern_place_compare(); not whole: stays and margin."""
        return _Place(self.stays, self.margin, *(
            (self.own, self.load, self.x, self.turn) if whole else
            (0, 0, 0, 0)))


class Plan(Structure):
    """A structure that grows by one block at a time, and answers quickly for a
    block that might be the next.

    blocks, options, gravity, name: as for a Structure

    Its blocks are copies that cannot be changed; add() and remove() change the
    plan. try_(), bears() and try_stays() answer for the plan with one more
    block, and leave the plan as it is. A block that overlaps another raises
    nothing there: its margin is nan and it is not borne. Call update() after a
    change of options or gravity.

    >>> box = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> plan = Plan([Block("ground", [(-3, -1), (4, -1), (4, 0), (-3, 0)],
    ...                    fixed=True), Block("low", box)])
    >>> plan.measure().margin
    0.5
    >>> stone = Block("top", box).move(0, 1)
    >>> for step in range(5):
    ...     print(round(plan.try_(stone.move(0.1, 0)).margin, 4),
    ...           bool(plan.bears(stone, 0.25)))
    0.4 True
    0.3 True
    0.2 False
    0.1 False
    0.0 False
    >>> plan.add(stone.move(-0.4, 0)), round(plan.measure().margin, 4)
    (2, 0.4)
    >>> plan.remove("top")
    >>> [block.name for block in plan.blocks]
    ['ground', 'low']
    """

    def __init__(self, blocks: Iterable[Block] = (), *,
                 options: Optional[Options] = None,
                 gravity: Point = (0.0, -9.81), name: str = "plan"):
        super().__init__(blocks, options=options, gravity=gravity, name=name)

    def _key(self) -> Any:
        return self.options.__dict__.copy(), self.gravity

    def _fresh(self) -> None:
        if self._key() != self._told or (
                len(self.blocks) != self._plan.task.s.blocks):
            raise KernError(Status.STALE, text="the list of blocks, options or "
                            "gravity have changed")

    def update(self) -> None:
        """Adds all blocks again, with the present options and gravity."""
        with self._lock:
            before = dict(self.__dict__)
            blocks = list(self.blocks)
            try:
                self.blocks = []
                self._candidate = _Block()
                self._told = self._key()
                self._grow(16, 256)
                for block in blocks:
                    self.add(block)
            except Exception:
                self.__dict__.clear()
                self.__dict__.update(before)
                raise

    def _grow(self, blocks: int, contacts: int) -> None:
        """Moves the plan to arrays for so many."""
        old, held = getattr(self, "_held", None), _Held(blocks, contacts)
        before: Any = getattr(self, "_plan", None)
        motion = (c_double * (3 * blocks))()
        force = (c_double * (2 * contacts))()
        plan = _plan_of(held.block, blocks, held.contact, contacts,
                        _known_of(motion, force), byref(held.work))
        plan.task.options = self.options._c()
        plan.task.s.gravity = _Vec(*_several("gravity", self.gravity, 2))
        if old is not None and self.blocks:
            self._check(_plan_copy(byref(plan), byref(before)))
            held.vertex.extend(old.vertex)
        self._held, self._plan, self._known = held, plan, (motion, force)
        self._task = self._plan.task
        self._at_task, self._at_plan = byref(self._task), byref(self._plan)
        self._shape()

    def _ask(self, function: Any, block: Block, *arguments: Any) -> int:
        """Asks about one more block, in larger arrays where these are full."""
        self._fresh()
        _block(block)._fill(self._candidate)
        return self._asked(function, block, *arguments)

    def _asked(self, function: Any, block: Block, *arguments: Any) -> int:
        while True:
            status = int(function(self._at_plan, byref(self._candidate),
                                  *arguments))
            room = self._plan.block_room, self._plan.contact_room
            if status >= 0:
                return status
            if status != Status.NO_SPACE or room[0] > 20000:
                every = [*self.blocks, block]
                raise KernError(
                    status, [b.name for b in every], self._held.work.fault,
                    overlaps=overlaps(every, options=self.options)
                    if status == Status.OVERLAP and function is _plan_add
                    else ())
            self._grow(2 * room[0], 2 * room[1])

    def add(self, block: Block) -> int:
        """Adds a copy of a block. Returns how many contact points it has.
        Raises KernError where it is refused, with all pairs that overlap, and
        ValueError where its name is taken; the plan is then unchanged."""
        with self._lock:
            self._fresh()
            _name_once([*self.blocks, _block(block)])
            own = _Kept(block.name, block.vertices.tolist(), block.density,
                        block.fixed, block.mass, block.centre, block.load)
            vertex = own._copy_to(self._candidate)
            contacts = self._asked(_plan_add, own)
            self._held.vertex.append(vertex)
            self.blocks.append(own)
            self._shape()
            return contacts

    def remove(self, block: Union[int, str]) -> None:
        """Removes a block. The numbers of the blocks after it fall by 1.

        block: its name or number"""
        with self._lock:
            self._fresh()
            i = self._index(block)
            self._check(_plan_remove(self._at_plan, i))
            del self.blocks[i], self._held.vertex[i]
            self._shape()

    def try_(self, block: Block) -> Margin:
        """Returns the result of measure() with the block added, a Margin
        without a proof. Where the block overlaps another the Margin is false,
        its margin is nan and its `refused` is the error.

        >>> plan = Plan(example().blocks)
        >>> bool(plan.try_(Block("third", [(0, 2), (1, 2), (1, 3), (0, 3)])))
        True
        """
        with self._lock:
            m = _Margin()
            try:
                status = self._ask(_plan_try, block, byref(m), None)
            except KernError as error:
                if error.status != Status.OVERLAP:
                    raise
                nan = math.nan
                return Margin(False, nan, nan, nan, nan, nan, -1, False, error)
            return Margin._of(m, status == _STANDS)

    def tries(self, block: Block, poses: Any) -> Any:
        """Returns the margins with the block at many poses, by try_(): 0 where
        it falls, nan where it overlaps or is undecided.

        poses: (x, y, turn) [m, m, rad] each: the block is turned about its
        centre of mass, then shifted, as by Block.move()

        >>> box = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> plan = Plan([Block("ground", [(-3, -1), (4, -1), (4, 0), (-3, 0)],
        ...                    fixed=True), Block("low", box)])
        >>> plan.measure().stands
        True
        >>> [round(m, 6) for m in plan.tries(Block("top", box),
        ...                                  [(0, 1, 0), (.2, 1, 0), (2, 0, 0)])]
        [0.5, 0.3, 0.5]
        """
        rows = poses.tolist() if hasattr(poses, "tolist") else list(poses)
        own = _block(block).copy()
        vertices, (cx, cy) = own.vertices.tolist(), own.body().centre
        out: List[float] = []
        for row in rows:
            x, y, turn = _several("a pose", row, 3)
            cos, sin = math.cos(turn), math.sin(turn)
            for i, (px, py) in enumerate(vertices):
                px, py = px - cx, py - cy
                own.vertices[i, 0] = cx + cos * px - sin * py + x
                own.vertices[i, 1] = cy + sin * px + cos * py + y
            if own.centre is not None:
                own.centre = (cx + x, cy + y)
            try:
                out.append(self.try_(own).margin)
            except KernError as error:
                if error.status != Status.UNDECIDED:
                    raise
                out.append(math.nan)
        return numpy.array(out) if numpy is not None else out

    @_numeric
    def bears(self, block: Block, margin: float) -> bool:
        """Returns whether the margin [m] with the block added is at least this;
        False where it overlaps another. Quicker than try_()."""
        with self._lock:
            try:
                return self._ask(_plan_bears, block, margin, None) == _STANDS
            except KernError as error:
                if error.status != Status.OVERLAP:
                    raise
                return False

    def try_raised(self, block: Block, reserve: bool = False) -> Raised:
        """Returns the result of raised() with the block added, a Raised without
        a proof. Raises KernError where it overlaps another."""
        with self._lock:
            raising, share = c_int(), c_double()
            stands = self._ask(
                _plan_raised, block, byref(raising),
                byref(share) if reserve else None, None) == _STANDS
            return Raised(stands, Raising(raising.value) if stands else None,
                          share.value if stands and reserve else None,
                          self._end() if stands else End.NONE)

    def try_stays(self, block: Block) -> Optional[float]:
        """Returns the chance from 0 to 1 that the block stays where it is
        released on the plan; None where the plan falls with it or it overlaps
        another.

        >>> box = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> plan = Plan([Block("ground", [(-3, -1), (4, -1), (4, 0), (-3, 0)],
        ...                    fixed=True), Block("low", box)])
        >>> for x in (0, .4995, .51):
        ...     chance = plan.try_stays(Block("top", box).move(x, 1))
        ...     print(chance and chance > 0.5)
        True
        False
        None
        """
        if _block(block).fixed:
            raise ValueError("'%s' is fixed" % block.name)
        self._pulls("try_stays()")
        with self._lock:
            chance = c_double()
            try:
                stands = self._ask(_plan_stays, block,
                                   byref(chance)) == _STANDS
            except KernError as error:
                if error.status != Status.OVERLAP:
                    raise
                return None
            return chance.value if stands else None

    @_numeric
    def rest(self, block: Block, x: float, turn: float = 0.0
             ) -> Optional[Block]:
        """Returns the block where it comes to rest when it is let down on the
        plan. Returns None where it falls past the plan or does not stop
        rolling. try_() tells whether the plan stands with it there. Raises
        KernError.

        block: the stone, at any height
        x:     where its centre is let down [m]
        turn:  by which it is turned first [rad], counter-clockwise

        >>> plan = Plan([Block("ground", [(-3, -1), (4, -1), (4, 0), (-3, 0)],
        ...                    fixed=True)])
        >>> box = Block("box", [(0, 0), (2, 0), (2, 1), (0, 1)])
        >>> at = plan.rest(box, 0.5, 0.1)
        >>> [round(y, 6) + 0 for x, y in at.vertices.tolist()]
        [0.0, 0.0, 1.0, 1.0]
        >>> plan.rest(box, 9) is None
        True
        """
        (turn,) = _several("turn", [turn], 1)
        if not math.isfinite(turn):
            raise ValueError("turn: a finite angle is expected, read %r"
                             % turn)
        with self._lock:
            self._fresh()
            _block(block)._fill(self._candidate)
            vertex = (_Vec * self._candidate.vertices)()
            pose = _Pose()
            status = _rest(byref(self._plan.task), byref(self._candidate), x,
                           _Vec(math.cos(turn), math.sin(turn)), vertex,
                           byref(pose))
            if status in (Status.NO_SUPPORT, Status.NO_REST):
                return None
            if status < 0:
                raise KernError(status, [b.name for b in [*self.blocks, block]],
                                self._held.work.fault)
        centre = pose.block.centre
        return Block(block.name, [(v.x, v.y) for v in vertex], block.density,
                     block.fixed, block.mass, block.centre
                     and (centre.x, centre.y), block.load)

    def places(self, block: Block, xs: Iterable[float],
               turns: Iterable[float] = (0.0,)) -> List[Place]:
        """Returns the places where the structure stands with the block let
        down, the best first: by the chance that it stays, then by the margin,
        the stone's own margin and the load factor.

        block: the stone, at any height
        xs:    where its centre is let down [m]
        turns: by which it is turned [rad]; all are tried at each x

        >>> ground = Block("ground", [(-3, -1), (4, -1), (4, 0), (-3, 0)],
        ...                fixed=True)
        >>> box = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> plan = Plan([ground, Block("low", box)])
        >>> for place in plan.places(Block("top", box), (0.7, 0.5, 0.6)):
        ...     print(place.x, round(place.margin, 3), place.stays > 0.9)
        0.5 0.5 True
        0.6 0.4 True
        0.7 0.3 True
        """
        xs, turns = list(xs), list(turns)
        try:
            alone = self.measure().margin
        except KernError as e:
            if e.status != Status.NO_FREE:
                raise
            alone = 0.0  # bare ground
        found: List[Place] = []
        for x in xs:
            for turn in turns:
                at = self.rest(block, x, turn)
                m = self.try_(at) if at else None
                stays = self.try_stays(at) if at and m else None
                if at and m and stays is not None:
                    found.append(Place(at, x, turn, stays, m.margin))

        def better(p: Place, q: Place, whole: bool = True) -> int:
            return int(_place_compare(byref(q._c(whole)), byref(p._c(whole)),
                                      alone))
        found = [self._complete(p) if any(
            q is not p and better(p, q, False) == 0 for q in found) else p
            for p in found]
        return sorted(found, key=functools.cmp_to_key(better))

    def _complete(self, place: Place) -> Place:
        """Returns the place with own and load, 0 where a limit ends them."""
        with self._lock:
            self._ask(_plan_add, place.block)
            task, n = byref(self._plan.task), self._plan.task.s.blocks
            value, side = (c_double * n)(), (c_double * 2)()
            own = _profile(task, SHRINK, value, byref(_Collapse())) >= 0
            load = all(_load_factor(task, 0, to, byref(side, 8 * i), None)
                       == _STANDS for i, to in enumerate((LEFT, RIGHT)))
            self._check(_plan_remove(self._at_plan, n - 1))
        return place._replace(own=value[n - 1] if own else 0.0,
                              load=min(side) if load else 0.0)


def overlaps(blocks: Iterable[Block], *, options: Optional[Options] = None
             ) -> List[Tuple[str, str, float, float]]:
    """Returns all pairs of blocks that overlap too deeply, a tuple each: two
    names, the depth [m] and the depth that is allowed [m]. Raises KernError.

    >>> box = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> overlaps([Block("a", box), Block("b", box).move(0.5, 0)])[0][:2]
    ('a', 'b')
    """
    blocks = [_block(b, "block %d: " % i) for i, b in enumerate(blocks)]
    made = (_Block * len(blocks))()
    for i, block in enumerate(blocks):
        block._fill(made[i])
    index = (c_int * (2 * len(blocks)))()
    work = _Work(None, 0, addressof(index), len(index))
    told = _asked_options(options)._c()
    found, out = 0, (_Overlap * 0)()
    for _ in range(2):
        out = (_Overlap * found)()
        found = _overlaps(made, len(made), byref(told), out, len(out),
                          byref(work))
        if found < 0:
            raise KernError(found, [b.name for b in blocks], work.fault)
    return [(blocks[int(o.a)].name, blocks[int(o.b)].name, o.depth, o.allowed)
            for o in out]


def example(shift: float = 0.2) -> Structure:
    """Returns the wall of the examples: a box of 1 m on a box on the ground,
    the upper one shifted to the right. Its margin is 0.5 - shift."""
    box = [(0, 0), (1, 0), (1, 1), (0, 1)]
    return Structure([
        Block("ground", [(-3, -1), (4, -1), (4, 0), (-3, 0)], fixed=True),
        Block("low", box), Block("top", box).move(shift, 1)], name="example")


# ---- Many structures ---------------------------------------------------------


@dataclass(eq=False)
class Many(_Answer):
    """The answers of many(), an entry for each structure.

    status: Status.STANDS or FALLS; below 0 the reason why there is no answer
    margin: how far contacts can shrink [m]; 0 where it falls, nan without an
            answer
    level:  steps of epsilon at which it stands; -1 without an answer
    loads:  load factors to the left and right, (n, 2); 0 where it falls; None
            without loads=True
    mechanisms: vx, vy and spin of each block just past the margin, (n, blocks,
            3); nan where nothing moves; None without mechanisms=True"""
    status: Any
    margin: Any
    level: Any
    loads: Any = None
    mechanisms: Any = None

    def __len__(self) -> int:
        return len(self.status)

    @property
    def stands(self) -> Any:
        """Whether each structure stands: an array, or a list, of bools."""
        if numpy is not None:
            return self.status == _STANDS
        return [status == _STANDS for status in self.status]


def _flat(values: Any, count: int, what: str) -> Any:
    """Returns nested numbers as a flat array of `count` doubles."""
    try:
        if numpy is not None:
            out = numpy.ascontiguousarray(values, numpy.float64).reshape(-1)
        else:
            out, rest = _array("d"), [iter((values,))]
            while rest:
                for value in rest[-1]:
                    if isinstance(value, (int, float)):
                        out.append(value)
                    elif isinstance(value, (str, bytes)):
                        raise TypeError
                    else:
                        rest.append(iter(value))
                        break
                else:
                    rest.pop()
    except (TypeError, ValueError, OverflowError):
        raise TypeError("many(): %s: numbers are expected, in rows of equal "
                        "length, read %s" % (what, reprlib.repr(values))
                        ) from None
    if len(out) != count:
        raise ValueError("many(): %s has %d numbers, %d are expected"
                         % (what, len(out), count))
    return out


def _address(values: Any) -> Optional[int]:
    """Returns where the numbers of _flat() or _blank() lie."""
    if values is None:
        return None
    return int(values.ctypes.data if numpy is not None
               else values.buffer_info()[0])


def _blank(kind: str, count: int, value: float) -> Any:
    """Returns an array of `count` equal numbers: "d" doubles, "i" ints."""
    if numpy is not None:
        return numpy.full(count, value, numpy.dtype(kind))
    return _array(kind, [value]) * count


def _poses(wall: Structure, poses: Any, count: int) -> Any:
    """Returns poses of all blocks: those that are not named stay."""
    n = len(wall.blocks)
    if not isinstance(poses, dict):
        return _flat(poses, 3 * n * count, "poses")
    out = _blank("d", 3 * n * count, 0.0)
    named = cast(Dict[str, Any], poses)
    for name, rows in named.items():
        start, own = 3 * wall._index(name), _flat(rows, 3 * count, name)
        for k in range(3):
            out[start + k::3 * n] = own[k::3]
    return out


def _length(name: str, rows: Any) -> int:
    try:
        return len(rows)
    except TypeError:
        raise TypeError("many(): %s: a list or an array is expected, read %s"
                        % (name, reprlib.repr(rows))) from None


def many(wall: Structure, *, poses: Any = None,
         mu: Optional[_Numbers] = None,
         stones: Optional[Sequence[Block]] = None, loads: bool = False,
         mechanisms: bool = False, threads: Optional[int] = None) -> Many:
    """Returns verdicts and margins of many structures that differ from one
    wall, as Many.

    Each structure is solved by itself, in C: its answer depends neither on the
    others nor on the number of threads. A structure whose blocks overlap, or
    that is undecided, has a status below 0 and the margin nan.

    wall:   a Structure or a Plan whose contacts are found, not given
    poses:  x [m], y [m] and turn [rad] of each block of each structure, an
            array (n, blocks, 3), or a dict of names of blocks with arrays (n,
            3): a block is turned about its centre of mass, then shifted
    mu:     n frictions, tan(friction angle)
    stones: n blocks; each is added to one structure, as its last
    loads:  whether to return the load factors to the left and right
    mechanisms: whether to return the motion of every block
    threads: number of threads; None: one for each processor

    Raises ValueError where lengths differ or nothing is given, KernError where
    a stone is refused, MemoryError.

    >>> box = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> wall = Structure([Block("ground", [(-3, -1), (4, -1), (4, 0), (-3, 0)],
    ...                         fixed=True),
    ...                   Block("low", box), Block("top", box).move(0, 1)])
    >>> out = many(wall, poses={"top": [(0, 0, 0), (.35, 0, 0), (.7, 0, 0),
    ...                                 (0, -.5, 0)]}, loads=True)
    >>> [round(margin, 6) for margin in out.margin]
    [0.5, 0.15, 0.0, nan]
    >>> [bool(stands) for stands in out.stands], Status(out.status[3]).name
    ([True, True, False, False], 'OVERLAP')
    >>> round(out.loads[1][1], 6)
    0.3
    """
    if not isinstance(cast(object, wall), Structure):
        raise TypeError("many(): a Structure or a Plan is expected, read %s"
                        % reprlib.repr(wall))
    each: Any = poses
    if isinstance(poses, dict) and poses:
        each = next(iter(cast(Dict[str, Any], poses).values()))
    given: Dict[str, Any] = {"poses": each, "mu": mu, "stones": stones}
    lengths = {name: _length(name, rows) for name, rows in given.items()
               if rows is not None}
    if len(set(lengths.values())) != 1:
        raise ValueError("many(): give poses, mu or stones, as many of each; "
                         "read %s" % (lengths or "none"))
    with wall._lock:
        wall._fresh()
        if wall.given is not None:
            raise ValueError("many(): contacts are given, which do not move "
                             "with the blocks")
        n, count = len(wall.blocks), lengths.popitem()[1]
        width = n + (stones is not None)
        own = [(b.mass is not None) + 2 * (b.centre is not None)
               for b in wall.blocks]
        stone = (_Block * count)()
        for block, made in zip(stones or (), stone):
            _block(block, "many(): stones: ")._fill(made)

        # What goes in and what comes out; the arrays live until C is done.
        options = wall.options._c()
        density = (c_double * n)(*(b.density for b in wall.blocks))
        owned = (c_int * n)(*own)
        pose = None if poses is None else _poses(wall, poses, count)
        friction = None if mu is None else _flat(mu, count, "mu")
        status, level = _blank("i", count, -1), _blank("i", count, -1)
        margin = _blank("d", count, math.nan)
        load = _blank("d", 2 * count, math.nan) if loads else None
        motion = (_blank("d", 3 * width * count, math.nan) if mechanisms
                  else None)
        cases = _Cases(
            addressof(wall._task.s), addressof(options), addressof(density),
            addressof(owned), _address(pose), _address(friction),
            addressof(stone) if stones is not None else None,
            *map(_address, (status, level, margin, load, motion)))

        # Threads take parts in turn: ctypes lets others run meanwhile.
        (asked,) = _several("many(): threads", [threads or 0], 1)
        workers = max(1, min(int(asked) or os.cpu_count() or 1, count))
        part = -(-count // (8 * workers)) if workers > 1 else max(count, 1)

        def run(first: int) -> int:
            return int(_many(byref(cases), first, min(first + part, count)))
        starts = range(0, count, part)
        if workers == 1:
            done = [run(first) for first in starts]
        else:
            with ThreadPoolExecutor(workers) as pool:
                done = list(pool.map(run, starts))
    if not all(done):
        raise MemoryError("many()")
    return Many(status, margin, level, _shaped(load, (count, 2)),
                _shaped(motion, (count, width, 3)))


def _shaped(values: Any, shape: Tuple[int, ...]) -> Any:
    """Returns an array of rows, or of arrays of rows."""
    if values is None:
        return None
    if numpy is not None:
        return values.reshape(shape)
    if len(shape) == 2:
        return _rows_of(values, shape[1])
    size = shape[1] * shape[2]
    return [_rows_of(values[i * size:(i + 1) * size], shape[2])
            for i in range(shape[0])]


# ---- Text files, drawings, photographs ---------------------------------------


def _structure_of(t: _Text, name: str) -> Structure:
    """The structure that was read."""
    blocks: List[Block] = []
    for i in range(t.blocks):
        c = t.block[i]
        points = (_Vec * c.vertices).from_address(c.vertex)
        block = Block(t.name[i].decode(errors="replace"),
                      [(p.x, p.y) for p in points], fixed=bool(c.fixed),
                      load=(c.load.fx, c.load.fy, c.load.torque))
        own, centre = block.body(), (c.centre.x, c.centre.y)
        if own.mass != c.mass and not block.fixed:
            block.mass = c.mass
        if own.centre != centre:
            block.centre = centre
        blocks.append(block)
    given = [Contact._of(c) for c in t.contact[:t.contacts]]
    options = Options._of(t.options)
    if t.error:
        options = options.measured(t.error, t.turn or t.error / _mean_size(
            t.block, t.blocks))
    out = Structure(blocks, contacts=given if t.given else None,
                    options=options, gravity=(t.gravity.x, t.gravity.y),
                    name=name)
    out.lives = [(blocks[int(a.block)].name, (a.force.x, a.force.y),
                  (a.place.x, a.place.y)) for a in t.axle[:t.lives]]
    out.units = t.units.decode(errors="replace") if t.units else None
    if t.strength > 0:
        warnings.warn("%s: stone does not crush here, 'strength' is for the "
                      "program" % name, DrawingWarning, 3)
    return out


def parse(text: Union[str, bytes], name: str = "structure") -> Structure:
    """Returns a structure from text in the format of files (`kern --help`).

    name: for messages. Raises ValueError with the line, and KernError.

    >>> wall = parse("fixed ground -3 -1  4 -1  4 0  -3 0\\n"
    ...              "block stone *  0 0  1 0  1 1  0 1\\n")
    >>> wall.measure().margin
    0.5
    >>> parse("friction much")
    Traceback (most recent call last):
        ...
    ValueError: structure:1: friction: a number not below zero is expected, \
read 'much'
    """
    data: Any = text.encode() if isinstance(text, str) else text
    if not isinstance(data, bytes):
        raise TypeError("parse(): a str or bytes are expected, read %s"
                        % reprlib.repr(text))
    t = _Text()
    try:
        if _read(byref(t), data, len(data)):
            raise ValueError("%s:%d: %s" % (
                name, t.line, t.message.decode(errors="replace")))
        return _structure_of(t, name)
    finally:
        _free(byref(t))


class DrawingWarning(UserWarning):
    """An assumption about a drawing or a photograph: which blocks are ground,
    which hang in the air, which polygons look like soil."""


def _words(values: Sequence[str]) -> Any:
    out = (c_char_p * max(len(values), 1))()
    out[:len(values)] = [word.encode() for word in values]
    return out


def _asked(what: Dict[str, Any], name: str) -> Tuple[_Asked, Any]:
    """What a reader of drawings is told; and the words it points to."""
    roles: Any = what.get("layers") or {}
    if not isinstance(roles, dict):
        raise TypeError("%s: layers takes a dict of names and roles, read %s"
                        % (name, reprlib.repr(roles)))
    roles = cast(Dict[str, str], roles)
    layers = ["%s=%s" % pair for pair in roles.items()]
    for word in layers:
        if word.rpartition("=")[2] not in ("ground", "stone", "fill", "ignore"):
            raise ValueError("%s: layers takes the roles ground, stone, fill, "
                             "ignore, read '%s'" % (name, word))
    fixed = what.get("fixed") or ()
    layers += ["%s=ground" % label for label in (
        (fixed,) if isinstance(fixed, str) else fixed)]
    density: Any = what.get("density")
    densities: Dict[str, float] = {}
    if density is not None:
        densities = (cast(Dict[str, float], density)
                     if isinstance(density, dict) else {"": density})
    for value in densities.values():
        (value,) = _several("%s: density" % name, [value], 1)
        if not 0 < value < math.inf:
            raise ValueError("%s: density takes a number above 0, read %r"
                             % (name, value))
    told = ["%s%s%r" % (label, "=" if label else "", float(value))
            for label, value in densities.items()]
    pixel, tolerance = what.get("pixel"), what.get("tolerance", 1.5)
    for word, value in (("pixel", pixel), ("tolerance", tolerance),
                        ("ground", what.get("ground"))):
        _several("%s: %s" % (name, word), [value or 0], 1)
    if not (pixel is None or 0 < pixel < 1e15) or not 0 <= tolerance < 1e15:
        raise ValueError("%s: pixel is a length above 0, tolerance a number of "
                         "pixels, read %r and %r" % (name, pixel, tolerance))
    ground, image = what.get("ground"), what.get("image")
    words = _words(layers), _words(told)
    return _Asked(addressof(words[0]), len(layers), addressof(words[1]),
                  len(told), ground is not None, ground or 0.0, pixel or 0.0,
                  tolerance, None if image is None else str(image).encode()
                  ), words


def _drawn(data: bytes, ending: str, name: str, what: Dict[str, Any],
           level: int = 3) -> Structure:
    """The structure of a file of any format; `ending` tells which."""
    t, (asked, kept) = _Text(), _asked(what, name)
    drawing = _drawing_new()
    try:
        if _drawing_parse(byref(t), drawing, b"x" + ending.encode(), data,
                          len(data), byref(asked)):
            raise ValueError("%s:%s %s" % (
                name, "%d:" % t.line if t.line else "",
                t.message.decode(errors="replace")))
        out = _structure_of(t, name)
        out.notes = _drawing_notes(drawing).decode().splitlines()
        row, line, count = (c_char_p * 2)(), c_int(), c_int()
        for i in range(_drawing_skips(drawing)):
            _drawing_skip(drawing, i, row, byref(line), byref(count))
            out.skipped.append(((row[0] or b"").decode(),
                                (row[1] or b"").decode(),
                                line.value or None, count.value))
        for note in out.notes:
            if re.match("no label|hang|looks|fill:|mended|parts of", note):
                warnings.warn("%s: %s" % (name, note), DrawingWarning, level)
        return out
    except KernError as error:
        error.args = ("%s: %s" % (name, error.args[0]), *error.args[1:])
        raise
    finally:
        _drawing_free(drawing)
        _free(byref(t))
        del kept


_Densities = Union[None, float, Dict[str, float]]


def _given(**what: Any) -> Dict[str, Any]:
    """Returns the keywords that have a value."""
    return {word: value for word, value in what.items() if value is not None}


def read(path: Union[str, os.PathLike[str]], *,
         layers: Optional[Dict[str, str]] = None, density: _Densities = None,
         ground: Optional[float] = None, pixel: Optional[float] = None,
         tolerance: Optional[float] = None,
         fixed: Union[None, str, Sequence[str]] = None,
         image: Union[None, int, str] = None) -> Structure:
    """Returns the structure in a file: text (`kern --help format` describes
    it), a drawing (.dxf, .svg), or polygons of LabelMe, COCO or VIA (.json).
    For drawings and photographs there are keywords:

        layers   roles of layers or labels: {"PIER": "ground"}; other roles are
                 stone, fill, ignore
        density  density of all blocks, or a dict with the density of each layer
        ground   y of a line that is the ground, in the numbers of the file
        pixel, tolerance, fixed, image   as in from_labelme() and from_coco()

    The structure's `skipped` lists the shapes that became no block, as (kind,
    label, line, count), and `notes` lists the assumptions. `units` is the unit
    of lengths."""
    file = pathlib.Path(path)
    data, ending = file.read_bytes(), file.suffix.lower()
    what = _given(layers=layers, density=density, ground=ground, pixel=pixel,
                  tolerance=tolerance, fixed=fixed, image=image)
    of_image = {"pixel", "tolerance", "fixed", "image"} & set(what)
    if of_image and ending != ".json":
        raise TypeError("%s: %s go with polygons of an image (.json)"
                        % (path, ", ".join(sorted(of_image))))
    if what and ending not in (".json", ".dxf", ".svg"):
        raise TypeError("%s: %s go with drawings and images"
                        % (path, ", ".join(sorted(what))))
    structure = _drawn(data, ending or ".kern", str(path), what)
    structure.name = file.stem
    return structure


def _page(page: Any, name: str, what: Dict[str, Any]) -> Structure:
    try:
        data = json.dumps(page).encode()
    except (TypeError, ValueError, RecursionError) as error:
        raise ValueError("%s: is no JSON: %s" % (name, error)) from None
    return _drawn(data, ".json", name, what, 4)


def simplified(points: Sequence[Point], tolerance: float) -> List[Point]:
    """Returns the vertices of a closed outline without those that are no
    farther than the tolerance [m] from the polygon that remains. Raises
    KernError.

    >>> simplified([(0, 0), (1, .01), (2, 0), (2, 1), (0, 1)], tolerance=.02)
    [(0, 0), (2, 0), (2, 1), (0, 1)]
    """
    n, (tolerance,) = len(points), _several("tolerance", [tolerance], 1)
    raw, out, kept = (_Vec * n)(), (_Vec * n)(), (c_int * n)()
    for i, point in enumerate(points):
        raw[i] = _vector("point %d" % i, point)
    count = _outline_simplify(raw, n, tolerance, out, kept, n)
    if count < 0:
        raise KernError(count)
    return [points[i] for i in kept[:count]]


def from_labelme(page: Any, *, pixel: Optional[float] = None,
                 tolerance: float = 1.5, density: _Densities = None,
                 fixed: Union[str, Sequence[str]] = (),
                 layers: Optional[Dict[str, str]] = None,
                 ground: Optional[float] = None,
                 name: str = "LabelMe") -> Structure:
    """Returns the structure of the polygons in a page of LabelMe.

    page:      the object that json.load() returns
    pixel:     size of a pixel [m]
    tolerance: outlines are simplified to this many pixels
    fixed:     labels of blocks that do not move, besides `ground`; without any,
               the lowest row is fixed
    density, layers, ground: as in read()
    name:      for messages
    y points up. The errors of Options.measured() follow from pixel and
    tolerance.

    >>> box = [[10, 10], [30, 10], [30, 30], [10, 30]]
    >>> slab = [[0, 30], [60, 30], [60, 40], [0, 40]]
    >>> from_labelme({"imageHeight": 40, "shapes": [
    ...     {"label": "ground", "points": slab, "shape_type": "polygon"},
    ...     {"label": "stone", "points": box, "shape_type": "polygon"}]},
    ...     pixel=.01).verdict()
    Verdict(stands=True)
    """
    return _page(page, name, _given(
        pixel=pixel, tolerance=tolerance, density=density, fixed=fixed,
        layers=layers, ground=ground))


def from_coco(page: Any, *, pixel: Optional[float] = None,
              tolerance: float = 1.5, density: _Densities = None,
              fixed: Union[str, Sequence[str]] = (),
              image: Union[None, int, str] = None,
              layers: Optional[Dict[str, str]] = None,
              ground: Optional[float] = None, name: str = "COCO") -> Structure:
    """Returns the structure of the polygons and masks of one image in a COCO
    page; blocks are named by their categories.

    image: id or file name of the image, where the page has several
    The other parameters are those of from_labelme()."""
    return _page(page, name, _given(
        pixel=pixel, tolerance=tolerance, density=density, fixed=fixed,
        image=image, layers=layers, ground=ground))


# ---- Linear programs ---------------------------------------------------------


def lp_solve(a: _Table, rhs: _Numbers,
             cost: Optional[_Numbers] = None,
             limit: int = 0) -> Solution:
    """Minimises cost . x where a x = rhs and x >= 0. Returns a Solution.

    a:     a list of rows
    cost:  the prices of x; None: any feasible x
    limit: largest number of pivots; 0: no limit
    Raises ValueError where lengths differ, and KernError where it is undecided.

    >>> best = lp_solve([[1, 1, 1, 0], [1, 3, 0, 1]], [4, 6], [-3, -5, 0, 0])
    >>> [round(x, 9) for x in best.x]
    [3.0, 1.0, 0.0, 0.0]
    """
    rows, cols = len(rhs), len(a[0]) if len(a) else 0
    if len(a) != rows or any(len(row) != cols for row in a) or (
            cost is not None and len(cost) != cols):
        raise ValueError("%d rows of a for %d of rhs, or rows of unequal length"
                         % (len(a), rows))
    try:
        columns, right = _numbers(zip(*a)), _numbers(rhs)
        prices = _numbers(cost) if cost is not None else None
    except (TypeError, OverflowError) as error:
        raise TypeError("lp_solve(): numbers are expected: %s" % error
                        ) from None
    room = (rows + rows // 2 + 8) * (rows + 2)      # KERN_LP_ROOM
    real = (c_double * (room + 5 * rows + 16))()    # KERN_LP_REALS
    index = (c_int * (9 * rows + cols + 30))()      # KERN_LP_INTS
    work = _Work(addressof(real), len(real), addressof(index), len(index))
    x, y = (c_double * cols)(), (c_double * rows)()
    lp = _Lp(rows, cols, addressof(columns), addressof(right),
             addressof(prices) if prices else None, limit)
    status = _lp_solve(byref(lp), x, y, byref(work))
    if status < 0:
        raise KernError(status)
    return Solution(Status(status), list(x), list(y))


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] != "--build":
        sys.exit("usage: kern.py --build FILE")
    build(sys.argv[2])
