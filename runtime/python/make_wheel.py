"""make_wheel.py FOLDER [--installation PREFIX] [--licenses FOLDER]: the package robcogen as a wheel, with the headers that
generated code includes; with an installation, its generator and its CMake package are in the wheel too.
make_wheel.py FOLDER --sources ARCHIVE: the archive of the project's sources as a source distribution.

The bytes of a file follow from its contents alone. This is also the build backend (PEP 517, PEP 660) of pyproject.toml, so
that `pip install` of this folder, or of a source distribution, needs no other package.
"""
import argparse
import base64
import gzip
import hashlib
import io
import os
import shlex
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[1]
sys.path.insert(0, str(HERE))
from robcogen import _tools, _version  # noqa: E402

VERSION = _version.__version__
INFO = f"robcogen-{VERSION}.dist-info"
METADATA = (
    f"Metadata-Version: 2.1\nName: robcogen\nVersion: {VERSION}\nSummary: Robots as Python modules, generated and compiled\n"
    "License: BSD-3-Clause\nRequires-Python: >=3.11\n")
NEEDED = (
    "robcogen is built by CMake 3.22 and a C++20 compiler, with Eigen, {fmt}, CLI11, nlohmann-json and, to read URDFs, urdfdom; Debian "
    "has them as cmake g++ libeigen3-dev libfmt-dev libcli11-dev nlohmann-json3-dev liburdfdom-dev")
# The program robcogen of an environment. It does not import the package, which takes longer than the generator's start.
COMMAND = """#!python
import os
import sys
from importlib.machinery import PathFinder

package = PathFinder.find_spec("robcogen")
generator = os.path.join(package.submodule_search_locations[0], "bin", "robcogen")
os.execv(generator, [generator, *sys.argv[1:]])
"""


def package():
    """The files of the package."""
    return {
        f.relative_to(HERE).as_posix(): f.read_bytes() for name in ("robcogen", "_robcogen")
        for f in sorted((HERE / name).iterdir()) if f.suffix == ".py" or f.name == "py.typed"}


def headers():
    folder = _tools.runtime()
    return {f"robcogen/include/{f.relative_to(folder).as_posix()}": f.read_bytes() for f in sorted((folder / "robcogen").rglob("*.h"))}


def tree(folder, prefix):
    """All files below a folder, by their names in the wheel."""
    return {f"{prefix}/{f.relative_to(folder).as_posix()}": f.read_bytes() for f in sorted(folder.rglob("*")) if f.is_file()}


def write(files, folder, tag="any", programs=()):
    is_pure = str(tag == "any").lower()
    files = files | {
        f"{INFO}/METADATA": METADATA.encode(),
        f"{INFO}/WHEEL": (
            f"Wheel-Version: 1.0\nGenerator: robcogen\nRoot-Is-Purelib: {is_pure}\n" +
            "".join(f"Tag: py3-none-{platform}\n" for platform in tag.split("."))).encode(),
        f"{INFO}/entry_points.txt": b"[console_scripts]\nrobcogen-python = robcogen.__main__:main\n"}
    record = ""
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    files[f"{INFO}/RECORD"] = (record + f"{INFO}/RECORD,,\n").encode()
    folder.mkdir(parents=True, exist_ok=True)
    wheel = folder / f"robcogen-{VERSION}-py3-none-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = (0o100755 if name in programs else 0o100644) << 16
            archive.writestr(entry, data, zipfile.ZIP_DEFLATED)
    return wheel


def write_with_generator(installation, licenses, folder):
    """The wheel of a platform: the package is an installation of the whole project."""
    from platform_tag import platform_tag  # not part of an installation

    generator = installation / "bin" / "robcogen"
    tag, libraries = platform_tag(generator)
    if libraries:
        print(f"the generator is tied to this machine by {', '.join(libraries)}: the wheel serves here only", file=sys.stderr)
    command = f"robcogen-{VERSION}.data/scripts/robcogen"
    files = package() | tree(installation, "robcogen") | {command: COMMAND.encode()}
    if licenses:
        files |= tree(licenses, f"{INFO}/licenses")
    return write(files, folder, tag, {"robcogen/bin/robcogen", command})


def write_sources(sources, folder):
    """The archive with what pip asks for at its root."""
    project = (HERE / "pyproject.toml").read_text().replace('backend-path = ["."]', 'backend-path = ["runtime/python"]')
    root = f"robcogen-{VERSION}"
    added = {f"{root}/PKG-INFO": METADATA.encode(), f"{root}/pyproject.toml": project.encode()}
    archive = folder / f"{root}.tar.gz"
    folder.mkdir(parents=True, exist_ok=True)
    with (tarfile.open(sources) as given, archive.open("wb") as file, gzip.GzipFile("", "wb", fileobj=file, mtime=0) as packed,
          tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as made):
        entries = [(m.name, m.mode & 0o111, given.extractfile(m).read()) for m in given if m.isfile()]
        for name, executable, data in sorted(entries + [(n, 0, d) for n, d in added.items()]):
            entry = tarfile.TarInfo(name)
            entry.size, entry.mode = len(data), 0o755 if executable else 0o644
            made.addfile(entry, io.BytesIO(data))
    return archive


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """For pip. From a source distribution, the generator is built. A package that is installed from an installation finds
    its generator there; from the sources of the project, it looks for one on the PATH."""
    if (PROJECT / "PKG-INFO").is_file():
        return build_generator(Path(wheel_directory)).name
    files = package() | headers()
    for generator in _tools.own_generator():
        files["robcogen/_installation.py"] = f"GENERATOR = {generator!r}\n".encode()
    return write(files, Path(wheel_directory)).name


def build_generator(folder):
    """Builds the generator and its wheel with CMake, which gets the arguments of the environment variable CMAKE_ARGS."""
    with tempfile.TemporaryDirectory() as build:
        arguments = [
            "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF", "-DROBCOGEN_EXAMPLES=OFF", "-DROBCOGEN_UNITY_BUILD=ON",
            f"-DPython3_EXECUTABLE={sys.executable}", *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
        try:
            subprocess.run(["cmake", "-S", PROJECT, "-B", build, *arguments], check=True)
            subprocess.run(["cmake", "--build", build, "--target", "robcogen_wheel", "--parallel", str(os.cpu_count())], check=True)
        except FileNotFoundError:
            sys.exit(f"there is no cmake: {NEEDED}")
        except subprocess.CalledProcessError as error:
            sys.exit(f"the build failed: {error}\n{NEEDED}")
        (wheel,) = Path(build, "wheel").glob("*.whl")
        copy = folder / wheel.name
        copy.write_bytes(wheel.read_bytes())
        return copy


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """For `pip install -e`: the package stays where it is."""
    return write({"robcogen.pth": f"{HERE}\n".encode()}, Path(wheel_directory)).name


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("the sources of this package are those of the whole project, which the target robcogen_sdist packs")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--installation", type=Path)
    parser.add_argument("--licenses", type=Path)
    parser.add_argument("--sources", type=Path)
    given = parser.parse_args()
    if given.sources:
        print(write_sources(given.sources, given.folder))
    elif given.installation:
        print(write_with_generator(given.installation, given.licenses, given.folder))
    else:
        print(write(package() | headers(), given.folder))


if __name__ == "__main__":
    main()
