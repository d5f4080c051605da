"""What robcogen.jax uses of JAX, over NumPy. Handlers are called as XLA calls them: the structures are those of its C header,
xla/ffi/api/c_api.h, version 0.1."""
import ctypes
import types
from ctypes import POINTER, c_char_p, c_int, c_int64, c_size_t, c_uint32, c_void_p

import numpy as np

import tape

__version__ = "0.5.0"


class Array(np.ndarray):
    pass


class ShapeDtypeStruct:
    def __init__(self, shape, dtype):
        self.shape, self.dtype = shape, np.dtype(dtype)


def _structure(name, *fields):
    return type(name, (ctypes.Structure,), {"_fields_": [("struct_size", c_size_t), ("extension_start", c_void_p), *fields]})


class Extension(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("type", c_int), ("next", c_void_p)]


class Scalar(ctypes.Structure):
    _fields_ = [("dtype", c_int), ("value", c_void_p)]


class ByteSpan(ctypes.Structure):
    _fields_ = [("ptr", c_char_p), ("len", c_size_t)]


Version = _structure("Version", ("major_version", c_int), ("minor_version", c_int))


class Metadata(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("api_version", Version), ("traits", c_uint32)]


class MetadataExtension(ctypes.Structure):
    _fields_ = [("extension_base", Extension), ("metadata", POINTER(Metadata))]


Buffer = _structure("Buffer", ("dtype", c_int), ("data", c_void_p), ("rank", c_int64), ("dims", POINTER(c_int64)))
Buffers = _structure("Buffers", ("size", c_int64), ("types", POINTER(c_int)), ("args", POINTER(c_void_p)))
Attributes = _structure(
    "Attributes", ("size", c_int64), ("types", POINTER(c_int)), ("names", POINTER(POINTER(ByteSpan))), ("attrs", POINTER(c_void_p)))
ErrorCreate = _structure("ErrorCreate", ("message", c_char_p), ("errc", c_int))
CreateError = ctypes.CFUNCTYPE(c_void_p, POINTER(ErrorCreate))
Api = _structure("Api", ("api_version", Version), ("internal_api", c_void_p), ("XLA_FFI_Error_Create", CreateError))
CallFrame = _structure(
    "CallFrame", ("api", POINTER(Api)), ("ctx", c_void_p), ("stage", c_int), ("args", Buffers), ("rets", Buffers),
    ("attrs", Attributes), ("future", c_void_p))
Handler = ctypes.CFUNCTYPE(c_void_p, POINTER(CallFrame))

_EXECUTE, _BUFFER, _SCALAR, _S64 = 3, 1, 3, 5
_TYPES = {np.dtype("f4"): 11, np.dtype("f8"): 12}
_errors: list[str] = []
_handlers: dict[str, Handler] = {}


@CreateError
def _create_error(arguments):
    _errors.append(arguments.contents.message.decode())
    return 1


_api = Api(ctypes.sizeof(Api), None, Version(ctypes.sizeof(Version), None, 0, 1), None, _create_error)


def _register(name, capsule, platform):
    pointer = ctypes.pythonapi.PyCapsule_GetPointer
    pointer.restype, pointer.argtypes = c_void_p, [ctypes.py_object, c_char_p]
    handler = Handler(pointer(capsule, None))
    metadata = Metadata(ctypes.sizeof(Metadata), Version(ctypes.sizeof(Version)))
    extension = MetadataExtension(Extension(ctypes.sizeof(MetadataExtension), 1), ctypes.pointer(metadata))
    frame = CallFrame(ctypes.sizeof(CallFrame), ctypes.addressof(extension))
    assert handler(frame) is None
    assert (metadata.api_version.major_version, metadata.api_version.minor_version) == (0, 1)
    assert platform == "cpu" and name not in _handlers
    _handlers[name] = handler


def _buffers(arrays, keep):
    items = (c_void_p * len(arrays))()
    for k, array in enumerate(arrays):
        dims = (c_int64 * max(1, array.ndim))(*array.shape)
        buffer = Buffer(ctypes.sizeof(Buffer), None, _TYPES[array.dtype], array.ctypes.data, array.ndim, dims)
        items[k] = ctypes.addressof(buffer)
        keep += [dims, buffer]
    types_ = (c_int * max(1, len(arrays)))(*[_BUFFER] * len(arrays))
    keep += [items, types_]
    return Buffers(ctypes.sizeof(Buffers), None, len(arrays), types_, items)


def _ffi_call(target, results, vmap_method):
    assert vmap_method == "expand_dims"

    def call(*values, **attributes):
        keep = []
        arguments = [np.ascontiguousarray(v) if v.ndim else np.asarray(v) for v in values]
        outputs = [np.full(r.shape, np.nan, r.dtype) for r in results]
        (name, number), = attributes.items()
        value, span = c_int64(number), ByteSpan(name.encode(), len(name))
        scalar = Scalar(_S64, ctypes.addressof(value))
        items, names, types_ = (c_void_p * 1)(ctypes.addressof(scalar)), (POINTER(ByteSpan) * 1)(ctypes.pointer(span)), (c_int * 1)(_SCALAR)
        attrs = Attributes(ctypes.sizeof(Attributes), None, 1, types_, names, items)
        frame = CallFrame(
            ctypes.sizeof(CallFrame), None, ctypes.pointer(_api), None, _EXECUTE, _buffers(arguments, keep), _buffers(outputs, keep), attrs)
        if _handlers[target](frame) is not None:
            raise RuntimeError(_errors.pop())
        return [o.view(Array) for o in outputs]
    return call


ffi = types.SimpleNamespace(register_ffi_target=_register, ffi_call=_ffi_call)


class SymbolicZero:
    def __init__(self, shape, dtype):
        self.shape, self.dtype = shape, dtype


custom_derivatives = types.SimpleNamespace(SymbolicZero=SymbolicZero)


class custom_vjp:
    def __init__(self, function):
        self.function = function

    def defvjp(self, forward, backward, symbolic_zeros):
        assert symbolic_zeros
        self.forward, self.backward = forward, backward

    def __call__(self, *values):
        perturbed = list(map(tape.is_differentiated, values))
        if not any(perturbed):
            return self.function(*values)
        saved, tape.differentiated[:] = list(tape.differentiated), []  # the rule itself is not differentiated again
        results, residuals = self.forward(*(types.SimpleNamespace(value=v, perturbed=p) for v, p in zip(values, perturbed)))
        tape.differentiated[:] = saved
        tape.calls.append(((self, residuals), values, results))
        return results


class custom_jvp:
    def __init__(self, function):
        self.function = function

    def defjvp(self, rule, symbolic_zeros):
        assert symbolic_zeros
        self.rule = rule

    def __call__(self, *values):
        results = self.function(*values)
        if any(map(tape.is_differentiated, values)):
            tape.calls.append(((self, None), values, results))
        return results
