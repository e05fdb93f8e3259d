#!/usr/bin/python3
"""The Debian packages: made, looked through by lintian, installed in a bare Debian 12 and used there.

The bare root is made by mmdebstrap from where this machine's apt gets its packages. It has no compiler and none of the
sources. Where it cannot be made the tests of it are skipped, and say why."""

import http.client
import io
import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tarfile
import tempfile
import unittest

CLI = pathlib.Path(os.environ.get("PLANISH_CLI", "planish"))
SOURCE = pathlib.Path(os.environ.get("PLANISH_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
EXAMPLES = "/usr/share/doc/planish/examples"
MINUTES = 60
ALL = ["planish", "libplanish1", "libplanish-dev", "python3-planish", "freecad-planish"]
HERE = pathlib.Path(__file__).parent


def run(*command, status=0, timeout=15 * MINUTES, **more):
    """Standard output of a program that ends as it should."""
    done = subprocess.run(list(map(str, command)), capture_output=True, timeout=timeout, check=False,
                          stdin=subprocess.DEVNULL, **more)
    if done.returncode != status:
        raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout.decode()[-4000:]}\n"
                             f"{done.stderr.decode()[-4000:]}")
    return done.stdout.decode(errors="replace")


def make(folder):
    """What was made, by the names of the packages, and what was said."""
    done = subprocess.run([SOURCE / "tools" / "make-packages.sh", folder], capture_output=True, text=True, check=False,
                          timeout=30 * MINUTES)
    if done.returncode != 0:
        raise AssertionError(done.stderr[-6000:])
    debs = [pathlib.Path(line) for line in done.stdout.splitlines()]
    return {deb.name.split("_")[0]: deb for deb in debs}, done.stderr


def packages_in(relations):
    """Names in a field of dependencies."""
    return {re.split(r"[ (:]", one.strip())[0] for one in re.split(r"[,|]", relations)} - {""}


def setUpModule():
    global DIR, DEBS, SAID
    folder = tempfile.TemporaryDirectory(prefix="planish-packages-")
    unittest.addModuleCleanup(folder.cleanup)
    DIR = pathlib.Path(folder.name)
    DEBS, SAID = make(DIR / "debs")


class Packages(unittest.TestCase):
    def setUp(self):
        self.dir, self.debs, self.said = DIR, DEBS, SAID

    def files(self, package):
        """Paths of a package, "/usr/bin/planish"."""
        lines = run("dpkg-deb", "--contents", self.debs[package]).splitlines()
        names = [re.split(r" \./", line, maxsplit=1)[1].split(" -> ")[0] for line in lines if " ./" in line]
        return {"/" + name for name in names if not name.endswith("/") and name}

    def unpacked(self, package):
        folder = self.dir / "unpacked" / package
        if not folder.exists():
            folder.mkdir(parents=True)
            run("dpkg-deb", "--extract", self.debs[package], folder)
        return folder

    def library(self):
        """The library and what programs are built with, as they lie when both are installed."""
        tree = self.dir / "library"
        if not tree.exists():
            for package in sorted({"libplanish1", "libplanish-dev"} & set(self.debs)):
                shutil.copytree(self.unpacked(package), tree, symlinks=True, dirs_exist_ok=True)
        return tree

    def field(self, package, name):
        return run("dpkg-deb", "--field", self.debs[package], name).strip()

    def depends(self, package):
        return packages_in(self.field(package, "Depends"))

    def test_each_package_is_made_or_said_to_be_left_out(self):
        self.assertLessEqual({"planish", "libplanish-dev"}, set(self.debs))
        left_out = set(re.findall(r"^(\S+) is left out", self.said, flags=re.M))
        self.assertEqual(set(ALL), set(self.debs) | left_out)
        self.assertEqual(set(self.debs) & left_out, set())
        if (SOURCE / "integrations" / "freecad" / "package.xml").exists():
            self.assertIn("freecad-planish", self.debs)

    def test_they_hold_what_they_should_and_nothing_twice(self):
        program = self.files("planish")
        self.assertLessEqual(
            {"/usr/bin/planish", "/usr/bin/planish-studio", "/usr/share/man/man1/planish.1.gz",
             "/usr/share/man/man1/planish-unfold.1.gz", "/usr/share/bash-completion/completions/planish",
             "/usr/share/zsh/vendor-completions/_planish", "/usr/share/fish/vendor_completions.d/planish.fish",
             "/usr/share/applications/planish-studio.desktop", "/usr/share/mime/packages/planish.xml",
             "/usr/share/icons/hicolor/scalable/apps/planish-studio.svg",
             "/usr/share/metainfo/org.planish.studio.metainfo.xml", "/usr/share/doc/planish/changelog.gz",
             "/usr/share/doc/planish/changelog.Debian.gz", "/usr/share/doc/planish/copyright",
             "/usr/share/doc/planish/docs/cli.md", f"{EXAMPLES}/bracket.step"}, program)
        headers = {"/usr/include/" + str(path.relative_to(SOURCE / "include"))
                   for path in (SOURCE / "include" / "planish").rglob("*.hpp")}
        self.assertLessEqual(headers, self.files("libplanish-dev"))
        self.assertRegex("\n".join(self.files("libplanish-dev")), r"/usr/lib/[\w-]+/cmake/planish/planishConfig\.cmake\n?")
        seen = {}
        for package in self.debs:
            for name in self.files(package):
                self.assertNotIn(name, seen, package)
                seen[name] = package
        self.assertEqual([name for name in seen if not name.startswith("/usr/")], [])

    def test_each_library_that_a_program_loads_is_depended_on(self):
        """By the sections of the programs, independently of dpkg-shlibdeps."""
        loaded = 0
        for package in self.debs:
            for name in self.files(package):
                path = self.unpacked(package) / name[1:]
                if path.is_symlink() or path.read_bytes()[:4] != b"\x7fELF":
                    continue
                for library in re.findall(r"NEEDED +(\S+)", run("objdump", "-p", path)):
                    if library.startswith("libplanish"):
                        continue
                    owners = {line.split(":")[0] for line in run("dpkg", "--search", f"*/{library}").splitlines()}
                    self.assertTrue(owners & self.depends(package), f"{name} loads {library} of {owners}")
                    loaded += 1
        self.assertGreater(loaded, 20)
        self.assertIn("libcairo2", self.depends("planish"))  # is loaded when a PDF is drawn

    def test_nothing_tells_where_it_was_built(self):
        for package in self.debs:
            for path in self.unpacked(package).rglob("*"):
                if path.is_file():
                    self.assertNotIn(os.fsencode(SOURCE) + b"/", path.read_bytes(), path)

    def test_lintian_finds_no_error_and_no_warning(self):
        said = run("lintian", "--fail-on", "error,warning", "--allow-root", *self.debs.values())
        self.assertNotRegex(said, r"(?m)^[EW]:")

    def test_the_same_commit_gives_the_same_bytes(self):
        again, _ = make(self.dir / "again")
        for package, deb in self.debs.items():
            self.assertEqual(deb.name, again[package].name)
            self.assertTrue(deb.read_bytes() == again[package].read_bytes(), f"{package} differs: diffoscope would say where")

    def test_all_files_have_the_time_of_the_commit(self):
        """A checkout elsewhere, or at another time, gives the same."""
        time = int(run("git", "-c", f"safe.directory={SOURCE}", "-C", SOURCE, "log", "-1", "--format=%ct"))
        for package, deb in self.debs.items():
            data = subprocess.run(["dpkg-deb", "--fsys-tarfile", deb], capture_output=True, check=True).stdout
            with tarfile.open(fileobj=io.BytesIO(data)) as files:
                self.assertEqual({member.mtime for member in files}, {time}, package)

    def test_the_copyright_names_what_is_embedded(self):
        """Licences of the page's libraries stand in it word for word."""
        text = (self.unpacked("planish") / "usr/share/doc/planish/copyright").read_text(encoding="utf-8")
        plain = " ".join(text.replace("\n .\n", "\n").split())
        modules = SOURCE / "web" / "node_modules"
        page = re.search(r'"dependencies": \{(.*?)\}', (SOURCE / "web" / "package.json").read_text(), flags=re.S)[1]
        libraries = re.findall(r'"([\w@/-]+)":', page)
        self.assertGreater(len(libraries), 1)
        for library in libraries:
            licence = (modules / library / "LICENSE").read_text(encoding="utf-8")
            holders = re.search(r"Copyright (?:©|\(c\)) (.*?)(?:\.? All rights reserved\.?)?\n", licence)[1]
            self.assertIn(f"Files: web/node_modules/{library}/* Copyright: {holders}", plain)
            # From the first words of the licence on, but for spaces and quotes.
            body = " ".join(licence[licence.index(holders):].split("\n\n", 1)[1].split())
            for sentence in body.split(". "):
                self.assertIn(sentence.split(") ")[-1][:200], plain, library)

    def test_programs_are_built_with_the_installed_library(self):
        """CMake finds the unpacked package, and what it links belongs to packages that it depends on."""
        prefix, build = self.library() / "usr", self.dir / "consumer"
        run("cmake", "-G", "Ninja", "-S", SOURCE / "tests" / "package", "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}")
        run("ninja", "-C", build)
        self.assertRegex(run(build / "consumer", SOURCE / "examples" / "bracket.step"), r"^flat: [\d.]+ x [\d.]+ mm\n$")
        command = run("ninja", "-C", build, "-t", "commands").splitlines()[-1]
        linked = set(re.findall(r"(?<= )/usr/lib/\S+", command))
        self.assertGreater(len(linked), 10)
        direct = self.depends("libplanish-dev") - {"libplanish1"}
        # Of a link that belongs to libX-dev CMake names the file, which belongs to libX.
        known = direct | packages_in(run("dpkg-query", "--show", "--showformat=${Depends},", *direct))
        for library in linked:
            self.assertIn(run("dpkg", "--search", library).split(":")[0], known, library)

    def test_pkg_config_finds_the_c_interface(self):
        found = [name for name in self.files("libplanish-dev") if name.endswith("/planish.pc")]
        if "libplanish1" not in self.debs:
            self.assertEqual(found, [])
            self.skipTest("there is no library with a C interface in these sources")
        # It may be anywhere: planish.pc says where from its own place.
        pc = self.library() / found[0][1:]
        flags = run("pkg-config", "--cflags", "--libs", "planish",
                    env=dict(os.environ, PKG_CONFIG_PATH=str(pc.parent))).split()
        program = self.dir / "c"
        program.with_suffix(".c").write_text("#include <planish/planish.h>\n#include <stdio.h>\n"
                                  "int main(void) { return puts(planish_version()) < 0; }\n")
        run("cc", program.with_suffix(".c"), "-o", program, *flags)
        self.assertEqual(run(program, env=dict(os.environ, LD_LIBRARY_PATH=str(pc.parents[1]))).strip(),
                         run(CLI, "--version").split()[-1])


class Root:
    """A bare Debian 12, in which commands are run."""

    def __init__(self, folder):
        self.path = folder / "root"
        checks = [f"--aptopt={line}" for line in run("apt-config", "dump", "Acquire::Check-Valid-Until",
                                                     "Acquire::Check-Date").splitlines()]
        sources = [path for path in [pathlib.Path("/etc/apt/sources.list"),
                                     *sorted(pathlib.Path("/etc/apt/sources.list.d").glob("*"))]
                   if path.exists() and path.suffix in (".list", ".sources") and "debian" in path.read_text()]
        # What is thrown away need not survive a power cut.
        run("mmdebstrap", "--variant=apt", "--skip=cleanup/apt/lists", "--dpkgopt=force-unsafe-io", *checks, "bookworm",
            self.path, *sources)
        for name in ("resolv.conf", "hosts"):
            shutil.copy(f"/etc/{name}", self.path / "etc" / name)
        self.run("useradd", "--uid", "1000", "--home-dir", "/tmp", "someone", user="0")

    def command(self, *words, user="1000"):
        """Runs with /proc and /dev of its own, which are gone with it."""
        inside = 'mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && exec chroot --userspec="$1" "$0" "${@:2}"'
        return ["unshare", "--mount", "--pid", "--fork", "--kill-child", "bash", "-c", inside, str(self.path),
                f"{user}:{user}", "env", "-i", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "HOME=/tmp", "LC_ALL=C.UTF-8",
                "DEBIAN_FRONTEND=noninteractive", *map(str, words)]

    def run(self, *words, user="1000", status=0):
        return run(*self.command(*words, user=user), status=status)

    def install(self, *what):
        self.run("apt-get", "install", "-y", "--no-install-recommends", *what, user="0")

    def files(self):
        """All files but what apt and dpkg note, and caches."""
        kept = ("/proc/", "/dev/", "/sys/", "/var/lib/dpkg/", "/var/lib/apt/", "/var/cache/", "/var/log/", "/tmp/", "/run/",
                "/debs/", "/etc/ld.so.cache")
        listed = run("find", self.path, "-xdev", "!", "-type", "d", "-printf", "/%P\\n").splitlines()
        return {name for name in listed if not name.startswith(kept)}


def why_no_root():
    if os.geteuid() != 0:
        return "not root"
    for program in ("mmdebstrap", "unshare", "chroot"):
        if not shutil.which(program):
            return f"{program} is missing"
    done = subprocess.run(["unshare", "--mount", "--pid", "--fork", "true"], capture_output=True, check=False)
    return "" if done.returncode == 0 else "namespaces cannot be made: " + done.stderr.decode().strip()


class InRoot(unittest.TestCase):
    """Tests in a bare root of their own, with the packages at hand."""

    @classmethod
    def setUpClass(cls):
        if why := why_no_root():
            raise unittest.SkipTest(f"no bare root: {why}")
        folder = tempfile.TemporaryDirectory(prefix="planish-root-")
        cls.addClassCleanup(folder.cleanup)
        cls.dir, cls.debs = DIR, DEBS
        try:
            cls.root = Root(pathlib.Path(folder.name))
        except AssertionError as error:
            raise unittest.SkipTest(f"no bare root: {error}") from None
        (cls.root.path / "debs").mkdir()
        for deb in cls.debs.values():
            shutil.copy(deb, cls.root.path / "debs")

    @classmethod
    def inside(cls, package):
        return f"/debs/{cls.debs[package].name}"


class InBareDebian(InRoot):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.root.install("man-db")
        cls.root.install(cls.inside("planish"))

    def work(self, name):
        """A folder in the root in which user 1000 may write, from inside and from outside."""
        folder = self.root.path / "tmp" / name
        folder.mkdir()
        os.chown(folder, 1000, 1000)
        return f"/tmp/{name}", folder

    def test_the_root_has_no_compiler_and_no_sources(self):
        for program in ("cc", "gcc", "c++", "make", "cmake", "npm"):
            self.root.run("sh", "-c", f"! command -v {program}")
        self.assertFalse((self.root.path / str(SOURCE)[1:] / "CMakeLists.txt").exists())

    def test_the_program_does_there_what_it_does_here(self):
        self.assertEqual(self.root.run("planish", "--version"), run(CLI, "--version"))
        inside, made = self.work("unfolded")
        here = self.dir / "here"
        here.mkdir()
        jobs = [("unfold", "bracket.step", "-o", "a.dxf", "-o", "a.svg", "-o", "a.step", "--json", "a.json"),
                ("connect", "connect/a_folded.json", "-o", "b.step", "--flat", "b.dxf", "-o", "b.stl"),
                ("transition", "transition/a_square_to_round.json", "--flat", "c.dxf")]
        for command, example, *outputs in jobs:
            self.root.run("sh", "-c", f"cd {inside} && planish {command} {EXAMPLES}/{example} -q {' '.join(outputs)}")
            run(CLI, command, self.root.path / EXAMPLES[1:] / example, "-q", *outputs, cwd=here)
        for path in sorted(here.iterdir()):
            there = (made / path.name).read_bytes().replace(EXAMPLES.encode(), b"")
            self.assertEqual(path.read_bytes().replace(str(self.root.path / EXAMPLES[1:]).encode(), b""), there, path.name)
        self.assertEqual(len(list(here.iterdir())), 8)

    def test_pages_can_be_drawn(self):
        inside, made = self.work("pages")
        self.root.run("planish", "unfold", f"{EXAMPLES}/bracket.step", "-o", f"{inside}/a.pdf")
        page = (made / "a.pdf").read_bytes()
        self.assertTrue(page.startswith(b"%PDF-"))
        self.assertIn(b"DejaVu", page)  # a font is there

    def test_the_studio_answers(self):
        process = subprocess.Popen(self.root.command("planish", "studio", "--no-browser", f"{EXAMPLES}/bracket.step"),
                                   stdout=subprocess.PIPE, text=True, stdin=subprocess.DEVNULL, start_new_session=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        # unshare ignores SIGTERM, and what it runs outlives it, since it has become another user's.
        self.addCleanup(os.killpg, process.pid, signal.SIGKILL)
        port, token = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/#(\w+)\n", process.stdout.readline()).groups()

        def ask(method, path, body=None):
            connection = http.client.HTTPConnection("127.0.0.1", int(port), timeout=MINUTES)
            self.addCleanup(connection.close)
            connection.request(method, path, body, {"X-Planish-Token": token})
            answer = connection.getresponse()
            return answer.status, answer.read()
        self.assertIn(b"<script", ask("GET", "/")[1])
        self.assertIn(b'"name":"bracket.step"', ask("GET", "/api/documents")[1].replace(b" ", b""))
        status, drawn = ask("POST", "/api/documents/d1/files/dxf", "{}")
        self.assertEqual((status, drawn[-4:].strip()), (200, b"EOF"))

    def test_the_manual_can_be_read(self):
        for page, words in (("planish", "planish - lay sheet metal flat"), ("planish-unfold", "--k-table FILE.csv"),
                            ("planish-studio", "--end-after SECONDS")):
            self.assertIn(words, self.root.run("sh", "-c", f"MANPAGER=cat man {page}"))

    def test_bash_completes(self):
        said = self.root.run("bash", "-c", "source /usr/share/bash-completion/completions/planish && complete -p planish && "
                             "COMP_WORDS=(planish unfold --units i) COMP_CWORD=3 && _planish; echo ${COMPREPLY[@]}")
        self.assertEqual(said, "complete -F _planish planish\ninch\n")

    def test_purging_leaves_nothing(self):
        self.root.run("dpkg", "--purge", "--force-depends", "planish", user="0")
        purged = self.root.files()
        self.assertEqual([name for name in purged if "planish" in name], [])
        self.root.run("dpkg", "--install", self.inside("planish"), user="0")
        installed = self.root.files()
        owned = set(self.root.run("dpkg", "--listfiles", "planish").splitlines())
        # The databases of types and entries are made by other packages, where they are installed.
        self.assertEqual(installed - purged - owned, set())
        self.root.run("dpkg", "--purge", "--force-depends", "planish", user="0")
        self.assertEqual(self.root.files(), purged)
        self.root.run("dpkg", "--install", self.inside("planish"), user="0")

    def test_what_the_others_depend_on_can_be_had(self):
        said = self.root.run("apt-get", "install", "--simulate", "--no-install-recommends", *map(self.inside, self.debs),
                             user="0")
        for package in self.debs:  # or it is there already
            self.assertRegex(said, rf"(?m)^Inst {package} |^{package} is already the newest version")

    def test_python_has_the_module(self):
        if "python3-planish" not in self.debs:
            self.skipTest("there is no Python module in these sources")
        self.root.install(self.inside("python3-planish"))
        area = self.root.run("/usr/bin/python3", "-c", "import planish\n"
                             f"print(planish.unfold('{EXAMPLES}/bracket.step').flat.area)")
        inside, made = self.work("python")
        self.root.run("planish", "unfold", f"{EXAMPLES}/bracket.step", "-q", "--check", "--json", f"{inside}/a.json")
        self.assertEqual(float(area), json.loads((made / "a.json").read_text())["flat"]["area"])


class OthersInBareDebian(InRoot):
    """Apart from the program: FreeCAD brings a compiler."""

    def test_freecad_has_the_workbench(self):
        self.root.install(*(self.inside(package) for package in ("planish", "python3-planish", "freecad-planish")))
        script = self.root.path / "tmp" / "unfold.py"
        script.write_text((HERE / "freecad_unfold.py").read_text())
        said = self.root.run("freecadcmd", "/tmp/unfold.py")
        area = float(re.search(r"flat area ([\d.]+) K 0.5", said)[1])
        # 40 and 30 mm outside, of which each loses its outer radius; the bend has its middle radius.
        self.assertAlmostEqual(area, 60 * (40 - 4 + 30 - 4 + math.pi / 2 * 3), delta=1e-6 * area)

    def test_the_c_library_answers(self):
        if "libplanish1" not in self.debs:
            self.skipTest("there is no library with a C interface in these sources")
        self.root.install("python3-minimal", self.inside("libplanish1"))
        said = self.root.run("python3", "-c", "import ctypes; library = ctypes.CDLL('libplanish.so.1'); "
                             "library.planish_version.restype = ctypes.c_char_p; print(library.planish_version().decode())")
        self.assertEqual(said.strip(), run(CLI, "--version").split()[-1])


if __name__ == "__main__":
    missing = [name for name in ("lintian", "objdump", "dpkg-deb") if not shutil.which(name)]
    if missing:
        sys.exit(f"missing: {', '.join(missing)}: tools/install-packages.sh test")
    unittest.main(verbosity=2)
