"""make_wheel.py FOLDER: the package robcogen as a wheel, with the headers that generated code includes. Its bytes follow from
the sources alone.

It is also the build backend (PEP 517, PEP 660) of pyproject.toml, so that `pip install` of this folder needs no other package.
"""
import base64
import hashlib
import sys
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from robcogen import _tools, _version  # noqa: E402

VERSION = _version.__version__
METADATA = (
    f"Metadata-Version: 2.1\nName: robcogen\nVersion: {VERSION}\nSummary: Robots as Python modules, generated and compiled\n"
    "License: BSD-3-Clause\nRequires-Python: >=3.11\n")


def package():
    """The files of the package, with the headers."""
    headers = _tools.runtime()
    files = {
        f.relative_to(HERE).as_posix(): f.read_bytes() for name in ("robcogen", "_robcogen")
        for f in sorted((HERE / name).iterdir()) if f.suffix == ".py" or f.name == "py.typed"}
    return files | {
        f"robcogen/include/{f.relative_to(headers).as_posix()}": f.read_bytes() for f in sorted((headers / "robcogen").rglob("*.h"))}


def write(files, folder):
    info = f"robcogen-{VERSION}.dist-info"
    files = files | {
        f"{info}/METADATA": METADATA.encode(),
        f"{info}/WHEEL": b"Wheel-Version: 1.0\nGenerator: robcogen\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        f"{info}/entry_points.txt": b"[console_scripts]\nrobcogen-python = robcogen.__main__:main\n"}
    record = ""
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    folder.mkdir(parents=True, exist_ok=True)
    wheel = folder / f"robcogen-{VERSION}-py3-none-any.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), data, zipfile.ZIP_DEFLATED)
    return wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """For pip. A package that is installed from an installation finds its generator there."""
    files = package()
    for generator in _tools.own_generator():
        files["robcogen/_installation.py"] = f"GENERATOR = {generator!r}\n".encode()
    return write(files, Path(wheel_directory)).name


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """For `pip install -e`: the package stays where it is."""
    return write({"robcogen.pth": f"{HERE}\n".encode()}, Path(wheel_directory)).name


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("the sources of this package are those of the whole project")


if __name__ == "__main__":
    print(write(package(), Path(sys.argv[1])))
