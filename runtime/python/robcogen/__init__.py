"""Robots as Python modules, without a build system: load("arm.urdf") generates the code of a robot, compiles it once and
imports it.

It needs the generator (the program robcogen: named by ROBCOGEN_TOOL, of the same wheel or installation, or on the PATH), a
C++ compiler (CXX, which may have arguments, or c++, g++, clang++) and the headers of Python. Progress, and warnings and notes
of the generator, go to stderr. Modules stay in a cache: ROBCOGEN_CACHE, or robcogen in the user's cache folder.
"""
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Union

from . import _build, _modules
from ._tools import Error
from ._version import __version__

__all__ = ["Error", "build", "load", "__version__"]

_File = Union[str, "os.PathLike[str]"]
_Words = Union[str, Iterable[str]]


def load(
        model: _File, *, name: str | None = None, desired: _File | None = None, algorithms: _Words = (), derivatives: _Words = (),
        gradients: _Words = (), tangents: _Words = (), contacts: _Words = (), floating_base: bool = False,
        snap_angles: bool = False, passive_forces: bool = False, free_mimic_joints: bool = False,
        allow_implausible: bool = False, strict: bool = False, effort: int | None = None,
        import_folders: _File | Iterable[_File] = (), options: _Words = (), quiet: bool = False) -> Any:
    """Returns the module of a robot (.kindsl, .urdf, .sdf or MJCF), of motions (.motdsl) or of transforms (.ctdsl).

    The arguments are those of build(). Loading the same model with the same options again returns the same module. Its
    name, _robcogen.<key>.<name>, is unique: it replaces no other module, and nothing replaces it.
    """
    return _modules.load(build(
        model, name=name, desired=desired, algorithms=algorithms, derivatives=derivatives,
        gradients=gradients, tangents=tangents, contacts=contacts,
        floating_base=floating_base, snap_angles=snap_angles, passive_forces=passive_forces,
        free_mimic_joints=free_mimic_joints, allow_implausible=allow_implausible, strict=strict, effort=effort,
        import_folders=import_folders, options=options, quiet=quiet))


def build(
        model: _File, *, name: str | None = None, desired: _File | None = None, algorithms: _Words = (), derivatives: _Words = (),
        gradients: _Words = (), tangents: _Words = (), contacts: _Words = (), floating_base: bool = False,
        snap_angles: bool = False, passive_forces: bool = False, free_mimic_joints: bool = False,
        allow_implausible: bool = False, strict: bool = False, effort: int | None = None,
        import_folders: _File | Iterable[_File] = (), options: _Words = (), quiet: bool = False) -> Path:
    """Builds a module and returns its path; its stub, <name>.pyi, is in the same folder.

    name: of the module; default: the model file's. desired: a list of transforms (.dtdsl); default: the one next to the
    model, or else all links. algorithms: groups of functions; default: the default groups. derivatives: such as
    "inverse_dynamics:q". gradients, tangents: the same for products with weights of the results or rates of the inputs
    (vector-Jacobian and Jacobian-vector products). "all", in any of the three: every function that none of them names, by
    its arguments; with gradients="all", JAX and PyTorch differentiate all functions of module.jax and module.torch. contacts: frames in contact, such as "foot" or "sole:surface". A
    single string is one element.

    Of a URDF, SDF or MJCF: floating_base: the root link floats. snap_angles: angles near multiples of PI/12 become these.
    passive_forces: damping and friction are part of the dynamics. free_mimic_joints: coupled joints are independent.
    allow_implausible: negative masses are warnings. strict: warnings about names and angles are errors. effort: of the search
    for cheap formulations. import_folders: for documents that others import. options: further options of
    `robcogen generate`, such as "--strict".

    quiet: no progress and no notes; warnings are printed.
    """
    model_options = {
        "--floating-base": floating_base, "--snap-angles": snap_angles, "--passive-forces": passive_forces,
        "--free-mimic-joints": free_mimic_joints, "--allow-implausible": allow_implausible, "--strict": strict}
    arguments = [option for option, is_on in model_options.items() if is_on]
    for option, values in (
            ("--algorithms", algorithms), ("--derivatives", derivatives), ("--gradients", gradients), ("--tangents", tangents)):
        if _build.elements(values):
            arguments += [option, *_build.elements(values)]
    if _build.elements(contacts):
        arguments += ["--contacts", ",".join(_build.elements(contacts))]
    if effort is not None:
        arguments += ["--effort", str(effort)]
    for folder in _build.elements(import_folders):
        arguments += ["-I", str(Path(folder).absolute())]
    return _build.build(model, name, desired, arguments + _build.elements(options), quiet)
