"""Robots as Python modules, without a build system: load("arm.urdf") generates the code of a robot, compiles it once and
imports it.

It needs the generator (the program robcogen: named by ROBCOGEN_TOOL, of the same installation, or on the PATH), a C++
compiler (CXX, which may have arguments, or c++, g++, clang++) and the headers of Python. Warnings and notes of the
generator go to stderr. Modules stay in a cache: ROBCOGEN_CACHE, or robcogen in the user's cache folder.
"""
import hashlib
import importlib.machinery
import importlib.util
import json
import os
import platform
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

__all__ = ["Error", "build", "load"]

_FLAGS = ["-std=c++17", "-O2", "-fPIC", "-fvisibility=hidden"]
# Those of gcc for generated code, and for the kernels of the best processor, as the CMake functions have them; a test
# compares them.
_OF_GCC = (
    "-fno-tree-slp-vectorize -frename-registers -fno-tree-dse -fno-dse -fno-schedule-insns2 -fno-tree-pta -fno-tree-pre "
    "-fno-code-hoisting -fno-tree-dominator-opts -fno-thread-jumps -fno-tree-vrp -fno-exceptions "
    "--param=lra-max-considered-reload-pseudos=100").split()
_ORDER_OF_GCC = ["-fschedule-insns", "-fsched-pressure", "-fschedule-insns2"]


class Error(Exception):
    """A wrong model, with the messages of the generator, or a missing program."""


def load(model, **options):
    """Returns the module of a robot (.kindsl, .urdf or MJCF), of motions (.motdsl) or of transforms (.ctdsl).

    The options are those of build().
    """
    path = build(model, **options)
    name = path.name.split(".")[0]
    loader = importlib.machinery.ExtensionFileLoader(name, str(path))
    spec = importlib.util.spec_from_file_location(name, path, loader=loader)
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


def build(model, *, name=None, desired=None, algorithms=(), derivatives=(), options=()):
    """Builds a module and returns its path; its stub, <name>.pyi, is in the same folder.

    name: of the module; default: the model file's. desired: a list of transforms (.dtdsl); default: the one next to the
    model, or else all links. algorithms: groups of functions; default: the default groups. derivatives: such as
    "inverse_dynamics:q". options: other options of `robcogen generate`, such as "--floating-base". A single string is one
    element.
    """
    model = Path(model).absolute()
    if not model.is_file():
        raise Error(f"{model}: no such file")
    name = name or _name_of(model)
    if desired is None and model.with_suffix(".dtdsl").is_file():
        desired = model.with_suffix(".dtdsl")
    arguments = ["--name", name, "--language", "cpp", "python"]
    if platform.machine() in ("x86_64", "AMD64") and model.suffix not in (".motdsl", ".ctdsl"):
        arguments += ["--processors", "avx2"]
    if desired is not None:
        arguments += ["--desired", str(Path(desired).absolute())]
    for option, values in (("--algorithms", algorithms), ("--derivatives", derivatives)):
        values = _elements(values)
        if values:
            arguments += [option, *values]
    options = _elements(options)
    arguments += options
    tool = _program("the program robcogen", "ROBCOGEN_TOOL", [*_own_tool(), "robcogen"], "install it")
    version = _run([*tool, "--version"]).stdout
    cache = _cache()
    # What was read for this call before, and what came of it.
    call = cache / (_hash(version, str(model), *arguments) + ".json")
    known = _known(call)
    if known is not None:
        return known
    with tempfile.TemporaryDirectory(dir=cache) as folder:
        folder = Path(folder)
        depfile, stamp = folder / "depfile", folder / "stamp"
        command = [*tool, "generate", str(model), "-o", str(folder), *arguments, "--depfile", str(depfile), "--stamp", str(stamp)]
        messages = _run(command).stderr
        if not stamp.is_file():
            raise Error(f"the generator writes no code with the options {' '.join(options)}")
        _report(messages)
        # The stamp is the hash of the canonical model: layout and comments make no difference.
        key = f"{name}-{_hash(version, stamp.read_text(), platform.platform(), *_without_paths(arguments))}"
        module = cache / key / f"{name}.abi3.so"
        if not module.is_file():
            _compile(folder, name)
            try:
                os.replace(folder / "module", cache / key)
            except OSError:  # another process was faster
                if not module.is_file():
                    raise
        files = [Path(f.replace("\\ ", " ")) for f in re.split(r"(?<!\\)\s+", depfile.read_text().replace("\\\n", " ").split(":", 1)[1].strip())]
        record = {"module": str(module), "messages": messages, "files": {str(f): _hash(f.read_bytes()) for f in files if f.is_file()}}
        (folder / "record").write_text(json.dumps(record))
        os.replace(folder / "record", call)
    return module


def _known(call):
    try:
        record = json.loads(call.read_text())
        same = all(_hash(Path(f).read_bytes()) == wanted for f, wanted in record["files"].items())
        module, messages = Path(record["module"]), record["messages"]
        if not same or not module.is_file():
            return None
    except (OSError, ValueError, KeyError):
        return None
    _report(messages)
    return module


def _compile(folder, name):
    compiler = _program("a C++ compiler", "CXX", ["c++", "g++", "clang++"], "install one")
    headers = Path(sysconfig.get_paths()["include"])
    if not (headers / "Python.h").is_file():
        raise Error(f"{headers} has no Python.h: install the headers of this Python (Debian: python3-dev)")
    includes = ["-I", str(folder), "-I", str(_runtime()), "-I", str(headers)]
    has_levels = bool(list(folder.glob(f"{name}/kernels_avx2.cpp")))
    levels = ["-DROBCOGEN_WITH_AVX2"] if has_levels else []
    is_gcc = "Free Software Foundation" in _run([*compiler, "--version"]).stdout
    source = folder / "python" / f"{name}.cpp"
    commands, objects = [], []
    for file in [source, *sorted((folder / name).glob("*.cpp"))]:
        flags = list(_FLAGS)
        if file != source:
            flags += _OF_GCC if is_gcc else ["-fno-exceptions"]
        is_best = file.name == "kernels_avx2.cpp"
        if is_best:
            flags += ["-mavx2", "-mfma", "-fno-math-errno"] + ([] if is_gcc else ["-ffp-contract=fast"])
        if is_gcc and file != source and is_best == has_levels:
            flags += _ORDER_OF_GCC
        objects.append(str(folder / f"{len(objects)}.o"))
        commands.append([*compiler, *flags, *levels, *includes, "-c", str(file), "-o", objects[-1]])
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(_run, commands))
    (folder / "module").mkdir()
    link = ["-undefined", "dynamic_lookup"] if sys.platform == "darwin" else []
    _run([*compiler, "-shared", *link, *objects, "-o", str(folder / "module" / f"{name}.abi3.so")])
    shutil.copy(folder / "python" / f"{name}.pyi", folder / "module")


def _runtime():
    """The headers that generated code includes: of a wheel, of an installation, of the sources."""
    here = Path(__file__).resolve().parent
    for folder in (here / "include", here.parents[2] / "include", here.parents[3] / "include", here.parents[1] / "include"):
        if (folder / "robcogen" / "python" / "make_module.h").is_file():
            return folder
    raise Error(f"cannot find the headers of robcogen near {here}")


def _own_tool():
    """The generator of the installation that this package is part of, <prefix>/share/robcogen/python."""
    folder = Path(__file__).resolve().parents[1]
    return [str(folder.parents[2] / "bin" / "robcogen")] if folder.parts[-3:] == ("share", "robcogen", "python") else []


def _cache():
    folder = os.environ.get("ROBCOGEN_CACHE")
    if not folder:
        folder = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "robcogen"
    Path(folder).mkdir(parents=True, exist_ok=True)
    return Path(folder).absolute()


def _name_of(model):
    """The name of a model's module if none is given."""
    name = re.sub(r"\W", "_", model.name.split(".")[0], flags=re.ASCII)
    if not name.isidentifier():
        raise Error(f"{model}: '{name}' cannot name the module, as it is not a valid identifier; give it another name")
    return name


def _elements(values):
    return [values] if isinstance(values, str) else list(values)


def _program(what, variable, names, advice):
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


def _report(messages):
    if messages.strip():
        print(messages.strip(), file=sys.stderr)


def _run(command):
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        raise Error(run.stderr.strip() or f"{command[0]} ended with status {run.returncode}")
    return run


def _without_paths(arguments):
    """The list of transforms is part of the canonical model's hash; its place is not."""
    result = list(arguments)
    if "--desired" in result:
        path = Path(result[result.index("--desired") + 1])
        result[result.index("--desired") + 1] = path.read_text(encoding="utf-8") if path.is_file() else ""
    return result


def _hash(*parts):
    digest = hashlib.sha256()
    for part in parts:
        digest.update((part if isinstance(part, bytes) else part.encode()) + b"\0")
    return digest.hexdigest()[:24]
