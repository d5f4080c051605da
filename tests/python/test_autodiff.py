"""The functions of modules for PyTorch and JAX, and their derivatives, compared with NumPy and with differences. Stand-ins call what
robcogen defines as the libraries would; with the argument `installed`, the libraries themselves do, if they are there."""
import importlib.util
import os
import subprocess
import sys
import unittest

import numpy as np

import arm
import ball_leg
import crane
import leg
import walker

INSTALLED = "installed" in sys.argv
PACKAGE = os.path.join(os.environ["ROBCOGEN_SOURCE_DIR"], "runtime", "python")
sys.path.insert(0, PACKAGE)
if not INSTALLED:
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "stand_in"))
    import tape

RANDOM = np.random.default_rng(7)


def tuple_of(results):
    return tuple(results) if isinstance(results, tuple) else (results,)


def numpy_of(array):
    return np.asarray(array.detach() if hasattr(array, "detach") else array)


class InTorch:
    def setUp(self):
        if importlib.util.find_spec("torch") is None:
            self.skipTest("there is no PyTorch")
        import torch
        self.library, self.name = torch, "torch"

    def array(self, a):
        return self.library.tensor(a)

    def vjp(self, function, arguments, weights):
        """The results, and the gradients by all arguments of the sum of the results times weights."""
        weights = list(map(self.array, weights))
        if not INSTALLED:
            arguments = list(map(self.array, arguments))
            results, ((operator, context), values, computed) = tape.record(function, arguments)
            weights = [w.reshape(r.shape) for w, r in zip(weights, computed)]
            return results, tape.gradients_of(arguments, values, operator.backward(context, *weights))
        arguments = [self.array(a).requires_grad_() for a in arguments]
        results = tuple_of(function(*arguments))
        return results, self.library.autograd.grad(results, arguments, weights)

    def jvp(self, function, arguments, rates):
        """The rates of the results when the arguments change at these rates."""
        arguments, rates = list(map(self.array, arguments)), list(map(self.array, rates))
        if not INSTALLED:
            _, ((operator, context), _, _) = tape.record(function, arguments)
            return operator.jvp(context, *rates)
        from torch.autograd import forward_ad
        with forward_ad.dual_level():
            results = tuple_of(function(*map(forward_ad.make_dual, arguments, rates)))
            return [forward_ad.unpack_dual(r).tangent for r in results]


class InJax:
    def setUp(self):
        if importlib.util.find_spec("jax") is None:
            self.skipTest("there is no JAX")
        import jax
        self.library, self.name = jax, "jax"
        if INSTALLED:
            jax.config.update("jax_enable_x64", True)

    def array(self, a):
        import jax.numpy as jnp
        return jnp.asarray(a)

    def vjp(self, function, arguments, weights):
        arguments, weights = list(map(self.array, arguments)), tuple(map(self.array, weights))
        if not INSTALLED:
            results, ((operator, residuals), values, _) = tape.record(function, arguments)
            if residuals is None:  # matrices of derivatives, which JAX transposes
                return results, self.transposed(operator, values, weights, arguments)
            return results, tape.gradients_of(arguments, values, operator.backward(residuals, weights))
        results, back = self.library.vjp(lambda *a: tuple_of(function(*a)), *arguments)
        return results, back(weights)

    def transposed(self, operator, values, weights, arguments):
        zero = self.library.custom_derivatives.SymbolicZero
        places = [next((k for k, v in enumerate(values) if np.may_share_memory(v, a)), None) for a in arguments]
        gradients = [np.zeros(a.shape) for a in arguments]
        for k, gradient in zip(places, gradients):
            for element in np.ndindex(gradient.shape):
                rates = [np.zeros(v.shape) if i in places else zero(v.shape, v.dtype) for i, v in enumerate(values)]
                rates[k].reshape(gradient.shape)[element] = 1
                change = operator.rule(values, rates)[1]
                gradient[element] = sum((np.asarray(c) * np.asarray(w)).sum() for c, w in zip(change, weights))
        return gradients

    def jvp(self, function, arguments, rates):
        arguments, rates = list(map(self.array, arguments)), list(map(self.array, rates))
        if not INSTALLED:
            _, ((operator, _), values, _) = tape.record(function, arguments)
            return operator.rule(values, rates)[1]
        return tuple_of(self.library.jvp(function, arguments, rates)[1])


def states(module, name, shape, lead=()):
    """Random values of an argument. Unit quaternions, and parameters near their defaults."""
    values = RANDOM.uniform(-1, 1, (*lead, *shape))
    if name == "parameters" and hasattr(module, "Parameters"):
        values = np.array([getattr(module.Parameters(), p) for p in module.parameter_names]) * (1 + 0.1 * values)
    return normalised(module, name, values)


def normalised(module, name, values):
    for k, element in enumerate(getattr(module, "position_names", ())) if name == "q" else ():
        if element not in module.joint_names and module is ball_leg:
            values[..., k:k + 4] /= np.linalg.norm(values[..., k:k + 4], axis=-1, keepdims=True)
    return values


def evaluate(module, function, arguments):
    """The function of the module, state by state."""
    def parameters(values):
        return module.Parameters(**dict(zip(module.parameter_names, values)))

    first = hasattr(module, "Parameters")
    return [np.asarray(r, float) for r in tuple_of(function(*(parameters(a) if first and k == 0 else a for k, a in enumerate(arguments))))]


class Derivatives:
    """What both libraries must do."""

    def find(self, module, function):
        found, in_numpy = getattr(module, self.name), module
        for part in function.split("."):
            found, in_numpy = getattr(found, part), getattr(in_numpy, part)
        return found, in_numpy

    def check(self, module, function, by, shapes, lead=(), shared=(), others=None):
        """Compares the results with NumPy, and the gradient by each of the arguments `by` with differences along a direction."""
        found, in_numpy = self.find(module, function)
        names, others = list(shapes), others or {}
        arguments = [states(module, name, shape, () if name in shared else lead) for name, shape in shapes.items()]
        places = list(np.ndindex(lead))

        def every(arguments):
            each = [evaluate(module, in_numpy, [a if n in shared else a[p] for n, a in zip(names, arguments)]) for p in places]
            return [np.reshape(r, (*lead, *r[0].shape)) for r in map(np.array, zip(*each))]

        expected = every(arguments)
        weights = [RANDOM.uniform(-1, 1, r.shape) for r in expected]

        def in_library(*differentiated):
            given = dict(zip(by, differentiated))
            return found(**{n: given.get(n, self.array(a)) for n, a in zip(names, arguments)}, **others)

        results, gradients = self.vjp(in_library, [arguments[names.index(n)] for n in by], weights)
        for r, e in zip(results, expected):
            self.assertEqual(tuple(r.shape), e.shape)
            np.testing.assert_allclose(numpy_of(r), e, rtol=1e-12, atol=1e-12 * (1 + np.abs(e).max()))
        step = 1e-6
        for name, gradient in zip(by, gradients):
            k = names.index(name)
            self.assertEqual(tuple(gradient.shape), arguments[k].shape)
            direction = RANDOM.uniform(-1, 1, arguments[k].shape)
            if name == "parameters":
                direction *= arguments[k]
            moved = [every([normalised(module, n, a + s * step * direction) if n == name else a for n, a in zip(names, arguments)])
                     for s in (1, -1)]
            change = sum(((a - b) * w).sum() for a, b, w in zip(*moved, weights)) / (2 * step)
            scale = 1 + np.abs(numpy_of(gradient) * direction).sum()
            self.assertAlmostEqual((numpy_of(gradient) * direction).sum() / scale, change / scale, delta=1e-7, msg=f"{function} by {name}")

    ARM = {"q": (7,), "qd": (7,), "qdd": (7,)}
    LEG = {"parameters": (len(leg.parameter_names),), "q": (3,), "qd": (3,), "qdd": (3,)}

    def test_gradients(self):
        for lead in (), (5,), (2, 3):
            self.check(leg, "inverse_dynamics", ["parameters", "q"], self.LEG, lead)

    def test_matrices_of_derivatives(self):
        self.check(arm, "inverse_dynamics", ["q", "qd", "qdd"], self.ARM, (9,))

    def test_quaternions_and_numbers(self):
        n = ball_leg.dof
        shapes = {"q": (len(ball_leg.position_names),), "qd": (n,)}
        for lead in (), (4,):
            self.check(ball_leg, "kinetic_energy", ["q", "qd"], shapes, lead)

    def test_several_results_of_a_floating_base(self):
        shapes = {"q": (3,), "qd": (3,), "tau": (3,), "base_velocity": (6,), "gravity": (3,)}
        for lead in (), (4,):
            self.check(walker, "forward_dynamics", ["q", "gravity"], shapes, lead)

    def test_matrices_without_a_robot(self):
        self.check(crane, "transforms.homogeneous.hook_X_post", ["variables"], {"parameters": (1,), "variables": (3,)}, (3,))
        self.check(crane, "transforms.homogeneous.post_X_hook", ["variables"], {"parameters": (1,), "variables": (3,)}, (3,))

    def test_arguments_that_all_states_share(self):
        self.check(leg, "inverse_dynamics", ["parameters", "q"], self.LEG, (5,), ["parameters", "qd"])

    def test_forward_mode(self):
        """By matrices of derivatives, and by tangents."""
        q, qd, qdd, v = RANDOM.uniform(-1, 1, (4, 3, 7))
        found, in_numpy = self.find(arm, "inverse_dynamics")
        step = 1e-6
        (rate,) = self.jvp(found, [q, qd, qdd], [v, 0 * v, v])
        change = in_numpy(q + step * v, qd, qdd + step * v) - in_numpy(q - step * v, qd, qdd - step * v)
        np.testing.assert_allclose(numpy_of(rate), change / (2 * step), atol=1e-6)
        q, v = (states(ball_leg, "q", (len(ball_leg.position_names),), (3,)) for _ in range(2))
        found, in_numpy = self.find(ball_leg, "potential_energy")
        (rate,) = self.jvp(found, [q], [v])
        moved = [normalised(ball_leg, "q", q + s * step * v) for s in (1, -1)]
        np.testing.assert_allclose(numpy_of(rate), (in_numpy(moved[0]) - in_numpy(moved[1])) / (2 * step), atol=1e-8)

    def test_single_precision(self):
        found, in_numpy = self.find(arm, "joint_space_inertia")
        q = RANDOM.uniform(-1, 1, (4, 7)).astype(np.float32)
        H = numpy_of(found(self.array(q)))
        self.assertEqual(H.dtype, np.float32)
        np.testing.assert_allclose(H, in_numpy(q.astype(float)), atol=1e-5)

    def test_defaults_and_other_arrays(self):
        found, in_numpy = self.find(arm, "inverse_dynamics")
        q, external = RANDOM.uniform(-1, 1, (2, 7)), RANDOM.uniform(-1, 1, (8, 6))
        tau = found(self.array(q), np.zeros(7), [0.0] * 7, external=external)
        np.testing.assert_allclose(numpy_of(tau), in_numpy(q, np.zeros(7), np.zeros(7), external=external), atol=1e-12)
        found, in_numpy = self.find(leg, "joint_space_inertia")
        H = found(leg.Parameters(), self.array(q[:, :3]))
        np.testing.assert_allclose(numpy_of(H), in_numpy(leg.Parameters(), q[:, :3]), atol=1e-12)

    def test_no_states(self):
        found, _ = self.find(arm, "joint_space_inertia")
        self.assertEqual(tuple(found(self.array(np.zeros((0, 7)))).shape), (0, 7, 7))

    def test_messages(self):
        found, _ = self.find(arm, "inverse_dynamics")
        q = self.array(np.zeros(7))
        for error, message, call in (
                (TypeError, "inverse_dynamics: qdd is missing", lambda: found(q, q)),
                (TypeError, "unknown argument 'tau'; the arguments are q, qd, qdd, gravity, external", lambda: found(q, q, q, tau=q)),
                (TypeError, "qd is given twice", lambda: found(q, q, q, qd=q)),
                (TypeError, "takes at most 5 arguments, got 6", lambda: found(q, q, q, q, q, q)),
                (ValueError, r"qdd must have the shape \(..., 7\), has \(3,\)", lambda: found(q, q, q[:3])),
                (ValueError, r"leading dimensions do not fit together: q: \(2,\), qd: \(3,\)",
                 lambda: found(self.array(np.zeros((2, 7))), self.array(np.zeros((3, 7))), q)),
                (TypeError, "q must be of .*float64 or .*float32, is of .*int", lambda: found(self.array(np.zeros(7, int)), q, q)),
                (AttributeError, f"arm.{self.name} has no function 'inverse_dynamic'; did you mean 'inverse_dynamics'?",
                 lambda: getattr(arm, self.name).inverse_dynamic)):
            with self.assertRaisesRegex(error, message):
                call()
        with self.assertRaisesRegex(TypeError, "module 'arm' has no .* by gravity; generate it with .*S inverse_dynamics:gravity in CMake"):
            self.vjp(lambda g: found(q, q, q, g), [np.zeros(3)], [np.ones(7)])
        with self.assertRaisesRegex((ValueError, RuntimeError), r"q\[0:4\] must be a unit quaternion w, x, y, z: its norm in state 1 is 2"):
            q = states(ball_leg, "q", (len(ball_leg.position_names),), (2,))
            q[1] *= 2
            numpy_of(self.find(ball_leg, "potential_energy")[0](self.array(q)))

    def test_it_is_loaded_on_demand(self):
        program = f"import sys, arm; assert not {{'jax', 'torch', 'robcogen'}} & set(sys.modules); arm.{self.name}"
        environment = {**os.environ, "PYTHONPATH": os.path.dirname(arm.__file__)}
        run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, env=environment, check=False)
        self.assertIn(f"ImportError: there is no module robcogen.{self.name}: it is part of the Python package of robcogen", run.stderr)


class ProductsTest(unittest.TestCase):
    """What neither library is needed for."""

    def setUp(self):
        from robcogen import _differentiable
        self.module = _differentiable

    def test_arguments_that_do_not_change(self):
        (f,) = (f for f in self.module.functions(arm) if f.name == "inverse_dynamics")
        q, qd, qdd, v = RANDOM.uniform(-1, 1, (4, 5, 7))
        (rate,) = self.module.tangents(f, [q, qd, qdd], {"qdd": v}, lambda g: g.compute, np.concatenate)
        np.testing.assert_allclose(rate, (arm.joint_space_inertia(q) @ v[..., None])[..., 0], atol=1e-11)

    def test_positions_that_follow(self):
        """They have no elements in the derivatives of the library."""
        q = self.module.Array("q", (5,), (), False, False)
        gradient, rate = RANDOM.uniform(-1, 1, (4, 3)), RANDOM.uniform(-1, 1, (4, 5))
        full = self.module._unreduced(q, gradient, np.zeros((4, 5)), np.concatenate)
        np.testing.assert_array_equal(full, np.concatenate([gradient, np.zeros((4, 2))], 1))
        np.testing.assert_array_equal(self.module._reduced(q, rate, np.zeros((4, 5)), 3, np.concatenate), rate[:, :3])

    def test_matrices_among_the_arguments(self):
        """By rows, as external wrenches, or by columns."""
        numbers, matrix = np.arange(6.0), np.arange(6.0).reshape(2, 3)
        for is_by_rows, expected in (True, matrix), (False, numbers.reshape(3, 2).T):
            a = self.module.Array("x", (2, 3), (), is_by_rows, False)
            np.testing.assert_array_equal(self.module._unreduced(a, numbers, matrix, np.concatenate), expected)
            np.testing.assert_array_equal(self.module._reduced(a, expected, matrix, 6, np.concatenate), numbers)


class TorchTest(InTorch, Derivatives, unittest.TestCase):
    def test_other_devices(self):
        q = self.array(np.zeros(7))
        if INSTALLED:
            q = q.to("meta")
        else:
            import types
            q.is_cpu, q.device = False, types.SimpleNamespace(type="cuda", __str__=lambda: "cuda:0")
        with self.assertRaisesRegex(TypeError, r"q is on .*, and these functions run on the CPU: pass q.cpu\(\)"):
            arm.torch.joint_space_inertia(q)

    def test_rule_for_vmap(self):
        """Of PyTorch 2: arguments have a dimension of the map in any place, or none."""
        q, qd, qdd = RANDOM.uniform(-1, 1, (4, 6, 7)), RANDOM.uniform(-1, 1, (6, 7)), RANDOM.uniform(-1, 1, (6, 4, 7))
        expected = arm.inverse_dynamics(*(np.reshape(np.broadcast_to(x, (4, 6, 7)), (24, 7)) for x in (q, qd, qdd.swapaxes(0, 1))))
        if not INSTALLED:
            _, ((operator, _), _, _) = tape.record(arm.torch.inverse_dynamics, list(map(self.array, (q[0], qd, qd))))
            (tau,), (place,) = operator.vmap(None, (0, None, 1), *map(self.array, (q, qd, qdd)))
            self.assertEqual(place, 0)
        elif not hasattr(self.library, "func"):
            self.skipTest("this PyTorch has no torch.func")
        else:
            tau = self.library.func.vmap(arm.torch.inverse_dynamics, in_dims=(0, None, 1))(*map(self.array, (q, qd, qdd)))
        np.testing.assert_allclose(numpy_of(tau).reshape(24, 7), expected, atol=1e-11)

    def test_no_copies(self):
        """The function computes on the memory of its arguments."""
        seen = []
        from robcogen import _differentiable
        from robcogen import torch as layer
        (function,) = (f for f in _differentiable.functions(arm) if f.name == "joint_space_inertia")
        compute = function.compute
        function.compute = lambda *a: seen.append(a) or compute(*a)
        q = self.array(np.zeros((4, 7)))
        H, = layer._compute(function, (q,))
        self.assertEqual(seen[0][0].ctypes.data, q.numpy().ctypes.data)


class JaxTest(InJax, Derivatives, unittest.TestCase):
    def test_arguments_that_are_the_same_in_some_dimensions(self):
        """As `vmap` passes them: with an axis of length 1."""
        q, qd, qdd = RANDOM.uniform(-1, 1, (4, 1, 7)), RANDOM.uniform(-1, 1, (1, 5, 7)), RANDOM.uniform(-1, 1, (4, 5, 7))
        tau = arm.jax.inverse_dynamics(*map(self.array, (q, qd, qdd)))
        wide = [np.broadcast_to(x, (4, 5, 7)).reshape(20, 7) for x in (q, qd, qdd)]
        np.testing.assert_allclose(np.asarray(tau).reshape(20, 7), arm.inverse_dynamics(*wide), atol=1e-11)

    @unittest.skipUnless(INSTALLED, "needs JAX")
    def test_transformations(self):
        import jax
        q, qd, qdd = RANDOM.uniform(-1, 1, (3, 5, 7))
        f = arm.jax.inverse_dynamics
        np.testing.assert_allclose(jax.jit(f)(q, qd, qdd), arm.inverse_dynamics(q, qd, qdd), atol=1e-11)
        many = jax.vmap(jax.grad(lambda *a: (f(*a) ** 2).sum()), in_axes=(0, None, 0))(q, qd[0], qdd)
        tau, d_q, *_ = arm.inverse_dynamics_derivatives(q, qd[0], qdd)
        np.testing.assert_allclose(many, 2 * np.einsum("si,sij->sj", tau, d_q), rtol=1e-9)


if __name__ == "__main__":
    unittest.main(argv=[a for a in sys.argv if a != "installed"])
