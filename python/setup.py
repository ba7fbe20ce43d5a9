"""A wheel py3-none-PLATFORM: the package, umbra.h, libumbra.so, and the folder of data, all of the clone around it.

UMBRA_BUILD names a build folder; without it the clone's `build` serves if the library is there, else one is made
(`build-wheel`), which takes minutes."""
import atexit
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:
    from wheel.bdist_wheel import bdist_wheel

ROOT = pathlib.Path(__file__).resolve().parents[1]
if not (ROOT / "library" / "umbra.h").is_file():
    raise SystemExit(f"{ROOT} is no clone of Umbra; accepted: pip install ./python in one")


def build_folder():
    """A folder of CMake in which the shared library is up to date."""
    stated = os.environ.get("UMBRA_BUILD")
    folder = pathlib.Path(stated) if stated else ROOT / "build"
    if not stated and not (folder / "libumbra.so").exists():
        folder = ROOT / "build-wheel"
    if not (folder / "CMakeCache.txt").exists():
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release"], check=True)
    if not stated:
        subprocess.run(["cmake", "--build", folder, "--target", "umbra_shared", "--parallel"], check=True)
    return folder


# What setuptools leaves on its way: not in the clone.
WORK = tempfile.mkdtemp(prefix="umbra-wheel-")
atexit.register(shutil.rmtree, WORK, ignore_errors=True)


class Build(build_py):
    def run(self):
        super().run()
        package = pathlib.Path(self.build_lib) / "umbra"
        with tempfile.TemporaryDirectory() as tree:
            subprocess.run(["cmake", "--install", build_folder(), "--component", "runtime", "--prefix", tree, "--strip"],
                           check=True)
            library = next(pathlib.Path(tree).rglob("libumbra.so"))
            shutil.copy(library.resolve(), package / "libumbra.so")  # a wheel has no links
            shutil.copytree(pathlib.Path(tree) / "share" / "umbra", package / "data", dirs_exist_ok=True)
        shutil.copy(ROOT / "library" / "umbra.h", package / "umbra.h")


class Wheel(bdist_wheel):
    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


class Platform(Distribution):
    def has_ext_modules(self):
        return True


setup(version=re.search(r"project\(umbra VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1),
      options={"build": {"build_base": WORK}, "egg_info": {"egg_base": WORK}},
      cmdclass={"build_py": Build, "bdist_wheel": Wheel}, distclass=Platform)
