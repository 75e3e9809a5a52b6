"""Explorations: is a program correct under every schedule of its threads?"""

from __future__ import annotations

import html
import json
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, SupportsIndex, Union

from . import _oncard
from .errors import Error, is_chinese
from .expressions import Requirements, condition_text, condition_texts
from .inputs import Files, Input, source_of, texts_of, whole_number

# Of `within`: a dict with `after`, `then` and `ms`, as in a scenario.
Response = Mapping[str, Any]


class Exploration:
    """What an exploration has found (docs/interleavings.md)."""

    def __init__(self, exploration: _oncard.Exploration) -> None:
        self._exploration = exploration

    @property
    def verdict(self) -> str:
        """PROVED, PASSED (within bounds), FAILED or INCOMPLETE."""
        return str(self.report["verdict"])

    @property
    def report(self) -> dict[str, Any]:
        """The counts and the failure, as `oncard explore --format=json` writes them."""
        report: dict[str, Any] = json.loads(self._exploration.json())
        return report

    @property
    def text(self) -> str:
        """The report for people: the verdict, its scope, and how a schedule fails."""
        return self._exploration.text(is_chinese(), False)

    @property
    def full_text(self) -> str:
        """The same with every statement of the failing run, and every pass of its loops."""
        return self._exploration.text(is_chinese(), True)

    @property
    def warnings(self) -> list[str]:
        """Commands that were refused, and requirements that nothing put to the test."""
        return self._exploration.warnings(is_chinese())

    @property
    def schedule(self) -> str | None:
        """The schedule that fails, as the text of a file for `oncard.run` and `oncard.Session`."""
        return self._exploration.schedule() or None

    @property
    def html(self) -> str:
        """The report as a page of its own."""
        return self._exploration.html(is_chinese())

    def __repr__(self) -> str:
        return f"<oncard.Exploration {self.verdict}>"

    def _repr_html_(self) -> str:
        # The page has styles of its own, which must not reach the notebook.
        page = html.escape(self.html, quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;height:30em;border:0"></iframe>'


def explore(
    main: Input,
    *,
    files: Files | None = None,
    structured: bool = False,
    final: Requirements = (),
    always: Requirements = (),
    never: Requirements = (),
    eventually: Requirements = (),
    leads: Requirements = (),
    within: Union[Response, Iterable[Response]] = (),
    races: str = "",
    engine: str = "",
    max_executions: SupportsIndex | None = None,
    max_states: SupportsIndex | None = None,
    runs: SupportsIndex | None = None,
    seed: SupportsIndex | None = None,
    depth: SupportsIndex | None = None,
    preemptions: SupportsIndex | None = None,
    merge_private: bool | None = None,
    dead_locals: bool | None = None,
    symmetry: bool | None = None,
    islands: bool | None = None,
    reductions: bool | None = None,
    all: bool = False,
    silent: Sequence[str] = (),
    seconds: float = 0,
    memory_mib: SupportsIndex = 0,
) -> Exploration:
    """Searches the schedules of a program or a scenario for one that fails.

    `final`, `always`, `never` and `eventually` are requirements in addition to those of the
    scenario, or of the program's comments: texts, or expressions such as `oncard.var("sum") < 100`.
    So are responses: `leads` has texts `p -> q`, `within` dicts `{"after": p, "then": q, "ms": 5}`.
    The other arguments are the options of `oncard explore`. The search ends after `seconds`, if
    given, or when the process occupies `memory_mib`, without it half of what is free; the verdict
    is then INCOMPLETE. Ctrl-C ends it, too.
    """
    source = source_of(main, files, structured)
    requirements = [
        (scope, text, "", 0.0)
        for scope, conditions in (
            ("final", final),
            ("always", always),
            ("never", never),
            ("eventually", eventually),
            ("leads", leads),
        )
        for text in condition_texts(conditions)
    ]
    requirements += [
        _response(response) for response in ([within] if isinstance(within, Mapping) else within)
    ]
    numbers = {
        name: whole_number(name, value)
        for name, value in (
            ("max_executions", max_executions),
            ("max_states", max_states),
            ("runs", runs),
            ("seed", seed),
            ("depth", depth),
            ("preemptions", preemptions),
        )
    }
    return Exploration(
        _oncard.explore(
            source.main,
            source.files,
            source.structured,
            requirements,
            engine,
            races,
            numbers,
            merge_private,
            dead_locals,
            symmetry,
            islands,
            reductions,
            all,
            texts_of("silent", silent),
            _limit("seconds", seconds, 1e9),
            int(_limit("memory_mib", whole_number("memory_mib", memory_mib), 2**30)),
        )
    )


def _response(response: Response) -> tuple[str, str, str, float]:
    """An element of `within`."""
    if not isinstance(response, Mapping) or set(response) != {"after", "then", "ms"}:
        raise Error(
            f"'within' has dicts such as {{'after': 'p', 'then': 'q', 'ms': 5}}, not {response!r}",
            f"“within”的元素应如 {{'after': 'p', 'then': 'q', 'ms': 5}}，而不是 {response!r}",
        )
    after, then = condition_text(response["after"]), condition_text(response["then"])
    return "within", after, then, _limit("ms", response["ms"], 1e9)


def _limit(name: str, value: object, most: float) -> float:
    """A limit of a search, 0 for none."""
    if isinstance(value, (int, float)) and not isinstance(value, bool) and 0 <= value <= most:
        return value
    raise Error(
        f"'{name}' must be a number from 0 to {most:g}, not {value!r}",
        f"“{name}”应为 0 到 {most:g} 的数，而不是 {value!r}",
    )
