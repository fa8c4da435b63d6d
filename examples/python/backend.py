"""The build backend of pyproject.toml (PEP 517, PEP 660), which needs no other
package and no network.

The wheel is for this platform: it holds the package kern, with kern.py as its
__init__.py, the compiled library and py.typed. An editable wheel holds the path
of this folder, where kern.py compiles the headers at the first import after a
change. The source archive holds the headers as well. The metadata come from
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
from typing import Any, Dict, List, Optional

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
NAME = "kern_dry_stone"


def _version() -> str:
    found = re.search(r'^__version__ = "(.*)"$',
                      (HERE / "kern.py").read_text(encoding="utf-8"), re.M)
    if not found:
        raise SystemExit("kern.py has no version")
    return found.group(1)


def _library() -> bytes:
    """Returns the compiled library, as `kern.py --build FILE` writes it."""
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


def _tag() -> str:
    return "py3-none-" + re.sub(r"[-.]", "_", sysconfig.get_platform())


def _project() -> Dict[str, Dict[str, Any]]:
    """Returns the strings and lists of each table of pyproject.toml, which are
    written as in Python."""
    text = (HERE / "pyproject.toml").read_text(encoding="utf-8")
    tables = re.split(r"^\[(.*)\]$", text, flags=re.M)
    out: Dict[str, Dict[str, Any]] = {}
    for name, body in zip(tables[1::2], tables[2::2]):
        rows = re.findall(r'^"?([\w -]+?)"? = (".*"|\[[^\]]*\])$', body, re.M)
        out[name] = {key: ast.literal_eval(value) for key, value in rows}
    return out


def _readme() -> str:
    """Returns the part of README above its first heading of a section."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return re.sub(r"!\[[^]]*\]\([^)]*\)\n*", "", text.split("\n## ")[0])


def _metadata() -> bytes:
    """Returns the metadata of a wheel or a source archive."""
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


def _write(folder: str, files: Dict[str, bytes], tag: str) -> str:
    """Writes a wheel with these files and its own records. Returns its name."""
    version = _version()
    info = "%s-%s.dist-info" % (NAME, version)
    files = {
        **files,
        info + "/METADATA": _metadata(),
        info + "/WHEEL": ("Wheel-Version: 1.0\nGenerator: kern\n"
                          "Root-Is-Purelib: false\nTag: %s\n" % tag).encode(),
        info + "/LICENSE": (ROOT / "LICENSE").read_bytes(),
    }
    rows: List[str] = []
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


def build_wheel(wheel_directory: str, config_settings: Any = None,
                metadata_directory: Optional[str] = None) -> str:
    """Writes the wheel of this platform. Returns its name (PEP 517)."""
    return _write(wheel_directory, {
        "kern/__init__.py": (HERE / "kern.py").read_bytes(),
        "kern/kern_library.so": _library(),
        "kern/py.typed": b"",
    }, _tag())


def build_editable(wheel_directory: str, config_settings: Any = None,
                   metadata_directory: Optional[str] = None) -> str:
    """Writes a wheel that points to this folder. Returns its name (PEP 660)."""
    return _write(wheel_directory,
                  {NAME + ".pth": (str(HERE) + "\n").encode()},
                  "py3-none-any")


def _sources() -> Dict[str, bytes]:
    """Returns the files that a wheel needs, by their places in the archive."""
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


def build_sdist(sdist_directory: str, config_settings: Any = None) -> str:
    """Writes the source archive. Returns its name (PEP 517)."""
    base = "%s-%s" % (NAME, _version())
    with tarfile.open(os.path.join(sdist_directory, base + ".tar.gz"), "w:gz",
                      format=tarfile.PAX_FORMAT) as out:
        for name, data in sorted(_sources().items()):
            entry = tarfile.TarInfo("%s/%s" % (base, name))
            entry.size, entry.mode = len(data), 0o644
            out.addfile(entry, io.BytesIO(data))
    return base + ".tar.gz"
