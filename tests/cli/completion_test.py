#!/usr/bin/python3
"""`planish completion`: what bash, zsh and fish make of it, each driven as it is by a person."""

import os
import pathlib
import pty
import re
import select
import shlex
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import help_tables
from planish_cli import CLI, CliTest, main

SECONDS = 60
CASES = [
    # What is typed, what is offered among others, what is not.
    ("", {"unfold", "connect", "studio", "manual"}, {"bracket.step", "--units"}),
    ("un", {"unfold"}, {"connect"}),
    ("unfold --units ", {"mm", "inch", "m"}, {"bracket.step", "--k"}),
    ("unfold --rel", {"--relief"}, {"--root"}),
    ("unfold --relief ", {"none", "rip", "square", "round"}, {"mm"}),
    ("unfold --root ", {"largest"}, {"FACE"}),
    ("unfold --format ", {"dxf", "svg", "step", "pdf"}, {"stl"}),
    ("batch --format ", {"dxf", "stl", "json"}, set()),
    ("unfold ", {"bracket.step", "OLD.STP", "shape.brep", "sent.step.gz", "folder/"}, {"plates.json", "table.csv"}),
    ("connect ", {"plates.json", "folder/"}, {"bracket.step"}),
    ("studio ", {"plates.json", "bracket.step"}, {"table.csv"}),
    ("unfold --k-table ", {"table.csv"}, {"bracket.step", "plates.json"}),
    ("unfold --json ", {"plates.json", "table.csv"}, set()),
    ("batch -o ", {"folder/"}, {"plates.json"}),
    ("batch --progress ", {"json"}, set()),
    ("schema ", {"plates", "report", "slits"}, {"bracket.step"}),
    ("completion ", {"bash", "zsh", "fish"}, set()),
    ("manual ", {"unfold", "completion"}, {"bracket.step"}),
    ("unfold --k ", set(), {"bracket.step", "mm"}),
    ("schema unfold --un", set(), {"--units"}),
]


class Terminal:
    """An interactive shell; what is typed is sent, what it shows is read until it is quiet."""

    def __init__(self, command, folder, environment):
        try:
            self.pid, self.fd = pty.fork()
        except OSError as error:  # /dev/pts is not mounted in some containers
            raise unittest.SkipTest(f"no pseudo-terminal: {error}") from None
        if self.pid == 0:
            os.chdir(folder)
            os.execvpe(command[0], command, environment)

    def type(self, text, wanted=()):
        """What is shown after `text`: until all that is wanted is there, and then until nothing more comes."""
        os.write(self.fd, text.encode())
        shown, until = "", time.monotonic() + SECONDS
        while time.monotonic() < until:
            if select.select([self.fd], [], [], 0.3)[0]:
                shown += os.read(self.fd, 65536).decode(errors="replace")
                shown = re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]|\x1b[=>]|\x07", "", shown)
            elif all(word in shown for word in wanted):
                break
        return shown

    def close(self):
        os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)
        os.close(self.fd)


class Completion(CliTest):
    def setUp(self):
        super().setUp()
        for name in ("bracket.step", "OLD.STP", "shape.brep", "sent.step.gz", "plates.json", "table.csv", "my part.step"):
            self.write(name, "")
        (self.dir / "folder").mkdir()
        scripts = tempfile.TemporaryDirectory(prefix="planish-shell-")
        self.addCleanup(scripts.cleanup)
        self.scripts = {shell: self.script(shell, scripts.name) for shell in ("bash", "zsh", "fish")}
        self.help = subprocess.run([CLI, "--help"], capture_output=True, text=True, check=True).stdout

    def script(self, shell, folder):
        path = pathlib.Path(folder) / f"planish.{shell}"
        path.write_bytes(subprocess.run([CLI, "completion", shell], capture_output=True, check=True).stdout)
        return path

    def run_shell(self, *command):
        done = subprocess.run(command, cwd=self.dir, capture_output=True, text=True, timeout=SECONDS, check=False)
        return done.stdout, done.stderr

    def bash(self, line):
        words = ["planish", *shlex.split(line)] + ([""] if not line or line[-1] == " " else [])
        # Outside of a completion compopt only complains.
        listed, _ = self.run_shell(
            "bash", "--norc", "-c", f'source {self.scripts["bash"]}; ' 'COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _planish 2>/dev/null; '
            'printf "%s\\n" "${COMPREPLY[@]}"', "bash", *words)
        return {word + "/" if (self.dir / word).is_dir() and word else word for word in listed.splitlines()}

    def fish(self, line):
        listed, complaints = self.run_shell("fish", "--no-config", "-c",
                                            f"source {self.scripts['fish']}; complete -C {shlex.quote('planish ' + line)}")
        self.assertEqual(complaints, "")
        return {word.split("\t")[0] for word in listed.splitlines()}

    def check(self, offered_by, cases=None):
        for line, some, none in cases or CASES:
            with self.subTest(line=line):
                offered = offered_by(line)
                self.assertEqual(some - offered, set(), f"not offered after {line!r}: {offered}")
                self.assertEqual(none & offered, set(), f"offered after {line!r}")

    def test_bash_offers_what_fits(self):
        self.check(self.bash)

    def test_fish_offers_what_fits(self):
        self.check(self.fish)

    def test_bash_and_fish_offer_every_command_and_option_of_the_help(self):
        commands = help_tables.commands(self.help)
        self.assertGreater(len(commands), 10)
        for offered_by in (self.bash, self.fish):
            self.assertEqual(set(commands) - offered_by(""), set())
            for command in commands:
                text = subprocess.run([CLI, command, "--help"], capture_output=True, text=True, check=True).stdout
                wanted = set(help_tables.options(text))
                offered = offered_by(f"{command} -")
                self.assertEqual({name for name in offered if name.startswith("-")} ^ wanted, set(), command)

    def test_bash_offers_each_format_once_and_takes_an_equals_sign(self):
        self.assertEqual(self.bash("unfold --format dxf,s"), {"dxf,svg", "dxf,step"})
        self.assertEqual(self.bash("unfold --units = i"), {"inch"})
        self.assertEqual(self.bash("unfold --units ="), {"mm", "inch", "m"})
        self.assertEqual(self.fish("unfold --format dxf,s"), {"dxf,svg", "dxf,step"})

    def test_bash_completes_as_it_is_typed(self):
        shell = Terminal(["bash", "--norc", "--noprofile", "-i"], self.dir, dict(os.environ, PS1="$ ", TERM="xterm"))
        try:
            shell.type(f"bind 'set bell-style none'; source {self.scripts['bash']}; echo read$((1))\n", ["read1"])
            shell.type("planish() { printf '<%s>' \"$@\"; echo; }; echo read$((2))\n", ["read2"])
            self.assertIn("complete -F _planish planish", shell.type("complete -p planish\n", ["complete -F"]))
            for typed, taken in (("unf\t--uni\ti\t", "<unfold><--units><inch>"), ("unfold my\t", "<unfold><my part.step>"),
                                 ("unfold fol\t", "<unfold><folder/>"), ("unfold --format dxf,s\tt\t", "<dxf,step>")):
                self.assertIn(taken, shell.type(f"planish {typed}\n", [taken]))
        finally:
            shell.close()

    def test_zsh_offers_what_fits(self):
        shell = Terminal(["zsh", "-f", "-i"], self.dir, dict(os.environ, PS1="$ ", TERM="xterm"))
        try:
            shell.type("stty columns 200 rows 500; autoload -U compinit; compinit -u -D; LISTMAX=9999; echo read$((1))\n",
                       ["read1"])
            shell.type(f"source {self.scripts['zsh']}; echo read$((2))\n", ["read2"])
            for line, some, none in CASES:
                with self.subTest(line=line):
                    shown = shell.type(f"planish {line}\t", some)
                    offered = set(re.findall(r"[^\s=]+", shown.replace("planish " + line, " ")))
                    if len(some) == 1:  # it is put into the line
                        offered |= {word for word in some if f"planish {line}".rsplit(" ", 1)[0] + " " + word in shown}
                    self.assertEqual(some - offered, set(), shown)
                    self.assertEqual(none & offered, set(), shown)
                    shell.type("\x03")  # Ctrl-C: a new line
        finally:
            shell.close()

    def test_another_shell_is_told_which_there_are(self):
        self.assertIn("there is no completion for \"ksh\"; there are bash, zsh and fish",
                      self.refused("completion", "ksh", status=2))


if __name__ == "__main__":
    missing = [shell for shell in ("bash", "zsh", "fish") if not shutil.which(shell)]
    if missing:
        raise SystemExit(f"missing: {missing}: tools/install-packages.sh test")
    main()
