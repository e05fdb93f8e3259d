"""The package `planish`, or how to get it."""

import sys

from . import preferences

HOW = ("The Python package planish is missing. On Debian: sudo apt install ./python3-planish_*.deb. Elsewhere, name the folder "
       "that holds it in Edit > Preferences > Planish, or in the environment variable PLANISH_PYTHON_FOLDER; it is one for "
       "Python {version}. ({why})")


class Refusal(ValueError):
    """What cannot be taken: one sentence, and a word for scripts. What planish refuses raises its own errors."""

    def __init__(self, code, message, where=""):
        super().__init__(message)
        self.code, self.message, self.where = code, message, where


class Missing(Refusal, ImportError):
    """There is no package planish."""


def planish():
    """The package: installed, or in the folder of the preferences or of the environment."""
    folder = preferences.folder()
    if folder and folder not in sys.path:
        sys.path.append(folder)
    try:
        import planish as package
    except ImportError as failure:
        version = ".".join(map(str, sys.version_info[:2]))
        raise Missing("no_planish", HOW.format(version=version, why=failure)) from failure
    return package


def sentence(error):
    """What an error says, without its code."""
    return getattr(error, "message", "") or str(error) or type(error).__name__
