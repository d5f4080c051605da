"""python3 -m robcogen hyl.kindsl: builds the module of a robot, in this folder or in another."""
import argparse
import keyword
import shutil
import sys
from pathlib import Path

from . import Error, _build, _tools, build


class _CMakeFolder(argparse.Action):
    """Prints the folder and ends the program, without a model."""

    def __call__(self, parser, *_):
        try:
            print(_tools.cmake_folder())
        except Error as error:
            parser.exit(1, f"{error}\n")
        parser.exit()


def main():
    parser = argparse.ArgumentParser(
        prog="python3 -m robcogen", description="Builds the Python module of a robot.",
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", help="a robot: .kindsl, .urdf, .sdf or MJCF")
    parser.add_argument("-o", "--output", default=".", help="folder of the module and its stub; default: this one")
    parser.add_argument("--name", help="name of the module; default: that of the file")
    parser.add_argument("--desired", help="list of transforms (.dtdsl)")
    parser.add_argument("--quiet", action="store_true", help="no progress and no notes")
    parser.add_argument("--algorithms", nargs="+", default=(), help="groups of functions, or all")
    parser.add_argument("--derivatives", nargs="+", default=(), help="functions to differentiate: function:input…")
    parser.add_argument(
        "--cmake-dir", nargs=0, action=_CMakeFolder, help="print the folder of the CMake package, for -Drobcogen_DIR=…, and exit")
    parser.epilog = (
        "Other options are passed on to `robcogen generate`.\n\nExample:\n"
        "  python3 -m robcogen arm.urdf -o modules --algorithms inverse_dynamics jacobians")
    given, others = parser.parse_known_args()
    try:
        name = given.name or _build.name_of(Path(given.model))
        if keyword.iskeyword(name) or name in sys.stdlib_module_names:
            what = "a keyword of Python" if keyword.iskeyword(name) else "a module of Python's standard library, which yours would hide"
            raise Error(f"'{name}' is {what}: name the module with --name")
        module = build(
            given.model, name=given.name, desired=given.desired, algorithms=given.algorithms, derivatives=given.derivatives,
            options=others, quiet=given.quiet)
    except Error as error:
        print(error, file=sys.stderr)
        return 1
    folder = Path(given.output)
    folder.mkdir(parents=True, exist_ok=True)
    for file in module.parent.iterdir():
        shutil.copy(file, folder)
    print(folder / module.name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
