"""Calls of the functions over many states that LANGUAGES gpu makes, for the packages that it prints (runtime/GPU.md): they
take arrays of CuPy, PyTorch, JAX and others. Such a package is a table of functions; what they have in common is here.
"""
import ctypes
import math
import pathlib
import sys

_BY_ELEMENT, _BY_STATE, _SAME_FOR_ALL = 1, 2, 3  # enum robcogen_gpu_layout
_CPU = (1, 3)  # DLDeviceType: memory of the processor
_LETTERS = {"<f8": "", "<f4": "f"}  # the ends of names, by the type of numbers
_MESSAGES = (  # robcogen_gpu_message() of robcogen/gpu/batch.h
    "success",
    "the number of states is negative",
    "an array has 2^31 elements or more",
    "a stride is too small",
    "an array is null or misaligned",
    "the library has no code for this device",
    "the kernel did not start",
    "the workspace is too small, null or misaligned",
    "an array cannot have this layout: results differ from state to state, and lower triangles are those of "
    "symmetric results, with tiles of all other arrays",
)


class _Layout(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("layout", ctypes.c_int), ("stride", ctypes.c_ssize_t)]


class _Workspace(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("bytes", ctypes.c_size_t)]


class _Tensor(ctypes.Structure):  # DLTensor of DLPack
    _fields_ = [
        ("data", ctypes.c_void_p),
        ("device_type", ctypes.c_int32),
        ("device", ctypes.c_int32),
        ("dimensions", ctypes.c_int32),
        ("code", ctypes.c_uint8),
        ("bits", ctypes.c_uint8),
        ("lanes", ctypes.c_uint16),
        ("shape", ctypes.POINTER(ctypes.c_int64)),
        ("strides", ctypes.POINTER(ctypes.c_int64)),
        ("offset", ctypes.c_uint64),
    ]


class Library:
    """The library of the package whose file this is: _functions.so in its folder, unless `load` names another one."""

    def __init__(self, file):
        self._path = pathlib.Path(file).with_name("_functions.so")
        self._loaded = None
        self.on_host = False

    def load(self, path, on_host=False):
        """Loads the library of functions over many states, by default the file _functions.so in this folder. `on_host`: it
        was compiled for the processor, for tests, and takes arrays in its memory."""
        self._loaded = ctypes.CDLL(str(path))
        self.on_host = on_host

    def symbol(self, name):
        if self._loaded is None:
            self.load(self._path)
        return getattr(self._loaded, name)

    def function(self, *definition):
        return Function(self, *definition)


class _Memory:
    """Where the numbers of an array are: `__cuda_array_interface__`, or else `__dlpack__`."""

    def __init__(self, name, array, writable, stream, on_host):
        self.owner = array
        interface = getattr(array, "__cuda_array_interface__", None)
        if interface is not None:
            self.data, read_only = interface["data"]
            if writable and read_only:
                raise ValueError(f"{name} is read-only")
            self.type = interface["typestr"]
            self.shape = tuple(interface["shape"])
            self.size = int(self.type[2:])
            strides = interface.get("strides")
        elif hasattr(array, "__dlpack__"):
            strides = self._take(name, array, stream, on_host)
        else:
            raise TypeError(f"{name} has neither __cuda_array_interface__ nor __dlpack__: {type(array).__name__}")
        contiguous = tuple(self.size * math.prod(self.shape[k + 1 :]) for k in range(len(self.shape)))
        self.strides = contiguous if strides is None else tuple(strides)
        self.is_contiguous = self.strides == contiguous

    def _take(self, name, array, stream, on_host):
        # The capsule is not consumed: it releases the memory when this object goes.
        on_device = array.__dlpack_device__()[0] not in _CPU
        if not (on_device or on_host):
            raise TypeError(f"{name} is in the memory of the processor")
        # 1 is the default stream of CUDA in DLPack.
        self.owner = array.__dlpack__(stream=stream or 1) if on_device else array.__dlpack__()
        pointer = ctypes.pythonapi.PyCapsule_GetPointer
        pointer.restype, pointer.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
        tensor = _Tensor.from_address(pointer(self.owner, b"dltensor"))
        self.data = (tensor.data or 0) + tensor.offset
        self.type = {2: "<f"}.get(tensor.code, "?") + str(tensor.bits // 8)
        self.size = tensor.bits // 8
        self.shape = tuple(tensor.shape[: tensor.dimensions])
        return [self.size * s for s in tensor.strides[: tensor.dimensions]] if tensor.strides else None


def _layout(name, memory, shape, output, count):
    """The layout of an array of n states, each of this shape; its matrices are stored column by column."""
    size, rank = memory.size, len(shape)
    given, strides = memory.shape[-rank:], memory.strides[-rank:]
    same = len(memory.shape) == rank and not output
    if given != shape or not (same or memory.shape == (count, *shape)):
        wanted = f"({', '.join(map(str, (count, *shape)))})"
        raise ValueError(f"{name} must have the shape {wanted}{'' if output else ' or ' + str(shape)}, has {memory.shape}")
    # Distances of neighbouring elements in columns and of columns; an axis with one place has any.
    distances = [(s, k) for s, k, extent in zip(strides, (1, shape[0]), shape) if extent > 1]
    between_states = size if same or count == 1 else memory.strides[0]
    step = distances[0][0] // distances[0][1] if distances else size
    if any(s != k * step for s, k in distances) or step % size or between_states % size or step <= 0:
        hint = "; matrices are stored column by column" if rank > 1 else ""
        raise ValueError(f"{name}: these strides are not supported{hint}: {memory.strides}")
    numbers = math.prod(shape)
    if step == size and not output and (same or between_states == 0):
        return _Layout(memory.data, _SAME_FOR_ALL, 0)
    if step == size and not same and (count == 1 or between_states >= size * numbers):
        return _Layout(memory.data, _BY_STATE, max(between_states // size, numbers))
    if between_states == size and not same:
        return _Layout(memory.data, _BY_ELEMENT, step // size)
    raise ValueError(f"{name}: neither states nor elements are contiguous: strides {memory.strides}")


def _empty(like, shape):
    """A new array of the library that `like` belongs to, for results. Matrices are stored column by column."""
    stored = shape if len(shape) < 3 else (shape[0], shape[2], shape[1])
    if hasattr(like, "new_empty"):  # PyTorch
        new = like.new_empty(stored)
    else:  # CuPy, NumPy
        module = sys.modules[type(like).__module__.partition(".")[0]]
        if not hasattr(module, "empty"):
            raise TypeError(f"arrays for results cannot be made like {type(like).__name__}: give them as out=")
        new = module.empty(stored, dtype=like.dtype)
    return new if len(shape) < 3 else new.swapaxes(1, 2)


class Function:
    """A function over many states. `arrays`: name, shape for one state, and whether it is a result; `workspace`: elements
    for one state."""

    def __init__(self, library, name, symbol, arrays, workspace, summary):
        self._library = library
        self.__name__ = name
        self.__doc__ = summary
        self._symbol = symbol
        self._inputs = [(a, shape) for a, shape, output in arrays if not output]
        self._outputs = [(a, shape) for a, shape, output in arrays if output]
        self._workspace = workspace

    def workspace_size(self, n, size=4):
        """The bytes of the workspace for n states of numbers of `size` bytes."""
        return (n + 31) // 32 * 32 * self._workspace * size

    def __call__(self, *inputs, out=None, stream=0, workspace=None):
        if len(inputs) != len(self._inputs):
            names = ", ".join(name for name, _ in self._inputs)
            raise TypeError(f"{self.__name__} takes {len(self._inputs)} arrays: {names}")
        stream = getattr(stream, "cuda_stream", getattr(stream, "ptr", stream))  # PyTorch, CuPy
        on_host = self._library.on_host
        memory = [_Memory(name, a, False, stream, on_host) for (name, _), a in zip(self._inputs, inputs)]
        counts = [m.shape[0] for m, (_, shape) in zip(memory, self._inputs) if len(m.shape) == len(shape) + 1]
        if out is None:
            if not counts:
                raise ValueError(f"{self.__name__}: no argument has an axis of states, and there is no out=")
            out = tuple(_empty(inputs[0], (counts[0], *shape)) for _, shape in self._outputs)
        results = out if isinstance(out, (tuple, list)) else (out,)
        if len(results) != len(self._outputs):
            raise TypeError(f"out must have {len(self._outputs)} arrays")
        memory += [_Memory(name, a, True, stream, on_host) for (name, _), a in zip(self._outputs, results)]
        n = (counts or memory[-1].shape or (0,))[0]
        types = {m.type for m in memory}
        if len(types) != 1 or not types <= set(_LETTERS):
            raise TypeError(f"all arrays must be of float32 or all of float64, are {', '.join(sorted(types))}")
        layouts = [
            _layout(name, m, shape, k >= len(inputs), n)
            for k, (m, (name, shape)) in enumerate(zip(memory, self._inputs + self._outputs))
        ]
        arguments = [ctypes.c_void_p(stream), ctypes.c_ssize_t(n), *layouts]
        if self._workspace:
            size = self.workspace_size(n, memory[0].size)
            if workspace is None:
                workspace = _empty(inputs[0], (size // memory[0].size,))
            space = _Memory("workspace", workspace, True, stream, on_host)
            if not space.is_contiguous:
                raise ValueError("workspace is not contiguous")
            arguments.append(_Workspace(space.data, space.size * math.prod(space.shape)))
        status = self._library.symbol(self._symbol + _LETTERS[memory[0].type])(*arguments)
        if status:
            raise RuntimeError(f"{self.__name__}: {_MESSAGES[status] if status < len(_MESSAGES) else status}")
        return out if not isinstance(out, tuple) or len(out) != 1 else out[0]

