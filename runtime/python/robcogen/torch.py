"""The functions of a module for tensors of PyTorch, with their derivatives: `module.torch`.

CPU tensors share their memory with NumPy arrays, so a call copies neither arguments nor results. Derivatives are functions
of the module. No library of PyTorch is linked: a module serves every version."""
from typing import Any

import numpy as np
import torch

from . import _differentiable
from ._differentiable import Function, Functions

_TYPES = (torch.float64, torch.float32)
# PyTorch 2 separates the two, which its function transforms (torch.func) need.
_HAS_SETUP = hasattr(torch.autograd.Function, "setup_context")


def functions(module: Any) -> Functions:
    """The functions of a module that robcogen built, as attributes in their scopes. They take tensors (..., n)."""
    return _differentiable.namespace(module, "torch", _make)


def _make(f: Function, call: Any) -> Any:
    operator = _operator(f, call)

    def function(*args: Any, **kwargs: Any) -> Any:
        values = f.bind(args, kwargs)
        if not _are_alike(values):
            values = _tensors(f, values)
        leads = [a.leading(f.name, v.shape) for a, v in zip(f.arguments, values)]
        lead = leads[0] if all(x == leads[0] for x in leads) else _broadcast(f, leads)
        if len(lead) > 1 or any(x != lead for x in leads):
            values = [v.expand(lead + a.shape).reshape(_flat(lead) + a.shape) for a, v in zip(f.arguments, values)]
        results = operator.apply(*values)
        if len(lead) > 1:
            results = [r.reshape(lead + r.shape[1:]) for r in results]
        return f.collected(results)

    return function


def _are_alike(values: list[Any]) -> bool:
    """Whether nothing has to be converted or refused."""
    return len(values) > 0 and all(isinstance(v, torch.Tensor) and v.is_cpu and v.dtype is values[0].dtype in _TYPES for v in values)


def _flat(lead: tuple[int, ...]) -> tuple[int, ...]:
    return (torch.Size(lead).numel(),) if lead else ()


def _broadcast(f: Function, leads: list[tuple[int, ...]]) -> tuple[int, ...]:
    try:
        return tuple(torch.broadcast_shapes(*leads))
    except RuntimeError:
        listed = ", ".join(f"{a.name}: {lead}" for a, lead in zip(f.arguments, leads))
        raise ValueError(f"{f.name}: the leading dimensions do not fit together: {listed}") from None


def _tensors(f: Function, values: list[Any]) -> list[torch.Tensor]:
    """The arguments as tensors of one type; numbers and NumPy arrays get the type of the tensors."""
    types = {v.dtype for v in values if isinstance(v, torch.Tensor)}
    dtype = torch.float64 if torch.float64 in types or not types else torch.float32
    result = []
    for a, v in zip(f.arguments, values):
        if a.is_parameters and isinstance(v, getattr(f.module, "Parameters", ())):
            v = [getattr(v, name) for name in f.module.parameter_names]
        v = v if isinstance(v, torch.Tensor) else torch.as_tensor(v, dtype=dtype)
        if v.device.type != "cpu":
            raise TypeError(
                f"{f.name}: {a.name} is on {v.device}, and these functions run on the CPU: pass {a.name}.cpu(), or use the "
                "functions for GPUs, LANGUAGES gpu (runtime/GPU.md)")
        if v.dtype not in _TYPES:
            raise TypeError(f"{f.name}: {a.name} must be of torch.float64 or torch.float32, is of {v.dtype}")
        result.append(v.to(dtype))
    return result


def _compute(f: Function, values: tuple[torch.Tensor, ...]) -> tuple[torch.Tensor, ...]:
    """Computes arrays of one state or of (N,) states."""
    arrays = [(v.detach() if v.requires_grad else v).numpy() for v in values]
    if arrays and f.arguments[0].is_parameters:
        rows = arrays[0].reshape(-1, arrays[0].shape[-1])
        if len(rows) != 1 and arrays[0].strides[0] != 0:
            return _compute_each(f, values)
        if len(rows) == 0:
            return tuple(values[0].new_empty((0, *r.shape)) for r in f.results)
        arrays[0] = f.module.Parameters(**dict(zip(f.module.parameter_names, rows[0].tolist())))
    results = f.compute(*arrays)
    if f.structure is None:
        results = (results,)
    # The energy of one state is not an array.
    dtype = values[0].dtype if values else torch.float64
    return tuple(torch.from_numpy(r) if isinstance(r, np.ndarray) else torch.tensor(r, dtype=dtype) for r in results)


def _compute_each(f: Function, values: tuple[torch.Tensor, ...]) -> tuple[torch.Tensor, ...]:
    """States whose parameters differ are computed one after another."""
    states = [_compute(f, state) for state in zip(*values)]
    return tuple(torch.stack(r) for r in zip(*states))


def _operator(f: Function, call: Any) -> Any:
    """The function for tensors that all have the dimension of the states, or none of them."""

    class Operator(torch.autograd.Function):
        @staticmethod
        def setup_context(ctx: Any, inputs: Any, output: Any) -> None:
            ctx.save_for_backward(*inputs)
            ctx.save_for_forward(*inputs)

        @staticmethod
        def backward(ctx: Any, *weights: Any) -> Any:
            needed = [a.name for a, is_needed in zip(f.arguments, ctx.needs_input_grad) if is_needed]
            found = _differentiable.gradients(f, list(ctx.saved_tensors), list(weights), needed, call, torch.cat)
            return tuple(found.get(a.name) for a, _ in zip(f.arguments, ctx.needs_input_grad))

        @staticmethod
        def jvp(ctx: Any, *rates: Any) -> Any:
            given = {a.name: r for a, r in zip(f.arguments, rates) if r is not None}
            return tuple(_differentiable.tangents(f, list(ctx.saved_tensors), given, call, torch.cat))

        @staticmethod
        def vmap(info: Any, in_dims: Any, *values: Any) -> Any:
            moved = [v if d is None else v.movedim(d, 0) for v, d in zip(values, in_dims)]
            results = call(f)(*moved)
            results = (results,) if f.structure is None else tuple(results)
            return results, tuple(0 for _ in results)

    if _HAS_SETUP:
        Operator.forward = staticmethod(lambda *values: _compute(f, values))
    else:
        def forward(ctx: Any, *values: Any) -> Any:
            Operator.setup_context(ctx, values, None)
            return _compute(f, values)
        Operator.forward = staticmethod(forward)
        del Operator.vmap
    return Operator
