"""The build backend of pyproject.toml (PEP 517): one wheel, of this platform,
with the package kern: kern.py as its __init__.py, the compiled library beside
it, and py.typed. A wheel is a zip file with a list of its files.

SPDX-License-Identifier: MIT
"""

import base64
import hashlib
import os
import pathlib
import re
import runpy
import sys
import sysconfig
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
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


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    version, tag = _version(), _tag()
    info = "%s-%s.dist-info" % (NAME, version)
    files = {
        "kern/__init__.py": (HERE / "kern.py").read_bytes(),
        "kern/kern_library.so": _library(),
        "kern/py.typed": b"",
        info + "/METADATA": (
            "Metadata-Version: 2.1\nName: %s\nVersion: %s\n"
            "Summary: How safely does a dry-stacked structure stand?\n"
            "License: MIT\nRequires-Python: >=3.8\n"
            % (NAME.replace("_", "-"), version)).encode(),
        info + "/WHEEL": ("Wheel-Version: 1.0\nGenerator: kern\n"
                          "Root-Is-Purelib: false\nTag: %s\n" % tag).encode(),
        info + "/LICENSE": (HERE.parent.parent / "LICENSE").read_bytes(),
    }
    rows = []
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest())
        rows.append("%s,sha256=%s,%d" % (
            name, digest.rstrip(b"=").decode(), len(data)))
    rows.append(info + "/RECORD,,")
    files[info + "/RECORD"] = ("\n".join(rows) + "\n").encode()
    wheel = "%s-%s-%s.whl" % (NAME, version, tag)
    with zipfile.ZipFile(os.path.join(wheel_directory, wheel), "w",
                         zipfile.ZIP_DEFLATED) as out:
        for name, data in files.items():
            out.writestr(name, data)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    raise SystemExit("kern is installed from a clone: the headers lie two "
                     "folders above kern.py")
