"""A copy of the clone with a build and tests of its own, for tools that change sources and look what
the tests say: tools/mutate, tools/pull-any-brick."""
import json
import os
import re
import shutil
import subprocess

TOO_LONG = 900  # [s] a build or a test program that an error made endless


def copy_tree(source, target):
    """Brings the copy up to date without touching what is the same, so that little is built anew."""
    files = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=source, text=True,
                           capture_output=True, check=True).stdout.split("\n")
    wanted = {name for name in files if name and os.path.isfile(os.path.join(source, name))}
    for name in sorted(wanted):
        here, there = os.path.join(source, name), os.path.join(target, name)
        os.makedirs(os.path.dirname(there), exist_ok=True)
        if not os.path.exists(there) or open(here, "rb").read() != open(there, "rb").read():
            shutil.copy(here, there)
    for folder, _, names in os.walk(target):
        for name in names:
            path = os.path.join(folder, name)
            if os.path.relpath(path, target) not in wanted:
                os.remove(path)


class Bench:
    """The copy, its build and its tests."""

    def __init__(self, folder, jobs):
        self.source = os.path.join(os.path.abspath(folder), "source")
        self.build = os.path.join(os.path.abspath(folder), "build")
        self.log = self.build + ".log"
        self.jobs = str(jobs)
        self.programs = set()  # of tests: targets; CTest tells a command only once it is built
        self.environment = dict(os.environ, CCACHE_BASEDIR=self.source, CCACHE_NOHASHDIR="1")
        os.makedirs(self.build, exist_ok=True)

    def run(self, command, limit=TOO_LONG):
        """True where it ends well; what it says is in the log."""
        with open(self.log, "w") as out:
            process = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT,
                                       env=self.environment, start_new_session=True)
            try:
                return process.wait(limit) == 0
            except subprocess.TimeoutExpired:
                return False
            finally:
                if process.poll() is None:
                    os.killpg(process.pid, 9)
                    process.wait()

    def configure(self, *options):
        command = ["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja",
                   "-DCMAKE_BUILD_TYPE=Release", *options]
        if shutil.which("ccache"):
            command += ["-DCMAKE_%s_COMPILER_LAUNCHER=ccache" % c for c in ("C", "CXX")]
        if not self.run(command):
            return False
        known = subprocess.run(["cmake", "--build", self.build, "--target", "help"], text=True,
                               capture_output=True, check=True).stdout
        self.programs = set(re.findall(r"^(test_\w+):", known, re.M))
        return True

    def tests(self, pattern):
        """What CTest knows of the tests of that name."""
        text = subprocess.run(["ctest", "--test-dir", self.build, "-R", pattern,
                               "--show-only=json-v1"], text=True, capture_output=True).stdout
        return json.loads(text)["tests"]

    def targets(self, pattern):
        """What has to be built for the tests of that name; nothing: there are none."""
        found = set()
        for test in self.tests(pattern):
            own = "test_" + test["name"]
            found.add(own if own in self.programs else "all")
        return ["all"] if "all" in found else sorted(found)

    def make(self, targets, limit=TOO_LONG):
        return self.run(["cmake", "--build", self.build, "-j", self.jobs, "--target"] + targets, limit)

    def test(self, pattern, *options, limit=TOO_LONG):
        return self.run(["ctest", "--test-dir", self.build, "-R", pattern, "-j", self.jobs,
                         "--output-on-failure", *options], limit)

    def failures(self):
        """The tests that failed, as the log of the last run lists them."""
        return re.findall(r"^\s*\d+ - (\S+) \(", open(self.log).read(), re.M)

    def first_failure(self):
        return (self.failures() or ["a test that did not end"])[0]
