"""Files as they are on the disk: their bytes, or why they cannot be read."""

import difflib
import errno
import os
import stat
from pathlib import Path

from cranktrain.errors import InputError, Position, Problem
from cranktrain.language import said as _


def content_of(
    path: Path, name: str, largest: int, *, suffix: str, too_large: str, folder: str, says_where: bool = False
) -> bytes:
    """Read the bytes of a file that is not too large.

    Parameters
    ----------
    path : Path
    name : str
        As shown in messages.
    largest : int
        So many bytes at most.
    suffix : str
        Of the files that may have been meant, where a folder or no file is named.
    too_large, folder : str
        What is said of a larger file, and of a folder.
    says_where : bool
        Whether to say in which folder it is not, where `name` is relative to another folder than the user's.

    Returns
    -------
    bytes

    Raises
    ------
    InputError
        If there is no such file, or it cannot be read.
    """
    try:
        about = path.stat()
        if stat.S_ISDIR(about.st_mode):
            raise refusal(name, folder, _first_file(path, suffix))
        if about.st_size > largest:
            raise refusal(name, too_large)
        if stat.S_ISFIFO(about.st_mode):
            content = _piped(path, name, largest + 1)
        else:
            with path.open("rb") as file:
                content = file.read(largest + 1)  # a device does not tell its size
    except OSError as error:
        raise _unreadable(path, name, error, suffix=suffix, says_where=says_where) from None
    except InputError:
        raise
    except ValueError:  # a NUL or half a character in the name
        raise refusal(name, _("is no name that a file can have")) from None
    if len(content) > largest:
        raise refusal(name, too_large)
    return content


def _piped(path: Path, name: str, most: int) -> bytes:
    """Read from a pipe; refuse one into which nobody writes, for which one would wait without end."""
    with os.fdopen(os.open(path, os.O_RDONLY | os.O_NONBLOCK), "rb", buffering=0) as pipe:
        content = pipe.read(most)  # None where somebody has it open and has not written yet
        if content == b"":
            raise refusal(name, _("is a pipe into which nobody writes"))
        os.set_blocking(pipe.fileno(), True)
        content = content or b""
        while len(content) < most and (more := pipe.read(most - len(content))):
            content += more
    return content


def refusal(name: str, allowed: str, repair: str | None = None, position: Position | None = None) -> InputError:
    """Give the error that says what is wrong with a file itself.

    Parameters
    ----------
    name : str
        As shown in messages.
    allowed : str
    repair : str, optional
    position : Position, optional
        Where in the file; the file alone unless given.

    Returns
    -------
    InputError
    """
    return InputError([Problem("", None, allowed, repair, position or Position(name))])


def _unreadable(path: Path, name: str, error: OSError, *, suffix: str, says_where: bool) -> InputError:
    """Say why a file could not be read."""
    if error.errno == errno.ENOENT:
        if not path.parent.is_dir():
            return refusal(name, _("there is no folder {folder}", folder=path.parent))
        return refusal(name, _("there is no such file"), _meant(path, suffix, says_where=says_where))
    if error.errno in (errno.EACCES, errno.EPERM):
        return refusal(name, _("may not be read"), _("change its permissions (or its folder's), or copy it"))
    return refusal(name, _("cannot be read: {reason}", reason=error.strerror))


def _meant(path: Path, suffix: str, *, says_where: bool) -> str | None:
    """Say which file may have been meant, one of its kind with nearly its name, and where it was looked for."""
    kinds = {path.suffix.casefold(), suffix}
    beside = [name for name in _files(path.parent) if Path(name).suffix.casefold() in kinds]
    near = next(iter(difflib.get_close_matches(path.name, beside, n=1)), None)
    if not says_where:
        return _("is it {name}?", name=near) if near else None
    said = _("is it {name}? It was looked for in {folder}") if near else _("it was looked for in {folder}")
    return said.format(name=near, folder=path.parent.resolve())


def _files(folder: Path) -> list[str]:
    """Name the files of a folder as far as it lets itself be read."""
    try:
        return sorted(entry.name for entry in folder.iterdir())
    except OSError:
        return []


def _first_file(folder: Path, suffix: str) -> str | None:
    """Say which file of a folder may have been meant."""
    first = next((name for name in _files(folder) if name.endswith(suffix)), None)
    return _("name a file in it, such as {name}", name=folder / first) if first else None
