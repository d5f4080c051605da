"""Modules that were built, as _robcogen.<key>.<name>: names that are unique, and by which pickles find them again."""
import importlib
import sys

from ._build import cache

# The folders in which the package _robcogen looks for its parts; each is a cache.
folders = [str(cache())]


class _Explanation:
    """The last finder that is asked. It finds nothing, and says why a module of another cache is not there."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        if name.startswith("_robcogen."):
            raise ModuleNotFoundError(
                f"{name} is not in the cache {folders[-1]}: load its model with robcogen.load() first", name=name)
        return None


sys.meta_path.append(_Explanation)


def load(path):
    """Imports a module that was built, or returns it if it is already loaded."""
    folder, key, name = str(path.parent.parent), path.parent.name, path.name.split(".")[0]
    if folder not in folders:
        folders.append(folder)
    # The import system remembers the contents of folders for a while.
    importlib.invalidate_caches()
    return importlib.import_module(f"_robcogen.{key}.{name}")
