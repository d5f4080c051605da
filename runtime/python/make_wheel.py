"""make_wheel.py VERSION FOLDER: the package robcogen as a wheel, with the headers that generated code includes. Its bytes
follow from the sources alone."""
import base64
import hashlib
import sys
import zipfile
from pathlib import Path

version, folder = sys.argv[1], Path(sys.argv[2])
here = Path(__file__).resolve().parent
headers = here.parent / "include"
info = f"robcogen-{version}.dist-info"
files = {f"robcogen/{f.name}": f.read_bytes() for f in sorted((here / "robcogen").glob("*.py"))}
files |= {f"robcogen/include/{f.relative_to(headers).as_posix()}": f.read_bytes() for f in sorted(headers.rglob("*.h"))}
files[f"{info}/METADATA"] = (
    f"Metadata-Version: 2.1\nName: robcogen\nVersion: {version}\nSummary: Robots as Python modules, generated and compiled\n"
    "License: BSD-3-Clause\nRequires-Python: >=3.11\n").encode()
files[f"{info}/WHEEL"] = b"Wheel-Version: 1.0\nGenerator: robcogen\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
files[f"{info}/entry_points.txt"] = b"[console_scripts]\nrobcogen-python = robcogen.__main__:main\n"
record = ""
for name, data in files.items():
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    record += f"{name},sha256={digest},{len(data)}\n"
files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
folder.mkdir(parents=True, exist_ok=True)
wheel = folder / f"robcogen-{version}-py3-none-any.whl"
with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
    for name, data in files.items():
        archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), data, zipfile.ZIP_DEFLATED)
print(wheel)
