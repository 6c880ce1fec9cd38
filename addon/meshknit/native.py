"""The only importer of the compiled module. It is imported when first needed, so that the add-on
registers without it and updates on Windows do not find it locked."""

import importlib

HOW_TO_BUILD = "The compiled part of meshknit is missing: run `make build` in its source folder"


class NativeMissing(Exception):
    """The compiled module is not there, or not for this Python. The text says what to do."""


def load():
    """The module `_native`. Throws NativeMissing."""
    try:
        return importlib.import_module("._native", __package__)
    except ImportError as error:
        raise NativeMissing(f"{HOW_TO_BUILD} ({error})") from error


def why_missing():
    """None if the module can be used, else a sentence for people."""
    try:
        load()
    except NativeMissing as error:
        return str(error)
    return None
