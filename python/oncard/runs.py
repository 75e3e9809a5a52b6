"""Programs that are compiled, and runs of them in virtual time."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Union

from . import _oncard
from .errors import Diagnostic, Error, UnknownName, is_chinese, read_diagnostics
from .inputs import Files, Input, Path, Source, path_bytes, source_of, texts_of
from .pictures import GnuplotMissing, draw, table

if TYPE_CHECKING:
    import numpy
    import numpy.typing
    import pandas

    Column = numpy.typing.NDArray[numpy.float64]

Value = Union[int, float, list[Union[int, float]]]


class Program:
    """A program that has been compiled. It can be run and explored like a file."""

    def __init__(self, compiled: _oncard.Program, source: Source) -> None:
        self._compiled = compiled
        # The sources as they were compiled, whatever happens to the files later.
        self.source = Source(source.main, {**source.files, **compiled.sources()}, source.structured)

    @property
    def path(self) -> str:
        """The file of the source."""
        return os.fsdecode(self._compiled.path())

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """The warnings of the compiler."""
        return read_diagnostics(self._compiled.diagnostics())

    @property
    def bin(self) -> bytes:
        """The object file, as `oncard build` writes it."""
        return self._compiled.object()[0]

    @property
    def ini(self) -> bytes:
        """The file that belongs to the object file."""
        return self._compiled.object()[1]

    def write(self, folder: Path = ".") -> tuple[str, str]:
        """Writes both files into a folder, named after the source; their names."""
        bin_path, ini_path = self._compiled.write(path_bytes(folder))
        return os.fsdecode(bin_path), os.fsdecode(ini_path)

    def __repr__(self) -> str:
        return f"<oncard.Program {self.path}>"


def compile(main: Input, *, files: Files | None = None, structured: bool = False) -> Program:
    """Compiles a program (.c), or that of a scenario.

    `files` gives files by content; the others are read from the file system. Raises CompileError
    with the diagnostics if the program has mistakes, Error if a file cannot be read.
    """
    source = source_of(main, files, structured)
    return Program(_oncard.compile(source.main, source.files, source.structured), source)


@dataclass(frozen=True)
class Failure:
    """Why a run has failed."""

    expectation: str
    """As the scenario has it; empty for a fault, a deadlock or the time limit."""
    message: str

    def __str__(self) -> str:
        return f"{self.expectation}: {self.message}" if self.expectation else self.message


class Trace(Mapping[str, "Column"]):
    """Values over time: arrays by the names of the values, with `time_ms` for the instants.

    There is a row for each profile cycle in which anything changed.
    """

    def __init__(self, run: _oncard.Run) -> None:
        self._run = run
        self._columns: dict[str, Column] = run.trace()

    def __getitem__(self, name: str) -> Column:
        if name in self._columns:
            return self._columns[name]
        names = ", ".join(self._columns)
        raise UnknownName(
            f"the trace has no '{name}'; it has: {names}; run(..., trace=['{name}']) adds a value",
            f"轨迹中没有“{name}”；其中有：{names}；可用 run(..., trace=['{name}']) 记录",
        )

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def dataframe(self) -> pandas.DataFrame:
        """The columns for pandas."""
        try:
            import pandas
        except ImportError:
            raise Error(
                "dataframe() needs pandas: apt-get install python3-pandas",
                "dataframe() 需要 pandas：apt-get install python3-pandas",
            ) from None
        return pandas.DataFrame(self._columns)

    def write(self, path: Path) -> None:
        """Writes a file: .csv, .vcd, .json (Perfetto), or .gnuplot."""
        self._run.write_trace(path_bytes(path))

    def plot(self, path: Path) -> None:
        """Writes a picture of the trace, .svg or .png; needs gnuplot."""
        name = os.fsdecode(path_bytes(path))
        if not name.endswith((".svg", ".png")):
            raise Error(
                f"the name of a picture must end in .svg or .png, not '{name}'",
                f"图片文件名应以 .svg 或 .png 结尾，而不是“{name}”",
            )
        picture = draw(self._run.picture(path_bytes(path)))
        try:
            with open(path, "wb") as file:
                file.write(picture)
        except OSError as error:
            raise Error(
                f"cannot write '{name}': {error.strerror}", f"无法写入“{name}”：{error.strerror}"
            ) from None

    def _repr_svg_(self) -> str | None:
        try:
            return draw(self._run.picture(b"x.svg")).decode()
        except GnuplotMissing:
            return None  # a notebook then shows the text

    def __repr__(self) -> str:
        return f"<oncard.Trace of {', '.join(self._columns)}>"


class Run:
    """The result of a run."""

    def __init__(self, run: _oncard.Run, traced: bool) -> None:
        self._run = run
        self._traced = traced
        self._trace: Trace | None = None

    @property
    def result(self) -> dict[str, Any]:
        """All of it, as `oncard run --format=json` writes it."""
        result: dict[str, Any] = json.loads(self._run.json(is_chinese()))
        return result

    @property
    def passed(self) -> bool:
        """True if there are no failures."""
        return bool(self.result["passed"])

    @property
    def end(self) -> str:
        """How it ended: quiet, until, time-limit, deadlock, schedule-end, diverged."""
        return str(self.result["end"])

    @property
    def end_ms(self) -> float:
        """When it ended, in milliseconds of the card's time."""
        return float(self.result["time_ms"])

    @property
    def statements(self) -> int:
        """How many statements the threads have executed."""
        return int(self.result["statements"])

    @property
    def hash(self) -> str:
        """Of the whole card at the end: equal states have equal hashes."""
        return str(self.result["state_hash"])

    @property
    def values(self) -> dict[str, Value]:
        """Values at the end: those of `show`, without it all global variables."""
        return dict(self.result["values"])

    @property
    def threads(self) -> list[dict[str, Any]]:
        """How each thread ended."""
        return list(self.result["threads"])

    @property
    def failures(self) -> list[Failure]:
        """Why the run has failed."""
        return [Failure(item["expectation"], item["message"]) for item in self.result["failures"]]

    @property
    def warnings(self) -> list[str]:
        """What succeeded but cannot be meant."""
        return list(self.result["warnings"])

    @property
    def trace(self) -> Trace:
        """Values over time, if the run was given `trace`."""
        if not self._traced:
            raise Error(
                "the run has no trace: call run(..., trace=True)",
                "该运行没有轨迹：应调用 run(..., trace=True)",
            )
        if self._trace is None:
            try:
                self._trace = Trace(self._run)
            except ImportError:
                raise Error(
                    "traces need numpy: apt-get install python3-numpy",
                    "轨迹需要 numpy：apt-get install python3-numpy",
                ) from None
        return self._trace

    def dataframe(self) -> pandas.DataFrame:
        """The trace for pandas."""
        return self.trace.dataframe()

    def __repr__(self) -> str:
        return f"<oncard.Run {'passed' if self.passed else 'failed'} at {self.end_ms} ms>"

    def _repr_html_(self) -> str:
        failures = [("✗", failure) for failure in self.failures]
        return table(repr(self)[1:-1], [*failures, *self.values.items()])

    def _repr_svg_(self) -> str | None:
        return self.trace._repr_svg_() if self._traced else None


def run(
    main: Input,
    *,
    files: Files | None = None,
    structured: bool = False,
    show: Sequence[str] = (),
    trace: bool | Sequence[str] = False,
    strict_commands: bool = False,
    silent: Sequence[str] = (),
) -> Run:
    """Runs a program or a scenario in virtual time to its end, or replays a recording.

    `main` is a file (.c, .bin, .toml, .schedule), a scenario as a dict, or a Program. `show` names
    the values at the end; `trace` records values over time: those of the scenario, or those that
    it names. With `strict_commands`, refused commands are failures; `silent` leaves out warnings
    about the card by their names. A run that fails is a result, not an exception.
    """
    source = source_of(main, files, structured)
    columns = [] if isinstance(trace, bool) else texts_of("trace", trace)
    traced = trace is True or bool(columns)
    outcome = _oncard.run(
        source.main,
        source.files,
        source.structured,
        texts_of("show", show),
        traced,
        columns,
        strict_commands,
        texts_of("silent", silent),
    )
    return Run(outcome, traced)
