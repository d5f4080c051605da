"""The package robcogen: models without a build system, the cache, the command line, the wheel."""
import contextlib
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import numpy as np

SOURCES = Path(os.environ["ROBCOGEN_SOURCE_DIR"])
PACKAGE = SOURCES / "runtime" / "python"
sys.path.insert(0, str(PACKAGE))
import robcogen  # noqa: E402


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        os.environ["ROBCOGEN_CACHE"] = str(cls.folder / "cache")
        cls.model = cls.folder / "leg one.kindsl"
        shutil.copy(SOURCES / "robots" / "hyl" / "hyl.kindsl", cls.model)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def build(self):
        return robcogen.build(self.model, name="leg", algorithms="inverse_dynamics")

    def test_models_are_compiled_once(self):
        first = self.build()
        self.assertTrue((first.parent / "leg.pyi").is_file())
        made = first.stat().st_mtime_ns
        self.assertEqual(self.build(), first)
        # After a changed comment, code is generated but not compiled.
        text = self.model.read_text()
        self.model.write_text("// a leg\n" + text)
        self.assertEqual(self.build(), first)
        self.assertEqual(first.stat().st_mtime_ns, made)
        leg = robcogen.load(self.model, name="leg", algorithms="inverse_dynamics")
        # The slider carries the whole mass.
        rest = np.zeros(3)
        np.testing.assert_allclose(leg.inverse_dynamics(rest, rest, rest)[0], 7.501 * 9.81)
        # A different mass makes a different robot; both can be used.
        mass = re.search(r"mass\s*=\s*([\d.]+)", text)
        self.model.write_text(text[: mass.start(1)] + str(float(mass[1]) + 1) + text[mass.end(1) :])
        heavier = robcogen.load(self.model, name="leg", algorithms="inverse_dynamics")
        np.testing.assert_allclose(heavier.inverse_dynamics(rest, rest, rest)[0], 8.501 * 9.81)
        np.testing.assert_allclose(leg.inverse_dynamics(rest, rest, rest)[0], 7.501 * 9.81)
        # The first module is still in the cache.
        self.model.write_text(text)
        self.assertEqual(self.build(), first)
        self.assertEqual(first.stat().st_mtime_ns, made)

    def test_flags_are_those_of_the_cmake_functions(self):
        def flags(file, expression):
            return re.search(expression, (SOURCES / "cmake" / file).read_text(), re.MULTILINE)[1].split()

        self.assertEqual(robcogen._build._OF_GCC, flags("Robcogen.cmake", r"^ *set\(of_gcc (.*)\)$"))
        self.assertEqual(robcogen._build._ORDER_OF_GCC, flags("RobcogenProcessors.cmake", r" COMPILE_OPTIONS (-fschedule-insns .*)\)$"))

    def test_errors(self):
        wrong = self.folder / "wrong.kindsl"
        wrong.write_text("Robot wrong {\n  RobotBase base { children { a via } }\n}\n")
        with self.assertRaisesRegex(robcogen.Error, r"wrong\.kindsl:2:\d+: error: "):
            robcogen.load(wrong)
        with self.assertRaisesRegex(robcogen.Error, "no such file"):
            robcogen.load("nothing.urdf")
        tool = os.environ.pop("ROBCOGEN_TOOL")
        path, os.environ["PATH"] = os.environ["PATH"], ""
        try:
            with self.assertRaisesRegex(robcogen.Error, "cannot find the program robcogen: install it, or name it in ROBCOGEN_TOOL"):
                robcogen.load(SOURCES / "robots" / "hyl" / "hyl.kindsl")
        finally:
            os.environ["ROBCOGEN_TOOL"], os.environ["PATH"] = tool, path
        with self.assertRaisesRegex(robcogen.Error, "7dof.kindsl: '7dof' cannot name the module, as it is not a valid identifier"):
            robcogen.load(shutil.copy(self.model, self.folder / "7dof.kindsl"))
        with self.assertRaisesRegex(robcogen.Error, "the generator writes no code with the options --list-outputs"):
            robcogen.load(self.model, options=["--list-outputs"])
        leftovers = [f for f in (self.folder / "cache").iterdir() if f.name.startswith("tmp")]
        self.assertEqual(leftovers, [])

    def test_variables_that_name_no_program(self):
        old = {variable: os.environ.get(variable) for variable in ("ROBCOGEN_TOOL", "CXX")}
        try:
            for variable, value, what in (
                ("CXX", "no-such-c++ -m64", "a C[+][+] compiler"),
                ("CXX", "'c++", "a C[+][+] compiler"),
                ("ROBCOGEN_TOOL", "no-such-tool", "the program robcogen"),
            ):
                os.environ[variable] = value
                with self.assertRaisesRegex(robcogen.Error, f"{variable} is '{re.escape(value)}', which is not a program: it must name {what}"):
                    robcogen.build(self.model, name="not_compiled", algorithms="energy")
        finally:
            for variable, value in old.items():
                os.environ.pop(variable) if value is None else os.environ.update({variable: value})

    def test_the_compiler_may_have_arguments(self):
        old = os.environ.get("CXX")
        os.environ["CXX"] = "env LC_ALL=C c++"
        try:
            self.assertTrue(robcogen.build(self.model, name="wrapped", algorithms="energy").is_file())
        finally:
            os.environ.pop("CXX") if old is None else os.environ.update(CXX=old)

    def test_warnings_are_printed(self):
        suspicious = self.folder / "suspicious.kindsl"
        text = self.model.read_text()
        # An angle that looks like degrees.
        place = re.search(r"rotation\s*=\s*\(([^,]*),", text)
        suspicious.write_text(text[: place.start(1)] + "90.0" + text[place.end(1) :])
        # The second time, the module comes from the cache. Each process prints its warnings once.
        for is_printed in (True, False, True):
            printed = io.StringIO()
            with contextlib.redirect_stderr(printed):
                robcogen.build(suspicious, algorithms="energy", quiet=True)
            (self.assertRegex if is_printed else self.assertNotRegex)(printed.getvalue(), r"suspicious\.kindsl:\d+:\d+: warning: ")
            if not is_printed:
                robcogen._messages._printed.clear()
        # One string is one option: with it, the warning is an error.
        with self.assertRaisesRegex(robcogen.Error, r"suspicious\.kindsl:\d+:\d+: error: "):
            robcogen.build(suspicious, algorithms="energy", options="--strict")

    def test_the_tool_of_the_same_installation(self):
        prefix = self.folder / "prefix"
        shutil.copytree(PACKAGE / "robcogen", prefix / "share" / "robcogen" / "python" / "robcogen")
        (prefix / "bin").mkdir()
        tool = prefix / "bin" / "robcogen"
        tool.write_text("#!/bin/sh\necho the tool of this prefix >&2\nexit 1\n")
        tool.chmod(0o755)
        environment = {k: v for k, v in os.environ.items() if k != "ROBCOGEN_TOOL"}
        environment["PYTHONPATH"] = str(prefix / "share" / "robcogen" / "python")
        run = subprocess.run(
            [sys.executable, "-m", "robcogen", str(self.model)], capture_output=True, text=True, check=False, env=environment)
        self.assertEqual((run.stderr, run.returncode), ("the tool of this prefix\n", 1))
        # What pip does with this folder: a wheel that remembers the generator, or a path to the folder.
        for name in ("_robcogen", "make_wheel.py", "pyproject.toml"):
            (shutil.copytree if name[0] == "_" else shutil.copy)(PACKAGE / name, prefix / "share" / "robcogen" / "python" / name)
        shutil.copytree(PACKAGE.parent / "include", prefix / "include")
        (prefix / "out").mkdir()
        program = "import make_wheel; print(make_wheel.build_wheel('out')); print(make_wheel.build_editable('out/editable'))"
        run = subprocess.run([sys.executable, "-c", program], cwd=prefix, capture_output=True, text=True, check=True, env=environment)
        for folder, wheel in zip(("out", "out/editable"), run.stdout.split()):
            with zipfile.ZipFile(prefix / folder / wheel) as archive:
                files = {name: archive.read(name).decode() for name in archive.namelist()}
            if folder == "out":
                self.assertIn(repr(str(tool)), files["robcogen/_installation.py"])
                for name in ("robcogen/py.typed", "_robcogen/__init__.py", "robcogen/include/robcogen/python/make_module.h"):
                    self.assertIn(name, files)
            else:
                self.assertEqual(files["robcogen.pth"], str(prefix / "share" / "robcogen" / "python") + "\n")

    @unittest.skipUnless(os.environ["ROBCOGEN_TEST_EVERYTHING"] == "1", "only where everything is tested")
    def test_the_wheel_and_the_command(self):
        out = self.folder / "wheel"
        names = []
        for _ in range(2):
            run = subprocess.run(
                [sys.executable, str(PACKAGE / "make_wheel.py"), str(out)], capture_output=True, text=True, check=True)
            names.append((run.stdout, Path(run.stdout.strip()).read_bytes()))
        self.assertEqual(names[0], names[1])
        version = re.search(r"^project\(robcogen VERSION (\S+)", (SOURCES / "CMakeLists.txt").read_text(), re.MULTILINE)[1]
        self.assertEqual(robcogen.__version__, version)
        self.assertEqual(Path(names[0][0].strip()).name, f"robcogen-{version}-py3-none-any.whl")
        with zipfile.ZipFile(names[0][0].strip()) as wheel:
            self.assertIsNone(wheel.testzip())
            wheel.extractall(out)
        run = subprocess.run(
            [sys.executable, "-m", "robcogen", str(SOURCES / "robots" / "hyl" / "hyl.kindsl"), "--algorithms", "inverse_dynamics",
             "-o", str(out)], cwd=out, capture_output=True, text=True, check=False, env=os.environ | {"PYTHONPATH": str(out)})
        self.assertEqual(run.stdout, f"{out}/hyl.abi3.so\n", run.stderr)
        for name, what in (("copy", "a module of Python's standard library, which yours would hide"), ("class", "a keyword of Python")):
            refused = subprocess.run(
                [sys.executable, "-m", "robcogen", "hyl.kindsl", "--name", name], cwd=out, capture_output=True, text=True, check=False)
            self.assertEqual((refused.stderr, refused.returncode), (f"'{name}' is {what}: name the module with --name\n", 1))
        refused = subprocess.run(
            [sys.executable, "-m", "robcogen", "--cmake-dir"], cwd=out, capture_output=True, text=True, check=False)
        self.assertEqual(
            (refused.stderr, refused.returncode),
            ("this package has no CMake package: only wheels with the generator, and installations, have one\n", 1))
        run = subprocess.run(
            [sys.executable, "-c", "import hyl; print(hyl.joint_names)"], cwd=out, capture_output=True, text=True, check=False)
        self.assertEqual(run.stdout, "('SLIDE', 'HFE', 'KFE')\n", run.stderr)


if __name__ == "__main__":
    unittest.main()
