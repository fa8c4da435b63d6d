"""The build backend of pyproject.toml (PEP 517, PEP 660), which needs no other
package and no network.

The wheel is of this platform: the package kern with kern.py as its __init__.py,
the compiled library beside it, and py.typed. An editable wheel holds the path of
this folder, where kern.py compiles the headers at the first import after a
change. The source archive holds the headers, too. Metadata are those of
pyproject.toml.

SPDX-License-Identifier: MIT
"""

import ast
import base64
import hashlib
import io
import os
import pathlib
import re
import runpy
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
NAME = "kern_dry_stone"


def _version():
    found = re.search(r'^__version__ = "(.*)"$',
                      (HERE / "kern.py").read_text(encoding="utf-8"), re.M)
    return found.group(1)


def _library():
    """The compiled library's bytes: what `kern.py --build FILE` writes."""
    if os.name != "posix":
        raise SystemExit("kern needs a POSIX system (Linux, macOS, WSL): it "
                         "compiles kern.h with cc")
    with tempfile.TemporaryDirectory() as folder:
        made = os.path.join(folder, "kern_library.so")
        before = sys.argv, os.environ.get("XDG_CACHE_HOME")
        sys.argv = ["kern.py", "--build", made]
        os.environ["XDG_CACHE_HOME"] = folder
        try:
            runpy.run_path(str(HERE / "kern.py"), run_name="__main__")
        finally:
            sys.argv = before[0]
            if before[1] is None:
                del os.environ["XDG_CACHE_HOME"]
            else:
                os.environ["XDG_CACHE_HOME"] = before[1]
        return pathlib.Path(made).read_bytes()


def _tag():
    return "py3-none-" + re.sub(r"[-.]", "_", sysconfig.get_platform())


def _project():
    """The table [project] of pyproject.toml, whose values are also those of
    Python: strings and lists, and tables of these."""
    text = (HERE / "pyproject.toml").read_text(encoding="utf-8")
    tables = re.split(r"^\[(.*)\]$", text, flags=re.M)
    out = {}
    for name, body in zip(tables[1::2], tables[2::2]):
        rows = re.findall(r'^"?([\w -]+?)"? = (".*"|\[[^\]]*\])$', body, re.M)
        out[name] = {key: ast.literal_eval(value) for key, value in rows}
    return out


def _readme():
    """What README has above its first code, which is what a stranger asks."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return re.sub(r"!\[[^]]*\]\([^)]*\)\n*", "", text.split("\n## ")[0])


def _metadata():
    tables = _project()
    told = tables["project"]
    lines = ["Metadata-Version: 2.1", "Name: " + told["name"],
             "Version: " + _version(), "Summary: " + told["description"],
             "License: " + told["license"],
             "Keywords: " + ",".join(told["keywords"]),
             "Requires-Python: " + told["requires-python"]]
    lines += ["Classifier: " + word for word in told["classifiers"]]
    for extra, words in tables["project.optional-dependencies"].items():
        lines.append("Provides-Extra: " + extra)
        lines += ['Requires-Dist: %s; extra == "%s"' % (word, extra)
                  for word in words]
    lines.append("Description-Content-Type: text/markdown")
    return ("\n".join(lines) + "\n\n" + _readme() + "\n").encode()


def _write(folder, files, tag):
    """Writes a wheel with these files and its own records; returns its name."""
    version = _version()
    info = "%s-%s.dist-info" % (NAME, version)
    files = {
        **files,
        info + "/METADATA": _metadata(),
        info + "/WHEEL": ("Wheel-Version: 1.0\nGenerator: kern\n"
                          "Root-Is-Purelib: false\nTag: %s\n" % tag).encode(),
        info + "/LICENSE": (ROOT / "LICENSE").read_bytes(),
    }
    rows = []
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest())
        rows.append("%s,sha256=%s,%d" % (
            name, digest.rstrip(b"=").decode(), len(data)))
    rows.append(info + "/RECORD,,")
    files[info + "/RECORD"] = ("\n".join(rows) + "\n").encode()
    wheel = "%s-%s-%s.whl" % (NAME, version, tag)
    with zipfile.ZipFile(os.path.join(folder, wheel), "w",
                         zipfile.ZIP_DEFLATED) as out:
        for name, data in files.items():
            out.writestr(name, data)
    return wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    return _write(wheel_directory, {
        "kern/__init__.py": (HERE / "kern.py").read_bytes(),
        "kern/kern_library.so": _library(),
        "kern/py.typed": b"",
    }, _tag())


def build_editable(wheel_directory, config_settings=None,
                   metadata_directory=None):
    return _write(wheel_directory,
                  {NAME + ".pth": (str(HERE) + "\n").encode()},
                  "py3-none-any")


def _sources():
    """The files that a wheel is made of, by their places in the archive."""
    inside = HERE.relative_to(ROOT).as_posix()
    text = (HERE / "kern.py").read_text(encoding="utf-8")
    listed = text[text.index("_HEADERS = "):text.index("_FLAGS = ")]
    names = ["examples/parts/%s.h" % word for word in re.findall(
        r'"(\w+)"', listed)]
    names += re.findall(r'"([\w/]+\.h)"', listed)
    names += ["LICENSE", "README.md"] + ["%s/%s" % (inside, name) for name in (
        "backend.py", "env.py", "kern.py", "labels.py")]
    out = {name: (ROOT / name).read_bytes() for name in names}
    page = (HERE / "pyproject.toml").read_text(encoding="utf-8")
    out[inside + "/pyproject.toml"] = page.encode()
    out["pyproject.toml"] = page.replace(
        'backend-path = ["."]', 'backend-path = ["%s"]' % inside).encode()
    out["PKG-INFO"] = _metadata()
    return out


def build_sdist(sdist_directory, config_settings=None):
    base = "%s-%s" % (NAME, _version())
    with tarfile.open(os.path.join(sdist_directory, base + ".tar.gz"), "w:gz",
                      format=tarfile.PAX_FORMAT) as out:
        for name, data in sorted(_sources().items()):
            entry = tarfile.TarInfo("%s/%s" % (base, name))
            entry.size, entry.mode = len(data), 0o644
            out.addfile(entry, io.BytesIO(data))
    return base + ".tar.gz"
