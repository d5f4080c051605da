// The Python package calls functions over many states with arrays that say where their numbers are: stand-ins in the
// memory of the host, and those of NumPy where it is installed, over a library that is compiled for the host.
#include <gtest/gtest.h>

#include "states.h"
#include "support/number.h"

namespace robcogen::test {
namespace {

// Arrays as CuPy has them, but in the memory of the host.
const char* const kStandIn = R"py(
import ctypes, itertools, pathlib
import hyl_gpu
import robcogen.gpu

hyl_gpu.load(pathlib.Path("all.so").resolve(), on_host=True)


class Array:
    def __init__(self, shape, dtype="<f4", strides=None, memory=None):
        self.shape, self.dtype = tuple(shape), dtype
        self.number = ctypes.c_float if dtype == "<f4" else ctypes.c_double
        self.size = ctypes.sizeof(self.number)
        if strides is None:
            strides = [1] * len(shape)
            for k in reversed(range(len(shape) - 1)):
                strides[k] = strides[k + 1] * shape[k + 1]
        self.strides = tuple(strides)
        self.memory = memory or (self.number * (1 + sum(s * (n - 1) for s, n in zip(self.strides, self.shape))))()

    @property
    def __cuda_array_interface__(self):
        return {"shape": self.shape, "typestr": self.dtype, "version": 3, "data": (ctypes.addressof(self.memory), False),
                "strides": tuple(self.size * s for s in self.strides)}

    def place(self, index):
        return sum(s * i for s, i in zip(self.strides, index))

    def __getitem__(self, index):
        return self.memory[self.place(index)]

    def __setitem__(self, index, value):
        self.memory[self.place(index)] = value

    def swapaxes(self, a, b):
        shape, strides = list(self.shape), list(self.strides)
        shape[a], shape[b], strides[a], strides[b] = shape[b], shape[a], strides[b], strides[a]
        return Array(shape, self.dtype, strides, self.memory)


def empty(shape, dtype):
    return Array(shape, dtype)


def positions(dtype, strides=None):
    q = Array((N, 3), dtype, strides)
    for i, k in itertools.product(range(N), range(3)):
        q[i, k] = Q[i][k]
    return q


def check(H, tolerance):
    assert H.shape == (N, 3, 3), H.shape
    for i, row, column in itertools.product(range(N), range(3), range(3)):
        assert abs(H[i, row, column] - EXPECTED[i][3 * column + row]) < tolerance, (i, row, column)


def refused(error, words, call):
    try:
        call()
    except error as e:
        assert words in str(e), e
    else:
        assert False, words


inertia = hyl_gpu.joint_space_inertia
for dtype, tolerance in (("<f4", 1e-5), ("<f8", 1e-12)):
    check(inertia(positions(dtype)), tolerance)                     # state by state
    check(inertia(positions(dtype, (1, N + 2))), tolerance)         # element by element
    results = Array((N, 3, 3), dtype, (1, N, 3 * N))
    assert inertia(positions(dtype, (5, 1)), out=results) is results  # with gaps
    check(results, tolerance)

single = Array((3,))
for k in range(3):
    single[k,] = Q[0][k]
for q in (single, Array((N, 3), "<f4", (0, 1), single.memory)):     # the same for all
    H = inertia(q, out=Array((N, 3, 3), "<f4", (9, 1, 3)))
    assert all(H[i, 1, 1] == H[0, 1, 1] for i in range(N))

q = positions("<f4")
refused(ValueError, "must have the shape (5, 3)", lambda: inertia(Array((5, 4))))
refused(ValueError, "column by column", lambda: inertia(q, out=Array((N, 3, 3))))
refused(ValueError, "nor elements are contiguous", lambda: inertia(Array((N, 3), "<f4", (6, 2))))
refused(TypeError, "all of float64", lambda: inertia(q, out=Array((N, 3, 3), "<f8", (9, 1, 3))))
refused(TypeError, "takes 1 arrays: q", lambda: inertia(q, q))
refused(TypeError, "neither __cuda_array_interface__", lambda: inertia([1, 2, 3]))

# In stages, with a workspace that is made or given.
forward = hyl_gpu.forward_dynamics
q = positions("<f8")
assert forward.workspace_size(N, 8) > 0
for workspace in (None, Array((forward.workspace_size(N, 8),), "<f4")):
    qdd = forward(q, q, q, workspace=workspace, stream=0)
    for i, k in itertools.product(range(N), range(3)):
        assert abs(qdd[i, k] - ACCELERATIONS[i][k]) < 1e-9 * max(map(abs, ACCELERATIONS[i])), (i, k)
refused(RuntimeError, "workspace is too small", lambda: forward(q, q, q, workspace=Array((1,), "<f8")))
size = forward.workspace_size(N, 8)
refused(ValueError, "not contiguous", lambda: forward(q, q, q, workspace=Array((size,), "<f4", (2,))))
refused(ValueError, "must have the shape", lambda: inertia(single, out=Array(())))
assert MESSAGES == robcogen.gpu._MESSAGES

try:
    import numpy
except ImportError:
    numpy = None
if numpy:  # by DLPack
    q = numpy.array(Q)
    check(inertia(q), 1e-12)
    check(inertia(q.astype("float32")), 1e-5)
    check(inertia(numpy.asfortranarray(q)), 1e-12)
    hyl_gpu.load(pathlib.Path("all.so").resolve())
    refused(TypeError, "q is in the memory of the processor", lambda: inertia(q))
)py";

TEST(GpuPython, TakesArraysOfOthers) {
  if (std::string(PYTHON).empty()) GTEST_SKIP() << "Python was not found";
  const std::vector<std::string> groups = {"forward_dynamics", "joint_space_inertia"};
  const backend::Library leg =
      library_of(kRobots / "hyl" / "hyl.kindsl", "hyl", std::nullopt, {}, groups, kGpuFeatures);
  const Scratch scratch("gpu-python");
  write_gpu(scratch.path, leg, {60, 40});
  write_text(
      scratch.path / "all.cpp",
      "#include \"hyl_gpu/forward_dynamics.cu\"\n#include \"hyl_gpu/joint_space_inertia.cu\"\n");
  ASSERT_EQ(run(scratch.path, "g++ -std=c++17 -I. -I" ROBCOGEN_RUNTIME_DIR " -O0 -shared -fPIC all.cpp -o all.so"), "");
  std::mt19937_64 engine(7);
  const auto program = [&](const std::string& name) -> const symbolic::Program& {
    return std::find_if(leg.functions.begin(), leg.functions.end(), [&](const auto& f) { return f.kernel == name; })
        ->program;
  };
  const States<double> states = random_states<double>(leg, program("joint_space_inertia"), 5, engine);
  std::vector<std::vector<double>> accelerations;
  for (const std::vector<double>& q : states.arrays[0])
    accelerations.push_back(
        symbolic::interpret<double>(program("forward_dynamics"), {{"q", q}, {"qd", q}, {"tau", q}}).at("qdd"));
  const auto literal = [](const std::vector<std::vector<double>>& values) {
    std::string text = "[";
    for (const std::vector<double>& state : values) {
      text += "[";
      for (const double x : state) text += print_double(x) + ", ";
      text += "], ";
    }
    return text + "]\n";
  };
  std::string messages = "MESSAGES = (";
  for (int status = robcogen_gpu_success; status <= robcogen_gpu_wrong_layout; ++status)
    messages += std::string("\"") + robcogen_gpu_message(static_cast<robcogen_gpu_status>(status)) + "\", ";
  write_text(
      scratch.path / "test.py", messages + ")\nN = 5\nQ = " + literal(states.arrays[0]) + "EXPECTED = " +
                                    literal(states.arrays[1]) + "ACCELERATIONS = " + literal(accelerations) + kStandIn);
  EXPECT_EQ(
      run(scratch.path, "PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=" ROBCOGEN_RUNTIME_DIR "/../python " PYTHON " test.py"),
      "");
}

}  // namespace
}  // namespace robcogen::test
