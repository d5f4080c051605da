"""Derivatives in the stand-ins of JAX and PyTorch: a function with derivatives of its own is recorded when it is called with views of
the arrays that are differentiated."""
import numpy as np

differentiated: list[np.ndarray] = []
calls: list = []


def is_differentiated(array):
    return any(np.may_share_memory(array, a) for a in differentiated)


def record(function, arrays):
    """The results of the function, and the one call that was recorded: its rules, arguments and results."""
    differentiated[:] = arrays
    calls.clear()
    try:
        results = function(*arrays)
    finally:
        differentiated.clear()
    (call,) = calls
    return results if isinstance(results, tuple) else (results,), call


def gradients_of(arrays, values, gradients):
    """The gradients by arrays, from those by the arguments that are views of them."""
    result = []
    for array in arrays:
        total = np.zeros(array.shape)
        for value, gradient in zip(values, gradients):
            if gradient is not None and np.may_share_memory(value, array):
                assert gradient.shape == value.shape, (gradient.shape, value.shape)
                g = np.asarray(gradient)
                while g.size > array.size:  # the array was the same for all states
                    g = g.sum(0)
                total += g.reshape(array.shape)
        result.append(total)
    return result
