"""What robcogen.torch and robcogen.jax have in common: the functions of a module, which of them are derivatives of which,
and products with these derivatives. Arrays are those of the caller's library, whose `concatenate` it passes."""
import difflib
import math
from typing import Any, NamedTuple

import numpy as np


class Array(NamedTuple):
    """An argument or a result for one state."""
    name: str
    shape: tuple[int, ...]
    quaternions: tuple[int, ...]  # the elements that begin unit quaternions
    is_by_rows: bool              # how derivatives list the elements of a matrix; otherwise by columns
    is_parameters: bool

    def leading(self, function: str, shape: tuple[int, ...]) -> tuple[int, ...]:
        """The dimensions of the states in an array of this shape."""
        lead = len(shape) - len(self.shape)
        if lead < 0 or tuple(shape[lead:]) != self.shape:
            wanted = ", ".join(["...", *map(str, self.shape)])
            raise ValueError(f"{function}: {self.name} must have the shape ({wanted}), has {tuple(shape)}")
        return tuple(shape[:lead])


class Derivative(NamedTuple):
    """A function of the module whose results are those of another one, then products with its derivatives by `inputs`."""
    form: str  # gradient: with weights of the results; tangent: with rates of the inputs; matrix: the derivatives themselves
    function: "Function"
    inputs: tuple[str, ...]


class Function:
    def __init__(self, module: Any, index: int, description: Any):
        scope, name, arguments, self.required, self.overloads, results = description
        self.module, self.index, self.scope = module, index, scope
        self.name = f"{scope}.{name}" if scope else name
        self.arguments = [Array(*a) for a in arguments]
        self.results = [Array(*r) for r in results]
        self.compute = module
        for part in self.name.split("."):
            self.compute = getattr(self.compute, part)
        structure = self.name.replace(".", "_") + "_result"
        self.structure = getattr(module, structure) if len(self.results) != 1 else None
        self.by_name = {a.name: a for a in self.arguments}
        self.derivatives: list[Derivative] = []
        self.is_derivative = False
        self._chosen: dict[Any, list[Derivative]] = {}

    def bind(self, args: tuple[Any, ...], kwargs: dict[str, Any]) -> list[Any]:
        """The arguments of the smallest overload that takes all that are given, with defaults."""
        if not kwargs and len(args) in self.overloads and not any(x is None for x in args):
            return list(args)
        names = list(self.by_name)
        if len(args) > len(names):
            raise TypeError(f"{self.name}: takes at most {len(names)} arguments, got {len(args)}")
        given = dict(zip(names, args))
        for name, value in kwargs.items():
            if name not in names:
                raise TypeError(f"{self.name}: unknown argument '{name}'; the arguments are {', '.join(names)}")
            if name in given:
                raise TypeError(f"{self.name}: {name} is given twice")
            given[name] = value
        given = {name: value for name, value in given.items() if value is not None}
        last = max([self.required, *(names.index(name) + 1 for name in given)])
        count = min(n for n in self.overloads if n >= last)
        return [given[a.name] if a.name in given else self._default(k) for k, a in enumerate(self.arguments[:count])]

    def _default(self, k: int) -> Any:
        a = self.arguments[k]
        if k >= self.required and a.name == "gravity":
            return np.array([0.0, 0.0, -9.81])
        raise TypeError(f"{self.name}: {a.name} is missing")

    def derivatives_by(self, needed: list[str], forms: tuple[str, ...], missing: str) -> list[Derivative]:
        """Functions that together have the derivatives by these inputs. A TypeError asks for what is missing."""
        key = (*needed, *forms)
        if key not in self._chosen:
            self._chosen[key] = self._choose(needed, forms, missing)
        return self._chosen[key]

    def _choose(self, needed: list[str], forms: tuple[str, ...], missing: str) -> list[Derivative]:
        left, chosen = set(needed), []
        known = sorted((d for d in self.derivatives if d.form in forms), key=lambda d: forms.index(d.form))
        while left:
            best = max(known, key=lambda d: len(left & set(d.inputs)), default=None)
            if best is None or not left & set(best.inputs):
                self._refuse(needed, [name for name in needed if name in left], missing)
            chosen.append(best)
            left -= set(best.inputs)
        return chosen

    def _refuse(self, needed: list[str], missing: list[str], form: str) -> None:
        # A gradient has no gradient by the same argument: both would have one name.
        form = "derivative" if self.is_derivative else form
        element = f"{self.name}:{','.join(needed)}"
        raise TypeError(
            f"{self.name}: the module '{self.module.__name__.rpartition('.')[2]}' has no {form} by {', '.join(missing)}; generate it with "
            f"{form.upper()}S {element} in CMake, --{form}s {element}, or robcogen.load(..., {form}s=\"{element}\")")

    def collected(self, results: list[Any]) -> Any:
        return results[0] if self.structure is None else self.structure(*results)


class Functions:
    """The functions of a scope, as attributes."""

    def __init__(self, name: str):
        self._name = name

    def __getattr__(self, name: str) -> Any:
        near = difflib.get_close_matches(name, [n for n in vars(self) if n[0] != "_"], 1)
        hint = f"; did you mean '{near[0]}'?" if near else ""
        raise AttributeError(f"{self._name} has no function '{name}'{hint}", name=name, obj=self)

    def __repr__(self) -> str:
        return f"<{self._name}: functions of robcogen>"


def functions(module: Any) -> list[Function]:
    """All functions of a module, with their derivatives."""
    if not hasattr(module, "_functions"):
        raise TypeError(f"{module!r} is not a module of robcogen, or of a version without automatic differentiation")
    everything = [Function(module, k, d) for k, d in enumerate(module._functions)]
    by_name = {f.name: f for f in everything}
    for g in everything:
        for end in range(len(g.name), 0, -1):
            f = by_name.get(g.name[:end]) if g.name[end:end + 1] == "_" else None
            derivative = _derivative(f, g) if f is not None else None
            if derivative is not None:
                f.derivatives.append(derivative)
                g.is_derivative = True
                break
    return everything


def _derivative(f: Function, g: Function) -> Derivative | None:
    """What g is for f, by its name, arguments and results; None if it is no derivative of f."""
    count = len(f.results)
    if [r[:2] for r in g.results[:count]] != [r[:2] for r in f.results]:
        return None
    words, further = g.name[len(f.name) + 1:], [r.name for r in g.results[count:]]
    new = [a.name for a in g.arguments if a.name not in {b.name for b in f.arguments}]
    blocks = [f"{r.name}_d_" if count > 1 else "d_" for r in f.results]
    if new and all(name.endswith("_tangent") for name in new) and further == [f"{r.name}_tangent" for r in f.results]:
        form, inputs = "tangent", tuple(name.removesuffix("_tangent") for name in new)
    elif new == _weights(f) and all(name.startswith("d_") for name in further):
        form, inputs = "gradient", tuple(name[2:] for name in further)
    elif not new and count > 0 and len(further) % count == 0 and all(n.startswith(b) for n, b in zip(further, blocks * len(further))):
        form, inputs = "matrix", tuple(name[len(blocks[0]):] for name in further[::count])
    else:
        return None
    of_group = {"gradient": "gradient", "matrix": "derivatives"}.get(form)
    infix = "d" if form == "matrix" else form
    is_one = inputs and words in (of_group, "_".join([infix, *inputs]))
    # Only base_rotation is no argument of f. A tangent needs its rate.
    is_usable = form != "tangent" or {a.name for a in f.arguments}.issuperset(inputs)
    # The library flattens matrices of second derivatives.
    shapes = [(r.shape, d.shape if form == "tangent" else d.shape[:-1]) for r, d in zip(f.results * len(inputs), g.results[count:])]
    has_shapes = form == "gradient" or all(of_derivative == (shape or (1,)) for shape, of_derivative in shapes)
    return Derivative(form, g, inputs) if is_one and is_usable and has_shapes else None


def _weights(f: Function) -> list[str]:
    return ["weights"] if len(f.results) == 1 else [f"{r.name}_weights" for r in f.results]


def namespace(module: Any, library: str, make: Any) -> Functions:
    """The functions of the module, each made by `make(function, call)`, where `call(name)` is another one, in their scopes."""
    name = f"{module.__name__.rpartition('.')[2]}.{library}"
    made: dict[str, Any] = {}
    result = Functions(name)
    for f in functions(module):
        made[f.name] = make(f, lambda other: made[other.name])
        made[f.name].__name__ = made[f.name].__qualname__ = f.name.rpartition(".")[2]
        made[f.name].__doc__ = f.compute.__doc__
        scope = result
        for part in f.scope.split(".") if f.scope else ():
            if part not in vars(scope):
                setattr(scope, part, Functions(f"{scope._name}.{part}"))
            scope = getattr(scope, part)
        setattr(scope, made[f.name].__name__, made[f.name])
    return result


# Products with derivatives. A derivative by a unit quaternion has three elements, rotations about the axes of the child; here
# it has four, those of the function of the normalised quaternion. Elements of q that follow others through loops are zero.

def gradients(f: Function, values: list[Any], weights: list[Any], needed: list[str], call: Any, concatenate: Any) -> dict[str, Any]:
    """The gradients of the sum of the results times `weights` by the arguments `needed`."""
    given = {a.name: v for a, v in zip(f.arguments, values)}
    result = {}
    for derivative in f.derivatives_by(needed, ("gradient", "matrix"), "gradient"):
        g = derivative.function
        if derivative.form == "gradient":
            flat = {name: _by_columns(w, r) for name, w, r in zip(_weights(f), weights, f.results)}
            parts = _further(f, g, call(g)(**given, **flat))
        else:
            blocks = _further(f, g, call(g)(**given))
            flat = [_flat(w, r.shape)[..., None, :] for w, r in zip(weights, f.results)]
            count = len(f.results)
            sums = [sum(w @ _as_matrix(b, r) for w, b, r in zip(flat, blocks[k:], f.results)) for k in range(0, len(blocks), count)]
            parts = [s[..., 0, :] for s in sums]
        for name, part in zip(derivative.inputs, parts):
            if name not in f.by_name:
                continue
            result[name] = _unreduced(f.by_name[name], part, given[name], concatenate)
    return result


def tangents(
        f: Function, values: list[Any], rates: dict[str, Any], call: Any, concatenate: Any, missing: str = "tangent") -> list[Any]:
    """The rates of the results if these arguments change at these rates. `missing`: what an error asks for."""
    given = {a.name: v for a, v in zip(f.arguments, values)}
    result: list[Any] = [0 for _ in f.results]
    left = dict(rates)
    for derivative in f.derivatives_by(list(rates), ("tangent", "matrix"), missing):
        g = derivative.function

        def rate(name: str, size: int) -> Any:
            value = left.pop(name) if name in left else 0 * given[name]
            return _reduced(f.by_name[name], value, given[name], size, concatenate)

        if derivative.form == "tangent":
            further = {f"{n}_tangent": rate(n, g.by_name[f"{n}_tangent"].shape[0]) for n in derivative.inputs}
            changes = _further(f, g, call(g)(**given, **further))
            # A number has a vector of one element as its rate.
            parts = [p.reshape((*p.shape[:p.ndim - len(a.shape)], *r.shape)) for p, a, r in zip(changes, g.results[len(f.results):], f.results)]
        else:
            blocks, count = _further(f, g, call(g)(**given)), len(f.results)
            parts = [0 for _ in f.results]
            for k, name in enumerate(derivative.inputs):
                if name not in f.by_name:
                    continue
                by_name = [_as_matrix(b, r) for b, r in zip(blocks[k * count:], f.results)]
                change = rate(name, by_name[0].shape[-1])[..., None]
                for i, (block, r) in enumerate(zip(by_name, f.results)):
                    part = (block @ change)[..., 0]
                    parts[i] = parts[i] + part.reshape((*part.shape[:-1], *r.shape))
        result = [a + b for a, b in zip(result, parts)]
    return result


def _further(f: Function, g: Function, results: Any) -> list[Any]:
    return list(results)[len(f.results):]


def _flat(array: Any, shape: tuple[int, ...]) -> Any:
    return array.reshape((*array.shape[:array.ndim - len(shape)], math.prod(shape)))


def _as_matrix(block: Any, result: Array) -> Any:
    """The derivative of a result by an input: a row for each element of the result."""
    lead = block.shape[:block.ndim - max(2, len(result.shape) + 1)]
    return block.reshape((*lead, math.prod(result.shape), block.shape[-1]))


def _by_columns(array: Any, a: Array) -> Any:
    """The elements of a matrix column by column, and of several matrices one after another."""
    if len(a.shape) == 1:
        return array
    for k in range(len(a.shape) // 2):
        array = array.swapaxes(array.ndim - len(a.shape) + k, array.ndim - 1 - k)
    return _flat(array, a.shape)


def _unreduced(a: Array, reduced: Any, value: Any, concatenate: Any) -> Any:
    """The gradient by each element of an argument, from that by its independent changes."""
    if len(a.shape) == 2:
        return _matrix(reduced, a)
    if not a.quaternions and reduced.shape[-1] == a.shape[0]:
        return reduced
    pieces, k, j = [], 0, 0
    while j < reduced.shape[-1]:
        if k in a.quaternions:
            w, v, turn = value[..., k:k + 1], value[..., k + 1:k + 4], reduced[..., j:j + 3]
            pieces += [-2 * (v * turn).sum(-1)[..., None], 2 * (w * turn + _cross(v, turn, concatenate))]
            k, j = k + 4, j + 3
        else:
            pieces.append(reduced[..., j:j + 1])
            k, j = k + 1, j + 1
    return concatenate([*pieces, *[0 * reduced[..., :1]] * (a.shape[0] - k)], -1)


def _reduced(a: Array, rate: Any, value: Any, size: int, concatenate: Any) -> Any:
    """The rates of the independent changes of an argument, from those of its elements."""
    if len(a.shape) == 2:
        return _flat(rate if a.is_by_rows else rate.swapaxes(-1, -2), a.shape)
    if not a.quaternions and size == a.shape[0]:
        return rate
    pieces, k, j = [], 0, 0
    while j < size:
        if k in a.quaternions:
            w, v, dw, dv = value[..., k:k + 1], value[..., k + 1:k + 4], rate[..., k:k + 1], rate[..., k + 1:k + 4]
            pieces.append(2 * (w * dv - dw * v - _cross(v, dv, concatenate)))
            k, j = k + 4, j + 3
        else:
            pieces.append(rate[..., k:k + 1])
            k, j = k + 1, j + 1
    return concatenate(pieces, -1)


def _matrix(flat: Any, a: Array) -> Any:
    rows, columns = a.shape
    if a.is_by_rows:
        return flat.reshape((*flat.shape[:-1], rows, columns))
    return flat.reshape((*flat.shape[:-1], columns, rows)).swapaxes(-1, -2)


def _cross(a: Any, b: Any, concatenate: Any) -> Any:
    def element(i: int, j: int) -> Any:
        return a[..., i:i + 1] * b[..., j:j + 1] - a[..., j:j + 1] * b[..., i:i + 1]
    return concatenate([element(1, 2), element(2, 0), element(0, 1)], -1)
