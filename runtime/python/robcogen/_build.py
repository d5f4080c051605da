"""Generates and compiles the module of a model, and keeps it in the cache."""
import functools
import json
import os
import platform
import re
import shutil
import sys
import sysconfig
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from ._messages import Progress, report
from ._tools import Error, compiler, generator, hash_of, hash_of_files, run, runtime

_FLAGS = ["-std=c++17", "-fPIC", "-fvisibility=hidden"]
# Of the source of the module, whose speed matters little, and of generated functions.
_MODULE_FLAGS, _KERNEL_FLAGS = ["-O1"], ["-O2"]
# Those of gcc for generated code, and for the kernels of the best processor, as the CMake functions have them; a test
# compares them.
_OF_GCC = (
    "-fno-tree-slp-vectorize -frename-registers -fno-tree-dse -fno-dse -fno-schedule-insns2 -fno-tree-pta -fno-tree-pre "
    "-fno-code-hoisting -fno-tree-dominator-opts -fno-thread-jumps -fno-tree-vrp -fno-exceptions "
    "--param=lra-max-considered-reload-pseudos=100").split()
_ORDER_OF_GCC = ["-fschedule-insns", "-fsched-pressure", "-fschedule-insns2"]
# Sources are compiled together until they have this size: each unit takes a while to read the headers.
_UNIT_BYTES = 1_500_000

_locks = {}


def build(model, name, desired, options, quiet):
    model = Path(model).absolute()
    if not model.is_file():
        raise Error(f"{model}: no such file")
    name = name or name_of(model)
    if desired is None and model.with_suffix(".dtdsl").is_file():
        desired = model.with_suffix(".dtdsl")
    arguments = ["--name", name, "--language", "cpp", "python"]
    if desired is not None:
        arguments += ["--desired", str(Path(desired).absolute())]
    arguments += options
    tool = generator()
    # What was read for this call before, and what came of it. Options may name files in the working folder.
    call = cache() / (hash_of(
        run([*tool, "--version"]).stdout, _identity(tool[0]), str(model), os.getcwd(), *arguments, *_environment()) + ".json")
    with _locks.setdefault(call.name, threading.Lock()):
        module = _known(call, quiet) or _generate(tool, model, name, arguments, call, quiet)
        return module


def _generate(tool, model, name, arguments, call, quiet):
    progress = Progress(name, quiet)
    with tempfile.TemporaryDirectory(dir=cache()) as folder:
        folder = Path(folder)
        depfile, stamp, code = folder / "depfile", folder / "stamp", folder / "code"
        progress.say(f"generating code from {model.name}")
        messages = run([
            *tool, "generate", str(model), "-o", str(code), *arguments, "--depfile", str(depfile), "--stamp", str(stamp)]).stderr
        if not stamp.is_file():
            raise Error(f"the generator writes no code with the options {' '.join(arguments[5:])}")
        report(messages, True, quiet)
        # The name has all that decides what the module computes. Layout and comments of the model make no difference.
        key = f"{name}_{hash_of(hash_of_files(code, [f for f in code.rglob('*') if f.is_file()]), *_environment())}"
        module = cache() / key / f"{name}.abi3.so"
        if not module.is_file():
            try:
                _compile(code, folder, name, progress)
            finally:
                progress.close()
            try:
                os.replace(folder / "module", cache() / key)
            except OSError:  # another process was faster
                if not module.is_file():
                    raise
            progress.end()
        read = re.split(r"(?<!\\)\s+", depfile.read_text().replace("\\\n", " ").split(":", 1)[1].strip())
        files = [Path(f.replace("\\ ", " ")) for f in read]
        hashes = {str(f): hash_of(f.read_bytes()) for f in files if f.is_file()}
        record = {"module": str(module), "messages": messages, "files": hashes}
        (folder / "record").write_text(json.dumps(record))
        os.replace(folder / "record", call)
    return module


def _known(call, quiet):
    try:
        record = json.loads(call.read_text())
        same = all(hash_of(Path(f).read_bytes()) == wanted for f, wanted in record["files"].items())
        module, messages = Path(record["module"]), record["messages"]
        if not same or not module.is_file():
            return None
    except (OSError, ValueError, KeyError):
        return None
    report(messages, False, quiet)
    return module


def _compile(code, folder, name, progress):
    command = compiler()
    headers = Path(sysconfig.get_paths()["include"])
    if not (headers / "Python.h").is_file():
        raise Error(f"{headers} has no Python.h: install the headers of this Python (Debian: python3-dev)")
    includes = ["-I", str(code), "-I", str(runtime()), "-I", str(headers)]
    is_gcc = "Free Software Foundation" in run([*command, "--version"]).stdout
    kernel_flags = [*_KERNEL_FLAGS, *_processor_flags()]
    if is_gcc:
        kernel_flags += [*_OF_GCC, *_ORDER_OF_GCC]
    else:
        kernel_flags += ["-fno-exceptions", "-ffp-contract=fast"]
    units = [(code / "python" / f"{name}.cpp", _MODULE_FLAGS)]
    for k, files in enumerate(_units(sorted((code / name).glob("*.cpp")))):
        unit = folder / f"unit{k}.cpp"
        unit.write_text("".join(f'#include "{f.relative_to(code).as_posix()}"\n' for f in files))
        units.append((unit, kernel_flags))
    objects = [str(folder / f"{k}.o") for k in range(len(units))]
    commands = [
        [*command, *_FLAGS, *flags, *includes, "-c", str(unit), "-o", file] for (unit, flags), file in zip(units, objects)]
    progress.begin(f"compiling {len(units)} files", len(units) + 1)

    def work(command_of_unit):
        run(command_of_unit)
        progress.step()

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(work, commands))
    (folder / "module").mkdir()
    link = ["-undefined", "dynamic_lookup"] if sys.platform == "darwin" else []
    run([*command, "-shared", *link, *objects, "-o", str(folder / "module" / f"{name}.abi3.so")])
    progress.step()
    shutil.copy(code / "python" / f"{name}.pyi", folder / "module")


def _units(sources):
    """Sources that are compiled together. The kernels that a source includes have its name."""
    units, size = [], 0
    for source in sources:
        kernel = source.parent / "kernel" / f"{source.stem}.h"
        bytes_ = source.stat().st_size + (kernel.stat().st_size if kernel.is_file() else 0)
        if not units or size + bytes_ > _UNIT_BYTES:
            units, size = [*units, []], 0
        units[-1].append(source)
        size += bytes_
    return units


@functools.cache
def _processor_flags():
    """The module is for this machine alone, and its cache is not shared between machines of different kinds."""
    if platform.machine() not in ("x86_64", "AMD64"):
        return []
    try:
        flags = set(re.search(r"^flags\s*:(.*)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)[1].split())
    except (OSError, TypeError):
        return []
    return ["-mavx2", "-mfma", "-fno-math-errno"] if {"avx2", "fma"} <= flags else []


@functools.cache
def _hash_of_runtime():
    folder = runtime() / "robcogen"
    return hash_of_files(folder, folder.rglob("*.h"))


def _environment():
    """What decides, besides the generated code, what a module computes."""
    flags = [*_FLAGS, *_MODULE_FLAGS, *_KERNEL_FLAGS, *_processor_flags(), *_OF_GCC, *_ORDER_OF_GCC]
    return [platform.system(), platform.machine(), os.environ.get("CXX", ""), _hash_of_runtime(), *flags]


def _identity(file):
    status = os.stat(file)
    return f"{os.path.realpath(file)} {status.st_size} {status.st_mtime_ns}"


def cache():
    folder = os.environ.get("ROBCOGEN_CACHE")
    if not folder:
        folder = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "robcogen"
    Path(folder).mkdir(parents=True, exist_ok=True)
    return Path(folder).absolute()


def name_of(model):
    """The name of a model's module if none is given."""
    name = re.sub(r"\W", "_", model.name.split(".")[0], flags=re.ASCII)
    if not name.isidentifier():
        raise Error(f"{model}: '{name}' cannot name the module, as it is not a valid identifier; give it another name")
    return name


def elements(values):
    return [values] if isinstance(values, (str, os.PathLike)) else list(values)
