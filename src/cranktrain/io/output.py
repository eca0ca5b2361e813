"""Writing a file whole or not at all."""

import errno
import os
import secrets
import stat
import sys
from collections.abc import Generator, Iterable
from contextlib import contextmanager, suppress
from pathlib import Path

from cranktrain.errors import InputError, Problem
from cranktrain.io.files import refusal
from cranktrain.language import N_
from cranktrain.language import said as _
from cranktrain.one_line import one_line

STANDARD_OUTPUT = ("-", "/dev/stdout")
_MACHINE_FILE = ".toml"

_FAILURES = {
    errno.ENOENT: (N_("the folder is not there"), N_("make it first, or name another")),
    errno.ENOTDIR: (N_("what should be its folder is a file"), N_("name another folder")),
    errno.EACCES: (N_("may not be written"), N_("choose a folder that is yours, or change the permissions")),
    errno.EPERM: (N_("may not be written"), N_("choose a folder that is yours, or change the permissions")),
    errno.EROFS: (N_("may not be written: this disk is read-only"), N_("choose another place")),
    errno.ENAMETOOLONG: (N_("the name is too long"), N_("choose a shorter one")),
    errno.ENOSPC: (N_("does not fit: the disk is full"), N_("make room, or choose another place")),
    errno.EDQUOT: (N_("does not fit: your share of the disk is full"), N_("make room, or choose another place")),
    errno.EFBIG: (N_("does not fit: it would be larger than files may be here"), N_("raise the limit (ulimit -f)")),
    errno.ELOOP: (N_("is a link that leads back to itself"), N_("choose another name")),
}


def write_machine_file(path: str, text: str, *, force: bool) -> None:
    """Write a machine file as `write_whole` does; refuse a name by which it would be taken for something else."""
    refuse_other_suffix(path)
    write_whole(path, text, force=force)


def refuse_other_suffix(path: str) -> None:
    """Refuse a name by which a machine file would be taken for something else."""
    stem, suffix = os.path.splitext(path)  # noqa: PTH122 - takes a NUL byte
    if suffix and suffix.lower() != _MACHINE_FILE and path not in STANDARD_OUTPUT:
        allowed = _("must end in {suffix}: it is a machine file", suffix=_MACHINE_FILE)
        repair = _('write "{text}"', text=one_line(stem + _MACHINE_FILE))
        raise InputError([Problem("-o", one_line(path), allowed, repair)])


def write_whole(path: "str | os.PathLike[str]", chunks: str | Iterable[str | bytes], *, force: bool) -> None:
    """Write a file that appears whole or not at all.

    Parameters
    ----------
    path : str or path-like
        `-` is the standard output; a device or pipe is written as it comes. A link is followed.
    chunks : str, or iterable of str or bytes
        The text, or the bytes of a picture; an exception raised in the middle, Ctrl-C too, leaves all as it was and
        passes on.
    force : bool
        Replace a file that is there; it keeps its mode.

    Raises
    ------
    InputError
        If a file is there and `force` is not given, or the file cannot be written; nothing has changed then.
    """
    pieces = (chunks,) if isinstance(chunks, str) else chunks
    if os.fspath(path) not in STANDARD_OUTPUT:
        _write_file(
            os.fspath(path), (piece.encode() if isinstance(piece, str) else piece for piece in pieces), force=force
        )
        return
    for piece in pieces:
        if isinstance(piece, str):
            sys.stdout.write(piece)
        else:
            sys.stdout.buffer.write(piece)
    sys.stdout.flush()


def look_first(path: "str | os.PathLike[str]", *, force: bool) -> None:
    """Refuse a file that `write_whole` would refuse, before anything is computed for it; parameters as of that."""
    name = os.fspath(path)
    if name not in STANDARD_OUTPUT:
        with _refusing(name):
            _target(name, force=force)


def look_into_folder(path: Path, name: str) -> None:
    """Refuse what cannot be made in its folder: that is not there, or may not be written; `name` as it is shown."""
    with _refusing(name):
        _stand(path.parent)


def _write_file(name: str, pieces: Iterable[bytes], *, force: bool) -> None:
    """Write what is not the standard output."""
    with _refusing(name):
        target, old = _target(name, force=force)
        if target is None:
            with Path(name).open("wb") as file:
                file.writelines(pieces)
        else:
            _write(target, pieces, None if old is None else stat.S_IMODE(old.st_mode))


@contextmanager
def _refusing(name: str) -> Generator[None]:
    """Say why a file cannot be written."""
    try:
        yield
    except FileExistsError:
        raise _already_there(name) from None
    except BrokenPipeError:  # its reader has had enough: no fault of the input
        raise
    except OSError as error:
        raise not_written(name, error) from None


def _target(name: str, *, force: bool) -> tuple[Path | None, os.stat_result | None]:
    """Which file is to be written, None of a device or pipe, and what is there; refuse what would fail."""
    old = None
    with suppress(FileNotFoundError):
        old = Path(name).stat()
    if old is not None and not stat.S_ISREG(old.st_mode) and not stat.S_ISDIR(old.st_mode):
        return None, old
    target = Path(os.path.realpath(name))
    _check(name, target, old, force=force)
    return target, old


def _stand(folder: Path) -> None:
    """Raise what making a file in a folder would."""
    folder.stat()
    if not os.access(folder, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))


def not_written(name: str, error: OSError) -> InputError:
    """Say why a file cannot be written, and what to do."""
    allowed, repair = _FAILURES.get(error.errno or 0, (N_("cannot be written: {reason}"), None))
    return refusal(name, _(allowed, reason=error.strerror), repair and _(repair))


def _check(name: str, target: Path, old: os.stat_result | None, *, force: bool) -> None:
    """Refuse what would fail, before the text is made."""
    if (old is not None and stat.S_ISDIR(old.st_mode)) or name.endswith(("/", os.sep)):
        raise refusal(name, _("is a folder"), _("name a file in it"))
    if old is None:
        _stand(target.parent)
    elif not force:
        raise _already_there(name)
    elif not old.st_mode & 0o222 or not os.access(target, os.W_OK):
        raise refusal(name, _("is read-only"), _("make it writable, or choose another name"))


def _write(target: Path, pieces: Iterable[bytes], mode: int | None) -> None:
    """Write beside the target and put the file in its place; over a file that is there if it has a mode to keep."""
    beside = target.with_name(f".cranktrain-{secrets.token_hex(8)}.tmp")
    try:
        with beside.open("xb") as file:
            if mode is not None:
                beside.chmod(mode)
            file.writelines(pieces)
            file.flush()
            os.fsync(file.fileno())
        if mode is not None:
            beside.replace(target)
        else:
            _place_new(beside, target)
    finally:
        beside.unlink(missing_ok=True)


def _place_new(beside: Path, target: Path) -> None:
    """Give the file its name, which nobody else may have taken meanwhile."""
    try:
        target.hardlink_to(beside)
    except FileExistsError:
        raise
    except OSError:  # a disk without hard links, such as FAT: an empty file holds the name for a moment
        target.touch(exist_ok=False)
        beside.replace(target)


def _already_there(name: str) -> InputError:
    return refusal(name, _("is there already"), _("choose another name, or replace it with --force"))
