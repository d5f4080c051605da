"""platform_tag.py PROGRAM: the platforms of a wheel with this program, by what the program links."""
import platform
import re
import subprocess
import sys
import sysconfig

# The libraries that every Linux with glibc has (PEP 600). Those of C++ are among them only in versions that each tag lists;
# the generator links them statically.
_OF_GLIBC = re.compile(r"(libc|libm|libpthread|libdl|librt)\.so\.\d+|ld-linux.*\.so\.\d+")
# A program without shared libraries needs the kernel only: that of glibc 2.17 and of musl 1.1 is new enough.
_STATIC = "manylinux_2_17_{machine}.musllinux_1_1_{machine}"


def tag_of(headers, machine):
    """The tag for what `objdump -p` prints about a program for Linux, and the libraries, if any, that tie it to this machine."""
    libraries = re.findall(r"^ +NEEDED +(\S+)", headers, re.MULTILINE)
    if not libraries and not re.search(r"^ +INTERP ", headers, re.MULTILINE):
        return _STATIC.format(machine=machine), []
    others = [name for name in libraries if not _OF_GLIBC.fullmatch(name)]
    versions = [tuple(map(int, v)) for v in re.findall(r" GLIBC_(\d+)\.(\d+)", headers)]
    # Names such as GLIBC_PRIVATE or GLIBC_ABI_DT_RELR are not versions: programs with them run where they were linked.
    if others or not versions or re.search(r" GLIBC_(?!\d)", headers):
        return f"linux_{machine}", others or libraries
    return "manylinux_{}_{}_{}".format(*max(versions), machine), []


def platform_tag(program):
    if not sys.platform.startswith("linux"):
        return re.sub(r"[-.]", "_", sysconfig.get_platform()), []
    headers = subprocess.run(["objdump", "-p", str(program)], capture_output=True, text=True, check=True).stdout
    return tag_of(headers, platform.machine())


if __name__ == "__main__":
    print(platform_tag(sys.argv[1])[0])
