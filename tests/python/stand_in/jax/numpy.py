"""What robcogen.jax uses of jax.numpy."""
import numpy as np
from numpy import float32, float64, result_type  # noqa: F401

from . import Array


def asarray(data, dtype=None):
    return np.asarray(data, dtype).view(Array)


def zeros(shape, dtype=np.float64):
    return np.zeros(shape, dtype).view(Array)


def concatenate(arrays, axis):
    return np.concatenate(arrays, axis).view(Array)
