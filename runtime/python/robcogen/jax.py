"""The functions of a module for arrays of JAX, with their derivatives: `module.jax`.

XLA calls a handler of the module, without Python and in one call for all states of a batch. Derivatives are functions of the
module. A module is built without JAX and serves every version from 0.5 on."""
import itertools
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from . import _differentiable
from ._differentiable import Function, Functions

_TYPES = (np.dtype(np.float64), np.dtype(np.float32))
_numbers = itertools.count(1)


def functions(module: Any) -> Functions:
    """The functions of a module that robcogen built, as attributes in their scopes. They take arrays (..., n)."""
    if not hasattr(jax, "ffi"):
        raise ImportError(f"{module.__name__}.jax needs jax.ffi, which is part of JAX from 0.5 on; this is JAX {jax.__version__}")
    # Modules of different robots may have one name.
    target = f"robcogen_{module.__name__}_{next(_numbers)}"
    jax.ffi.register_ffi_target(target, module._xla_handler, platform="cpu")
    return _differentiable.namespace(module, "jax", lambda f, call: _make(f, call, target))


def _make(f: Function, call: Any, target: str) -> Any:
    operator = _operator(f, call, target)

    def function(*args: Any, **kwargs: Any) -> Any:
        values = _arrays(f, f.bind(args, kwargs))
        leads = [a.leading(f.name, v.shape) for a, v in zip(f.arguments, values)]
        rank = max(map(len, leads), default=0)
        # Arrays that are the same for all states keep their size.
        values = [v.reshape((1,) * (rank - len(lead)) + v.shape) for v, lead in zip(values, leads)]
        return f.collected(operator(*values))

    return function


def _arrays(f: Function, values: list[Any]) -> list[Any]:
    """The arguments as arrays of one type; numbers and NumPy arrays get the type of the arrays of JAX."""
    given = [v.dtype for v in values if isinstance(v, jax.Array)]
    dtype = jnp.result_type(*given) if given else jnp.zeros(()).dtype
    arrays = []
    for a, v in zip(f.arguments, values):
        if isinstance(v, jax.Array) and v.dtype not in _TYPES:
            raise TypeError(f"{f.name}: {a.name} must be of float64 or float32, is of {v.dtype}")
        if a.is_parameters and isinstance(v, getattr(f.module, "Parameters", ())):
            v = [getattr(v, name) for name in f.module.parameter_names]
        arrays.append(jnp.asarray(v, dtype=dtype))
    return arrays


def _lead(f: Function, values: tuple[Any, ...]) -> tuple[int, ...]:
    leads = [a.leading(f.name, v.shape) for a, v in zip(f.arguments, values)]
    try:
        return np.broadcast_shapes(*leads)
    except ValueError:
        listed = ", ".join(f"{a.name}: {lead}" for a, lead in zip(f.arguments, leads))
        raise ValueError(f"{f.name}: the leading dimensions do not fit together: {listed}") from None


def _operator(f: Function, call: Any, target: str) -> Any:
    """The function for arrays that all have as many leading dimensions; a tuple of results."""

    def compute(*values: Any) -> tuple[Any, ...]:
        lead, dtype = _lead(f, values), values[0].dtype if values else jnp.zeros(()).dtype
        results = tuple(jax.ShapeDtypeStruct(lead + r.shape, dtype) for r in f.results)
        return tuple(jax.ffi.ffi_call(target, results, vmap_method="expand_dims")(*values, function=np.int64(f.index)))

    forms = {d.form for d in f.derivatives}
    return _with_gradients(f, call, compute) if "gradient" in forms else _with_tangents(f, call, compute)


def _with_gradients(f: Function, call: Any, compute: Any) -> Any:
    """The function in reverse mode."""
    operator = jax.custom_vjp(compute)

    def forward(*primals: Any) -> Any:
        values = tuple(p.value for p in primals)
        needed = [a.name for a, p in zip(f.arguments, primals) if p.perturbed]
        f.derivatives_by(needed, ("gradient", "matrix"), "gradient")
        # The names are part of the structure, which is not traced.
        return operator(*values), (values, {name: None for name in needed})

    def backward(residuals: Any, weights: Any) -> Any:
        values, names = residuals
        weights = [jnp.zeros(w.shape, w.dtype) if isinstance(w, jax.custom_derivatives.SymbolicZero) else w for w in weights]
        needed = [a.name for a in f.arguments if a.name in names]
        found = _differentiable.gradients(f, list(values), weights, needed, call, jnp.concatenate)
        return tuple(_summed(found.get(a.name), v) for a, v in zip(f.arguments, values))

    operator.defvjp(forward, backward, symbolic_zeros=True)
    return operator


def _with_tangents(f: Function, call: Any, compute: Any) -> Any:
    """The function in forward mode, and with matrices of derivatives in both modes."""
    operator = jax.custom_jvp(compute)
    missing = "derivative" if f.derivatives else "gradient"

    def tangent(primals: Any, rates: Any) -> Any:
        given = {
            a.name: r for a, r in zip(f.arguments, rates) if not isinstance(r, jax.custom_derivatives.SymbolicZero)}
        return operator(*primals), tuple(_differentiable.tangents(f, list(primals), given, call, jnp.concatenate, missing))

    operator.defjvp(tangent, symbolic_zeros=True)
    return operator


def _summed(gradient: Any, value: Any) -> Any:
    """The gradient by an array that is the same for some states."""
    if gradient is None:
        return None
    same = tuple(k for k, (of_all, own) in enumerate(zip(gradient.shape, value.shape)) if own != of_all)
    return gradient.sum(same, keepdims=True) if same else gradient
