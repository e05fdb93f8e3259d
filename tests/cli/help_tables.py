"""What the program's help says of its commands and options, read as a person reads it."""

import re


def commands(help_text):
    """Names of the commands in `planish --help`."""
    part = help_text.split("\nSubcommands:\n")[1].split("\n\n")[0]
    return re.findall(r"^  (\S+)", part, flags=re.M)


def options(help_text):
    """{"--units": "mm|inch|m", "-q": ""}: every name of every option of a command's help, with what stands for its
    value."""
    found = {}
    # A value follows its option after one blank, a description after several or on the next line.
    for names, value in re.findall(r"^  (-\S+)(?: (\S+))?(?: .*)?$", help_text.split("\nExamples:")[0], flags=re.M):
        for name in names.split(","):
            found[name] = value
    return found
