"""The modules that robcogen.load() imports. A pickle of their functions and results refers to them by their names here."""
from robcogen import _modules

__path__ = _modules.folders
