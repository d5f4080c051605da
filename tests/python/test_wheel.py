"""The wheel of a platform, without pip: its files, its tag, its program, and a robot that is loaded from it. WHEEL is one that
the target robcogen_wheel would make of this build."""
import base64
import csv
import hashlib
import os
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

SOURCES = Path(os.environ["ROBCOGEN_SOURCE_DIR"])
WHEEL = Path(os.environ["ROBCOGEN_WHEEL_FOLDER"])
sys.path.insert(0, str(SOURCES / "runtime" / "python"))
import platform_tag  # noqa: E402
from robcogen import __version__ as VERSION  # noqa: E402

STATIC = "Program Header:\n    LOAD off    0x0\n\nDynamic Section:\n"
SHARED = "Program Header:\n  INTERP off    0x318\n\nDynamic Section:\n  NEEDED               libc.so.6\n  NEEDED               libm.so.6\n"
VERSIONS = "  required from libc.so.6:\n    0x0 0x00 08 GLIBC_2.4\n    0x0 0x00 03 GLIBC_2.34\n    0x0 0x00 03 GLIBC_2.2.5\n"


class Tag(unittest.TestCase):
    def test_tag_says_what_the_program_needs(self):
        for headers, tag, libraries in (
            (STATIC, "manylinux_2_17_x86_64.musllinux_1_1_x86_64", []),
            (SHARED + VERSIONS, "manylinux_2_34_x86_64", []),
            (SHARED + VERSIONS + "    0x0 0x00 02 GLIBC_ABI_DT_RELR\n", "linux_x86_64", ["libc.so.6", "libm.so.6"]),
            (SHARED + "  NEEDED               libfmt.so.9\n" + VERSIONS, "linux_x86_64", ["libfmt.so.9"]),
            (SHARED + "  NEEDED               libstdc++.so.6\n" + VERSIONS, "linux_x86_64", ["libstdc++.so.6"]),
        ):
            with self.subTest(tag=tag):
                self.assertEqual(platform_tag.tag_of(headers, "x86_64"), (tag, libraries))


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        (cls.path,) = WHEEL.glob("*.whl")
        cls.wheel = zipfile.ZipFile(cls.path)
        cls.names = cls.wheel.namelist()

    def info(self, name):
        return self.wheel.read(f"robcogen-{VERSION}.dist-info/{name}").decode()

    def test_every_file_is_recorded(self):
        recorded = {name: digest for name, digest, _ in csv.reader(self.info("RECORD").splitlines())}
        self.assertEqual(sorted(recorded), sorted(self.names))
        for name, digest in recorded.items():
            if digest:
                data = hashlib.sha256(self.wheel.read(name)).digest()
                self.assertEqual(digest, "sha256=" + base64.urlsafe_b64encode(data).rstrip(b"=").decode(), name)

    def test_the_name_has_the_tags(self):
        tag, _ = platform_tag.platform_tag(os.environ["ROBCOGEN_TOOL"])
        self.assertEqual(self.path.name, f"robcogen-{VERSION}-py3-none-{tag}.whl")
        lines = self.info("WHEEL").splitlines()
        self.assertEqual([f"Tag: py3-none-{t}" for t in tag.split(".")], [line for line in lines if line.startswith("Tag")])
        self.assertIn("Root-Is-Purelib: false", lines)

    def test_only_programs_are_executable(self):
        programs = [entry.filename for entry in self.wheel.infolist() if entry.external_attr >> 16 & 0o111]
        self.assertEqual(sorted(programs), [f"robcogen-{VERSION}.data/scripts/robcogen", "robcogen/bin/robcogen"])

    def test_files(self):
        for name in ("robcogen/__init__.py", "robcogen/py.typed", "_robcogen/__init__.py", "robcogen/include/robcogen/version.h",
                     "robcogen/include/robcogen/python/make_module.h", "robcogen/lib/cmake/robcogen/robcogenConfig.cmake",
                     "robcogen/share/robcogen/selfcheck/robot_selfcheck.cpp", "robcogen/share/robcogen/robots/hyl/hyl.kindsl",
                     "robcogen/share/robcogen/eigen3/Eigen/Core", f"robcogen-{VERSION}.dist-info/licenses/LICENSE",
                     f"robcogen-{VERSION}.dist-info/licenses/eigen.txt", f"robcogen-{VERSION}.dist-info/licenses/urdfdom.txt"):
            self.assertIn(name, self.names)
        # Nothing outside the package, and no path of the machine that made it.
        roots = {name.split("/")[0] for name in self.names}
        self.assertEqual(roots, {"robcogen", "_robcogen", f"robcogen-{VERSION}.dist-info", f"robcogen-{VERSION}.data"})
        for name in self.names:
            if name.endswith((".py", ".cmake", ".txt")):
                self.assertNotIn(str(SOURCES).encode(), self.wheel.read(name), name)

    def test_robots_are_loaded(self):
        with tempfile.TemporaryDirectory() as folder:
            self.wheel.extractall(folder)
            generator = Path(folder, "robcogen", "bin", "robcogen")
            generator.chmod(0o755)
            # The generator of the wheel is used, though the PATH has only what compilers need.
            environment = {k: v for k, v in os.environ.items() if not k.startswith("ROBCOGEN_")}
            environment |= {"PYTHONPATH": folder, "ROBCOGEN_CACHE": folder + "/cache", "PATH": "/usr/bin:/bin"}

            def python(*arguments, status=0):
                run = subprocess.run([sys.executable, *arguments], cwd=folder, capture_output=True, text=True, check=False, env=environment)
                self.assertEqual(run.returncode, status, run.stderr)
                return run.stdout

            command = Path(folder, f"robcogen-{VERSION}.data", "scripts", "robcogen")
            self.assertEqual(python(command, "--version"), f"robcogen {VERSION}\n")
            python(command, "check", "nothing.urdf", status=2)
            self.assertEqual(python("-m", "robcogen", "--cmake-dir"), f"{folder}/robcogen/lib/cmake/robcogen\n")
            program = (
                "import robcogen; leg = robcogen.load('robcogen/share/robcogen/robots/hyl/hyl.kindsl', algorithms='inverse_dynamics', quiet=True)\n"
                "print(round(leg.inverse_dynamics([0] * 3, [0] * 3, [0] * 3)[0], 9))")
            # The slider carries the whole mass.
            self.assertEqual(float(python("-c", program)), round(7.501 * 9.81, 9))


if __name__ == "__main__":
    unittest.main()
