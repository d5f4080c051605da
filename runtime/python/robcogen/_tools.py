"""The programs and files that a build needs."""
import hashlib
import os
import shlex
import shutil
import subprocess
from pathlib import Path


class Error(Exception):
    """A wrong model, with the messages of the generator, or a missing program."""


def generator():
    """The command of the generator: that of ROBCOGEN_TOOL, of the same wheel or installation, or on the PATH."""
    return program("the program robcogen", "ROBCOGEN_TOOL", [*own_generator(), "robcogen"], "install it")


def compiler():
    return program("a C++ compiler", "CXX", ["c++", "g++", "clang++"], "install one")


def runtime():
    """The headers that generated code includes: of a wheel, of an installation, of the sources."""
    for folder in _around_package(0, 3, 4, 2):
        if (folder / "include" / "robcogen" / "python" / "make_module.h").is_file():
            return folder / "include"
    raise Error(f"cannot find the headers of robcogen near {Path(__file__).resolve().parent}")


def _around_package(*levels):
    """The folder of the package, and folders that many levels above, as far as there are so many."""
    here = Path(__file__).resolve().parent
    folders = [here, *here.parents]
    return [folders[k] for k in levels if k < len(folders)]


def cmake_folder():
    """The folder of the CMake package: of a wheel with the generator, or of the installation that this package is part of."""
    for prefix in _around_package(0, 4):
        folder = prefix / "lib" / "cmake" / "robcogen"
        if folder.is_dir():
            return folder
    raise Error("this package has no CMake package: only wheels with the generator, and installations, have one")


def own_generator():
    """The generator in the package, if it is from a wheel of a platform; that of the installation that this package is part of,
    <prefix>/share/robcogen/python, or from which it was installed with pip."""
    package, folder = _around_package(0, 1)
    if (package / "bin" / "robcogen").is_file():
        return [str(package / "bin" / "robcogen")]
    if folder.parts[-3:] == ("share", "robcogen", "python"):
        return [str(folder.parents[2] / "bin" / "robcogen")]
    try:
        from ._installation import GENERATOR
    except ImportError:
        return []
    return [GENERATOR]


def program(what, variable, names, advice):
    """The command of a program, a list: the one that the environment variable names, or the first of `names` that exists."""
    given = os.environ.get(variable, "").strip()
    for command in [[given], _words(given)] if given else [[name] for name in names]:
        found = command and shutil.which(command[0])
        if found:
            return [found, *command[1:]]
    if given:
        raise Error(f"{variable} is '{given}', which is not a program: it must name {what}")
    raise Error(f"cannot find {what}: {advice}, or name it in {variable}")


def _words(command):
    """The program and the arguments of a command line, or nothing if a quote has no end."""
    try:
        return shlex.split(command)
    except ValueError:
        return []


def run(command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise Error(done.stderr.strip() or f"{command[0]} ended with status {done.returncode}")
    return done


def hash_of(*parts):
    digest = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else part.encode()
        digest.update(b"%d:" % len(data) + data)
    return digest.hexdigest()[:24]


def hash_of_files(folder, files):
    """The hash of files, by their names in the folder and their contents."""
    return hash_of(*(part for f in sorted(files) for part in (f.relative_to(folder).as_posix(), f.read_bytes())))
