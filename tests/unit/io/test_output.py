import errno
import os
import signal
import stat
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest
from tests.sentences import ALREADY_THERE, FOLDER_NOT_THERE

from cranktrain.errors import InputError
from cranktrain.io.output import write_whole

posix = pytest.mark.skipif(os.name != "posix", reason="POSIX only")


def refusal(*arguments, force=False):
    with pytest.raises(InputError) as caught:
        write_whole(*arguments, force=force)
    (problem,) = caught.value.problems
    return problem


def names(folder):
    return sorted(entry.name for entry in folder.iterdir())


class TestWritten:
    @pytest.mark.parametrize("chunks", ["φ\r\nb\n", ["φ\r\n", "", "b\n"], iter(["φ\r", "\nb\n"])])
    def test_new_file(self, tmp_path, chunks):
        write_whole(tmp_path / "out.csv", chunks, force=False)
        assert (tmp_path / "out.csv").read_bytes() == "φ\r\nb\n".encode()
        assert names(tmp_path) == ["out.csv"]

    def test_force_replaces(self, tmp_path):
        (tmp_path / "out.csv").write_text("old and longer")
        write_whole(str(tmp_path / "out.csv"), "new", force=True)
        assert (tmp_path / "out.csv").read_text() == "new"
        assert names(tmp_path) == ["out.csv"]

    def test_force_without_a_file(self, tmp_path):
        write_whole(tmp_path / "out.csv", "new", force=True)
        assert (tmp_path / "out.csv").read_text() == "new"

    def test_old_file_is_there_until_the_end(self, tmp_path):
        file = tmp_path / "out.csv"
        file.write_text("old")

        def pieces():
            yield "new"
            assert file.read_text() == "old"

        write_whole(file, pieces(), force=True)
        assert file.read_text() == "new"

    @posix
    def test_mode_of_a_new_file_follows_the_umask(self, tmp_path):
        before = os.umask(0o027)
        try:
            write_whole(tmp_path / "out.csv", "x", force=False)
        finally:
            os.umask(before)
        assert stat.S_IMODE((tmp_path / "out.csv").stat().st_mode) == 0o640

    @posix
    def test_mode_of_a_replaced_file_stays(self, tmp_path):
        (tmp_path / "out.csv").touch()
        (tmp_path / "out.csv").chmod(0o606)
        write_whole(tmp_path / "out.csv", "x", force=True)
        assert stat.S_IMODE((tmp_path / "out.csv").stat().st_mode) == 0o606

    @posix
    def test_link_is_followed(self, tmp_path):
        (tmp_path / "there").mkdir()
        (tmp_path / "link.csv").symlink_to(tmp_path / "there" / "out.csv")
        write_whole(tmp_path / "link.csv", "x", force=False)
        write_whole(tmp_path / "link.csv", "y", force=True)
        assert (tmp_path / "link.csv").is_symlink()
        assert (tmp_path / "there" / "out.csv").read_text() == "y"
        assert names(tmp_path / "there") == ["out.csv"]

    def test_name_as_long_as_may_be(self, tmp_path):
        write_whole(tmp_path / ("x" * 255), "x", force=False)
        assert names(tmp_path) == ["x" * 255]

    @pytest.mark.parametrize("name", ["-", "/dev/stdout"])
    def test_standard_output(self, capsys, name):
        write_whole(name, ["a\n", "b\n"], force=False)
        assert capsys.readouterr().out == "a\nb\n"

    @posix
    def test_device_is_written_as_it_comes(self):
        write_whole("/dev/null", "x", force=False)
        assert stat.S_ISCHR(Path("/dev/null").stat().st_mode)

    @posix
    def test_broken_pipe_passes_on(self, tmp_path):
        reading, writing = os.pipe()

        def pieces():
            yield "x"
            os.close(reading)
            yield "x" * 100_000

        try:
            with pytest.raises(BrokenPipeError):
                write_whole(f"/dev/fd/{writing}", pieces(), force=False)
        finally:
            os.close(writing)


class TestRefused:
    def test_file_is_there(self, tmp_path):
        (tmp_path / "out.csv").write_text("old")
        problem = refusal(tmp_path / "out.csv", (1 / 0 for _ in "x"))
        assert str(problem).endswith(f"out.csv  {ALREADY_THERE}, or replace it with --force")
        assert (tmp_path / "out.csv").read_text() == "old"

    def test_file_comes_meanwhile(self, tmp_path):
        def pieces():
            yield "new"
            (tmp_path / "out.csv").write_text("another's")

        assert refusal(tmp_path / "out.csv", pieces()).allowed == "is there already"
        assert (tmp_path / "out.csv").read_text() == "another's"
        assert names(tmp_path) == ["out.csv"]

    @pytest.mark.parametrize("comes", [False, True])
    def test_disk_without_hard_links(self, tmp_path, monkeypatch, comes):
        def no_links(*_arguments):
            if comes:
                (tmp_path / "out.csv").write_text("another's")
            raise PermissionError(errno.EPERM, os.strerror(errno.EPERM))

        monkeypatch.setattr(Path, "hardlink_to", no_links)
        if comes:
            assert refusal(tmp_path / "out.csv", "new").allowed == "is there already"
        else:
            write_whole(tmp_path / "out.csv", "new", force=False)
        assert (tmp_path / "out.csv").read_text() == ("another's" if comes else "new")
        assert names(tmp_path) == ["out.csv"]

    @pytest.mark.parametrize("force", [False, True])
    def test_folder(self, tmp_path, force):
        assert refusal(tmp_path, "x", force=force).allowed == "is a folder"
        assert refusal(f"{tmp_path}/new/", "x", force=force).allowed == "is a folder"
        assert names(tmp_path) == []

    def test_missing_folder(self, tmp_path):
        assert refusal(tmp_path / "no" / "out.csv", "x").allowed == FOLDER_NOT_THERE

    @posix
    def test_file_in_place_of_a_folder(self, tmp_path):
        (tmp_path / "no").touch()
        assert refusal(tmp_path / "no" / "out.csv", "x").allowed == "what should be its folder is a file"

    def test_name_too_long(self, tmp_path):
        assert refusal(tmp_path / ("x" * 256), (1 / 0 for _ in "x")).allowed == "the name is too long"

    @posix
    def test_link_to_itself(self, tmp_path):
        (tmp_path / "out.csv").symlink_to("out.csv")
        assert refusal(tmp_path / "out.csv", "x").allowed == "is a link that leads back to itself"

    def test_read_only_file(self, tmp_path):
        (tmp_path / "out.csv").touch()
        (tmp_path / "out.csv").chmod(0o444)
        assert refusal(tmp_path / "out.csv", "x", force=True).allowed == "is read-only"

    @pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write everywhere")
    def test_folder_forbids(self, tmp_path):
        tmp_path.chmod(0o555)
        assert refusal(tmp_path / "out.csv", "x").allowed == "may not be written"

    @pytest.mark.skipif(not Path("/dev/full").exists(), reason="no such device")
    def test_full_device(self):
        assert refusal("/dev/full", "x" * 100_000).allowed == "does not fit: the disk is full"


class TestFailureInTheMiddle:
    @pytest.mark.parametrize(
        ("number", "said"),
        [
            (errno.ENOSPC, "does not fit: the disk is full"),
            (errno.EDQUOT, "does not fit: your share of the disk is full"),
            (errno.EACCES, "may not be written"),
            (errno.EROFS, "may not be written: this disk is read-only"),
            (errno.EIO, f"cannot be written: {os.strerror(errno.EIO)}"),
        ],
    )
    @pytest.mark.parametrize("force", [False, True])
    def test_of_the_disk(self, tmp_path, monkeypatch, number, said, force):
        def fail(_descriptor):
            raise OSError(number, os.strerror(number))

        if force:
            (tmp_path / "out.csv").write_text("old")
        monkeypatch.setattr(os, "fsync", fail)
        assert refusal(tmp_path / "out.csv", "new", force=force).allowed == said
        assert [(name, (tmp_path / name).read_text()) for name in names(tmp_path)] == [("out.csv", "old")] * force

    @pytest.mark.parametrize("exception", [KeyboardInterrupt, ZeroDivisionError])
    @pytest.mark.parametrize("force", [False, True])
    def test_of_the_text(self, tmp_path, exception, force):
        (tmp_path / "old.csv").write_text("old")

        def pieces():
            yield "x" * 100_000
            raise exception

        with pytest.raises(exception):
            write_whole(tmp_path / ("old.csv" if force else "new.csv"), pieces(), force=force)
        assert names(tmp_path) == ["old.csv"]
        assert (tmp_path / "old.csv").read_text() == "old"

    @posix
    @pytest.mark.parametrize("size", [5_000, 5_000_000])
    def test_limit_of_file_size(self, tmp_path, size):
        (tmp_path / "old.csv").write_text("old")
        code = f"""
            import os, resource, sys
            from cranktrain.errors import InputError
            from cranktrain.io.output import write_whole
            os.chdir(sys.argv[1])
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
            for name, force in (("old.csv", True), ("new.csv", False)):
                try:
                    write_whole(name, ("x" * 100 for _ in range({size} // 100)), force=force)
                except InputError as error:
                    print(error)
        """
        command = [sys.executable, "-B", "-W", "error", "-c", textwrap.dedent(code), str(tmp_path)]
        shown = subprocess.run(command, capture_output=True, text=True, check=True)
        said = "does not fit: it would be larger than files may be here; raise the limit (ulimit -f)"
        assert (shown.stdout, shown.stderr) == (f"old.csv  {said}\nnew.csv  {said}\n", "")
        assert names(tmp_path) == ["old.csv"]
        assert (tmp_path / "old.csv").read_text() == "old"

    @posix
    def test_interrupt_from_the_terminal(self, tmp_path):
        code = """
            import signal, sys
            from cranktrain.io.output import write_whole
            signal.signal(signal.SIGINT, signal.default_int_handler)  # whatever these tests were started by
            def pieces():
                while True:
                    print("going", flush=True)
                    yield "x" * 1000
            write_whole(sys.argv[1], pieces(), force=False)
        """
        command = [sys.executable, "-c", textwrap.dedent(code), str(tmp_path / "out.csv")]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
            process.stdout.readline()
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=30)
        assert process.returncode == -signal.SIGINT
        assert names(tmp_path) == []
