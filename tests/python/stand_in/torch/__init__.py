"""What robcogen.torch uses of PyTorch 2, over NumPy."""
import types

import numpy as np

import tape

float64, float32, float16 = np.dtype("f8"), np.dtype("f4"), np.dtype("f2")


class Tensor(np.ndarray):
    requires_grad, is_cpu, device = False, True, types.SimpleNamespace(type="cpu")

    def detach(self):
        return self

    def numpy(self):
        return np.asarray(self)

    def expand(self, shape):
        return np.broadcast_to(self, shape, subok=True)

    def to(self, dtype):
        return self if dtype == self.dtype else self.astype(dtype)

    def movedim(self, source, destination):
        return np.moveaxis(self, source, destination)

    def new_empty(self, shape):
        return np.empty(shape, self.dtype).view(Tensor)


class Size(tuple):
    def numel(self):
        return int(np.prod(self))


def from_numpy(array):
    return array.view(Tensor)


def as_tensor(data, dtype=None):
    return np.asarray(data, dtype).view(Tensor)


tensor = as_tensor


def cat(tensors, axis):
    return np.concatenate(tensors, axis).view(Tensor)


def stack(tensors):
    return np.stack(tensors).view(Tensor)


def broadcast_shapes(*shapes):
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError as error:
        raise RuntimeError(str(error)) from None


class Context:
    def save_for_backward(self, *tensors):
        self.saved_tensors = tensors

    def save_for_forward(self, *tensors):
        assert tensors == self.saved_tensors or all(a is b for a, b in zip(tensors, self.saved_tensors))


class _Function:
    @staticmethod
    def setup_context(ctx, inputs, output):
        raise NotImplementedError

    @classmethod
    def apply(cls, *values):
        results = cls.forward(*values)
        ctx = Context()
        cls.setup_context(ctx, values, results)
        ctx.needs_input_grad = tuple(map(tape.is_differentiated, values))
        if any(ctx.needs_input_grad):
            tape.calls.append(((cls, ctx), values, results))
        return results


autograd = types.SimpleNamespace(Function=_Function)
